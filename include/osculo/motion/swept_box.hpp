#pragma once

#include "osculo/geometry/box.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::motion {

namespace detail {

/// Around x, x + way and, of a parabola, the corner of its tangents, x + first_half.
template <math::Scalar S>
void sweep(const S& x, const S& first_half, const S& way, S& low, S& high) {
    low = x + std::min<S>(std::min<S>(first_half, way), S(0));
    high = x + std::max<S>(std::max<S>(first_half, way), S(0));
}

/// Grown by the rounding of a box whose terms add up to [terms].
template <math::Scalar S>
[[nodiscard]] geometry::Box<S> with_blur(const geometry::Box<S>& box, const S& terms) {
    if (!math::is_finite<S>(terms)) return geometry::Box<S>::everything();
    return box.grown(S(math::kRejectionSlack) * math::epsilon<S>() * terms);
}

}  // namespace detail

/// A box that the centre does not leave for `until` [s] >= 0, on the safe side of rounding.
template <math::Scalar S>
[[nodiscard]] geometry::Box<S> swept_box(const LinearPath<S>& path, const S& until) {
    const math::Vec<S> start = path.position.rounded();
    geometry::Box<S> box = geometry::Box<S>::around(start, start);
    if (!math::is_finite<S>(until)) {
        if (path.velocity.x() < S(0)) box.low_x = -math::never<S>();
        if (path.velocity.x() > S(0)) box.high_x = math::never<S>();
        if (path.velocity.y() < S(0)) box.low_y = -math::never<S>();
        if (path.velocity.y() > S(0)) box.high_y = math::never<S>();
        return detail::with_blur<S>(box, math::norm1<S>(start));
    }
    const math::Vec<S> way = until * path.velocity;
    detail::sweep<S>(start.x(), way.x(), way.x(), box.low_x, box.high_x);
    detail::sweep<S>(start.y(), way.y(), way.y(), box.low_y, box.high_y);
    return detail::with_blur<S>(box, math::norm1<S>(start) + math::norm1<S>(way));
}

/// The same until the path ends at the latest: a parabola lies between its ends and the corner of
/// its tangents there.
template <math::Scalar S>
[[nodiscard]] geometry::Box<S> swept_box(const ParabolicPath<S>& path, const S& until) {
    const S t = std::min<S>(until, path.end);
    if (!math::is_finite<S>(t)) {  // no acceleration
        return swept_box<S>(LinearPath<S>{path.position, path.velocity}, t);
    }
    const math::Vec<S> start = path.position.rounded();
    const math::Vec<S> straight = t * path.velocity;
    const math::Vec<S> curved = (t * t) * path.half_acceleration;
    geometry::Box<S> box;
    detail::sweep<S>(start.x(), straight.x() / S(2), straight.x() + curved.x(), box.low_x,
                     box.high_x);
    detail::sweep<S>(start.y(), straight.y() / S(2), straight.y() + curved.y(), box.low_y,
                     box.high_y);
    return detail::with_blur<S>(
        box, math::norm1<S>(start) + math::norm1<S>(straight) + math::norm1<S>(curved));
}

}  // namespace osculo::motion

#pragma once

#include "osculo/detect/ball_segment.hpp"
#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/segment.hpp"

/// Whether a ball touches an obstacle where it is: its boundary is within [tolerance] of it, or
/// overlaps it by rounding.
namespace osculo::detect {

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Point<S>& point, const S& tolerance) {
    return math::norm<S>(math::difference<S>(position, point.at)) <= radius + tolerance;
}

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Segment<S>& segment, const S& tolerance) {
    const math::WidePoint<S> wide_c = math::wide_difference<S>(position, segment.from);
    const math::Vec<S> c = wide_c.rounded();
    const S foot = math::dot<S>(c, segment.tangent);
    if (foot < S(0) || segment.length < foot) return false;
    math::Vec<S> normal = segment.normal;
    if (math::dot<S>(c, normal) < S(0)) {
        if (segment.one_sided) return false;
        normal = -normal;
    }
    return math::narrow(detail::line_gap<S>(wide_c, normal, radius)) <= tolerance;
}

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Arc<S>& arc, const S& tolerance) {
    const math::Vec<S> c = math::difference<S>(position, arc.center);
    return math::abs<S>(math::norm<S>(c) - arc.radius) <= radius + tolerance && arc.covers(c);
}

}  // namespace osculo::detect

#pragma once

#include "osculo/geometry/segment.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

namespace detail {

/// c.n - r. For the built-in types the sign is exact and the error far below one ulp. c is wide
/// because walls are long: rounding it would cost epsilon times its part along the wall.
template <math::Scalar S>
[[nodiscard]] math::Wide<S> line_gap(const math::WidePoint<S>& c, const math::Vec<S>& n,
                                     const S& r) {
    using Wide = math::Wide<S>;
    const Wide x = c.x * Wide(n.x());
    const Wide y = c.y * Wide(n.y());
    const Wide gap = x + y - r;
    if constexpr (math::Builtin<S>) {
        if (math::cancelled<S>(gap, math::abs<S>(x.hi) < math::abs<S>(y.hi) ? y : x)) {
            math::ExactSum<S, 9> sum;
            sum.add_product(c.x.lo, n.x());
            sum.add_product(c.y.lo, n.y());
            sum.add_product(c.x.hi, n.x());
            sum.add_product(c.y.hi, n.y());
            sum.add(-r);
            return sum.value();
        }
    }
    return gap;
}

}  // namespace detail

/// First contact of a ball in uniform motion with the straight part of a segment, or never():
/// distance to the line = r while approaching, with the foot of the perpendicular between the ends
/// (the ends themselves are points of their own). A ball behind a one-sided segment passes.
///
/// t = ((x - from).n - r) / (-v.n). For double and long double correct to 1 ulp for the stored,
/// rounded normal.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& path, const S& radius,
                              const geometry::Segment<S>& segment,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const math::WidePoint<S> wide_c = math::wide_difference<S>(path.position, segment.from);
    const math::Vec<S> c = wide_c.rounded();
    math::Vec<S> normal = segment.normal;
    const S slack = S(math::kRejectionSlack) * math::epsilon<S>();
    // Most are told apart without exact arithmetic.
    const S speed = math::dot<S>(path.velocity, normal);
    const S speed_blur = slack * (math::norm1<S>(path.velocity) * math::norm1<S>(normal));
    const S distance = math::dot<S>(c, normal);
    const S distance_blur = slack * (math::norm1<S>(c) * math::norm1<S>(normal));
    if (segment.one_sided && (speed > speed_blur || distance < -distance_blur)) {
        return math::never<S>();
    }
    if (math::abs<S>(speed) > speed_blur && math::abs<S>(distance) > distance_blur &&
        (speed > S(0)) == (distance > S(0))) {
        return math::never<S>();  // away
    }
    const S least_gap = math::abs<S>(distance) - distance_blur - radius;
    const S most_speed = math::abs<S>(speed) + speed_blur;
    if (!history.just_resolved && least_gap > most_speed * horizon * (S(1) + slack)) {
        return math::never<S>();
    }

    S normal_speed = math::accurate_dot<S>(path.velocity, normal);
    const S side = math::accurate_dot<S>(c, normal);
    if (side < S(0)) {
        if (segment.one_sided) return math::never<S>();
        normal = -normal;
        normal_speed = -normal_speed;
    }
    if (!(normal_speed < S(0))) return math::never<S>();

    const math::Wide<S> wide_gap = detail::line_gap<S>(wide_c, normal, radius);
    const S gap = math::narrow(wide_gap);
    if (gap > -normal_speed * horizon * (S(1) + slack)) return math::never<S>();
    // Touching, an approach that is mere rounding counts when it has become noticeable.
    const S noticeable = S(math::kTouch) * math::epsilon<S>() * radius;
    const bool mere_rounding =
        history.just_resolved || (-normal_speed <= history.noise && gap <= noticeable);
    S t(0);
    if (mere_rounding) {
        t = noticeable / -normal_speed;
    } else if (gap > S(0)) {
        t = math::quotient(wide_gap, math::Wide<S>(-math::wide_dot<S>(path.velocity, normal)));
    }
    const S foot =
        math::dot<S>(c, segment.tangent) + math::dot<S>(path.velocity, segment.tangent) * t;
    return foot >= S(0) && foot <= segment.length ? t : math::never<S>();
}

/// From the ball towards the segment's line, any length.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_normal(const math::WidePoint<S>& position,
                                          const geometry::Segment<S>& segment) {
    const math::Vec<S> c = math::difference<S>(position, segment.from);
    return math::accurate_dot<S>(c, segment.normal) < S(0) ? segment.normal
                                                           : math::Vec<S>(-segment.normal);
}

}  // namespace osculo::detect

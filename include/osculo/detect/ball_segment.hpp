#pragma once

#include "osculo/geometry/segment.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

/// First contact of a ball in uniform motion with the straight part of a segment, or never():
/// distance to the line = r while approaching, with the foot of the perpendicular between the ends
/// (the ends themselves are points of their own). A ball behind a one-sided segment passes.
///
/// t = ((x - from).n - r) / (-v.n). Error <= 2 ulp for the stored, rounded normal. One division.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& path, const S& radius,
                              const geometry::Segment<S>& segment,
                              const math::ContactHistory<S>& history, const S& horizon) {
    S normal_speed = math::accurate_dot<S>(path.velocity, segment.normal);
    if (segment.one_sided ? !(normal_speed < S(0)) : normal_speed == S(0)) return math::never<S>();

    const math::Vec<S> c = math::difference<S>(path.position, segment.from);
    math::Wide<S> distance = math::wide_dot<S>(c, segment.normal);
    if (distance < math::Wide<S>(S(0))) {
        if (segment.one_sided) return math::never<S>();
        distance = -distance;
        normal_speed = -normal_speed;
    }
    if (!(normal_speed < S(0))) return math::never<S>();

    const S gap = math::narrow(math::Wide<S>(distance - radius));
    if (gap > -normal_speed * horizon * (S(1) + math::epsilon<S>() * S(math::kRejectionSlack))) {
        return math::never<S>();
    }
    // Touching, an approach that is mere rounding counts when it has become noticeable.
    const S noticeable = S(math::kTouch) * math::epsilon<S>() * radius;
    const bool mere_rounding =
        history.just_resolved || (-normal_speed <= history.noise && gap <= noticeable);
    const S t = mere_rounding ? S(noticeable / -normal_speed)
                              : (gap > S(0) ? S(gap / -normal_speed) : S(0));
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

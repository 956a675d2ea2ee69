#pragma once

#include "osculo/geometry/point.hpp"
#include "osculo/math/first_root_parabolic.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

/// First contact of a ball in uniform motion with a point, |x - p| = r while approaching, or
/// never().
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& path, const S& radius,
                              const geometry::Point<S>& point,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return math::first_entry<S>(math::difference<S>(path.position, point.at), path.velocity, radius,
                                history, horizon);
}

/// The same for a ball with constant acceleration, until its path ends.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ParabolicPath<S>& path, const S& radius,
                              const geometry::Point<S>& point,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return math::first_entry<S>(
        math::ParabolicApproach<S>{math::difference<S>(path.position, point.at), path.velocity,
                                   path.half_acceleration, radius},
        path.end, history, horizon);
}

/// From the ball towards the point, any length.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_normal(const math::WidePoint<S>& position,
                                          const geometry::Point<S>& point) {
    return -math::difference<S>(position, point.at);
}

}  // namespace osculo::detect

#pragma once

#include "osculo/geometry/rim.hpp"
#include "osculo/math/first_root_parabolic.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

/// When the centre of a ball in uniform motion enters the rim's circle, or never().
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& path, const S& /*radius*/,
                              const geometry::Rim<S>& rim, const math::ContactHistory<S>& history,
                              const S& horizon) {
    return math::first_entry<S>(math::difference<S>(path.position, rim.center), path.velocity,
                                rim.radius, history, horizon);
}

/// The same for a ball with constant acceleration, until its path ends.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ParabolicPath<S>& path, const S& /*radius*/,
                              const geometry::Rim<S>& rim, const math::ContactHistory<S>& history,
                              const S& horizon) {
    return math::first_entry<S>(
        math::ParabolicApproach<S>{math::difference<S>(path.position, rim.center), path.velocity,
                                   path.half_acceleration, rim.radius},
        path.end, history, horizon);
}

/// From the ball towards the rim's centre, any length.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_normal(const math::WidePoint<S>& position,
                                          const geometry::Rim<S>& rim) {
    return -math::difference<S>(position, rim.center);
}

}  // namespace osculo::detect

#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::motion {

/// Half the acceleration of a ball that slows down at [deceleration] along its velocity [m/s^2],
/// for its speed > 0, however small.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> half_deceleration(const math::Vec<S>& velocity, const S& speed,
                                             const S& deceleration) {
    const S share = -deceleration / (S(2) * speed);
    if (math::is_finite<S>(share)) return velocity * share;
    return (velocity / speed) * (deceleration / S(-2));
}

}  // namespace osculo::motion

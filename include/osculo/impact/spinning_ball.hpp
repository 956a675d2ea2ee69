#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::impact {

/// What an impact law with friction sees and changes of a ball.
template <math::Scalar S>
struct SpinningBall {
    S mass;                 ///< [kg]
    S radius;               ///< [m]
    S inertia;              ///< k = I / (m r^2): 2/5 for a solid sphere, 1/2 for a disk
    math::Vec<S> velocity;  ///< [m/s]
    math::Vec3<S> spin;     ///< [rad/s]
};

}  // namespace osculo::impact

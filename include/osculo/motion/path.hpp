#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::motion {

/// Straight uniform motion: at position + velocity t, t [s] counted from the path's own start.
template <math::Scalar S>
struct LinearPath {
    math::WidePoint<S> position;  ///< [m]
    math::Vec<S> velocity;        ///< [m/s]
};

}  // namespace osculo::motion

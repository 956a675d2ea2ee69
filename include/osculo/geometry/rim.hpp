#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::geometry {

/// The edge of a hole.
template <math::Scalar S>
struct Rim {
    math::Vec<S> center;  ///< [m]
    S radius;             ///< [m], > 0
};

}  // namespace osculo::geometry

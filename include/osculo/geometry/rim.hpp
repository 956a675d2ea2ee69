#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::geometry {

/// The edge of a hole.
template <math::Scalar S>
struct Rim {
    math::Vec<S> center;  ///< [m]
    S radius;             ///< [m], > 0
};

/// The edge of a hole that pulls balls whose centre is inside of it (motion/rim_paper.hpp).
template <math::Scalar S>
struct PullingRim : Rim<S> {};

}  // namespace osculo::geometry

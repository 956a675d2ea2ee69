#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::geometry {

/// A point that balls bounce off: the end of a segment or arc.
template <math::Scalar S>
struct Point {
    math::Vec<S> at;  ///< [m]
};

}  // namespace osculo::geometry

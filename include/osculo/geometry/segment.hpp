#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::geometry {

/// A straight cushion without its end points. Directions are unit vectors to rounding.
template <math::Scalar S>
struct Segment {
    math::Vec<S> from;     ///< [m]
    math::Vec<S> tangent;  ///< from `from` to the other end
    math::Vec<S> normal;   ///< tangent turned left
    S length;              ///< [m]
    bool one_sided;        ///< only balls on the side of the normal are stopped

    Segment(const math::Vec<S>& a, const math::Vec<S>& b, bool left_only)
        : from(a), one_sided(left_only) {
        const math::Vec<S> along = b - a;
        length = math::norm<S>(along);
        tangent = along / length;
        normal = {-tangent.y(), tangent.x()};
    }
};

}  // namespace osculo::geometry

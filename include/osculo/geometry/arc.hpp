#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::geometry {

/// A circular cushion without its end points, counter-clockwise from `start` to `end`.
template <math::Scalar S>
struct Arc {
    math::Vec<S> center;  ///< [m]
    S radius;             ///< [m], > 0
    math::Vec<S> start;   ///< unit vector from the centre to the first end point
    math::Vec<S> end;     ///< unit vector from the centre to the last end point
    bool reflex;          ///< sweeps more than half a turn
    bool full;            ///< sweeps a full turn: no end points

    /// Whether the direction of [d] (from the centre, any length > 0) lies within the arc's angles.
    /// By orientation alone: no angle is computed.
    [[nodiscard]] bool covers(const math::Vec<S>& d) const {
        if (full) return true;
        const bool after_start = math::accurate_cross<S>(start, d) >= S(0);
        const bool before_end = math::accurate_cross<S>(d, end) >= S(0);
        return reflex ? after_start || before_end : after_start && before_end;
    }

    [[nodiscard]] math::Vec<S> start_point() const { return center + radius * start; }
    [[nodiscard]] math::Vec<S> end_point() const { return center + radius * end; }
};

}  // namespace osculo::geometry

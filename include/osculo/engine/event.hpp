#pragma once

#include <cstdint>

#include "osculo/math/instant.hpp"

namespace osculo::engine {

using BallIndex = std::uint32_t;

/// What a scheduled event is. Its order is the order of events at one instant.
/// Obstacles follow: kFirstObstacle + the place of their kind in the scene type's list.
using Kind = std::uint32_t;
inline constexpr Kind kNothing = 0;       ///< the ball has no event ahead
inline constexpr Kind kTransition = 1;    ///< the ball's motion enters its next phase
inline constexpr Kind kCellCrossing = 2;  ///< bookkeeping of the broad phase: changes no ball
inline constexpr Kind kBallBall = 3;
inline constexpr Kind kFirstObstacle = 4;

/// A predicted event. Events are totally ordered by (when, kind, first, second), which does not
/// depend on the order of prediction.
template <math::Scalar S>
struct Event {
    math::Instant<S> when{math::never<S>()};
    Kind kind = kNothing;
    BallIndex first = 0;           ///< a ball; of two the one with the lower index
    std::uint32_t second = 0;      ///< a ball or the index of an obstacle of that kind
    std::uint32_t first_age = 0;   ///< number of events of the balls when this was predicted:
    std::uint32_t second_age = 0;  ///< if one has had another since, this event is void

    friend bool operator<(const Event& a, const Event& b) {
        if (a.when < b.when) return true;
        if (b.when < a.when) return false;
        if (a.kind != b.kind) return a.kind < b.kind;
        if (a.first != b.first) return a.first < b.first;
        return a.second < b.second;
    }
};

}  // namespace osculo::engine

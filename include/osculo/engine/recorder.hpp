#pragma once

#include <array>
#include <vector>

#include "osculo/engine/event.hpp"
#include "osculo/math/vec.hpp"

namespace osculo::engine {

/// A ball's place and velocity at an event.
template <math::Scalar S>
struct Moment {
    math::WidePoint<S> position;
    math::Vec<S> velocity;
};

/// An event as it happened.
template <math::Scalar S>
struct EventRecord {
    math::Instant<S> when;
    Kind kind;
    BallIndex first;
    std::uint32_t second;
    math::Vec<S> normal;  ///< from `first` towards the other, any length
    std::array<Moment<S>, 2> before;
    std::array<Moment<S>, 2> after;
};

/// One stretch of one ball's motion.
template <math::Scalar S>
struct PieceRecord {
    BallIndex ball;
    math::Instant<S> from;
    math::Instant<S> to;
    math::WidePoint<S> position;  ///< at `from`
    math::Vec<S> velocity;
};

/// Keeps nothing.
template <math::Scalar S>
struct NoRecorder {
    static constexpr const char* kName = "none";
    static constexpr bool kEvents = false;
    static constexpr bool kPieces = false;
};

/// Keeps the events.
template <math::Scalar S>
struct EventRecorder {
    static constexpr const char* kName = "events";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = false;
    std::vector<EventRecord<S>> events;
};

/// Keeps the events and every ball's pieces, in order of their ends.
template <math::Scalar S>
struct PieceRecorder {
    static constexpr const char* kName = "pieces";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = true;
    std::vector<EventRecord<S>> events;
    std::vector<PieceRecord<S>> pieces;
};

}  // namespace osculo::engine

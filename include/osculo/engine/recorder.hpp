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

/// Which cluster a contact belongs to.
struct ClusterMark {
    /// Contacts resolved together have the same number, from 1 on; 0: resolved by itself. They
    /// follow each other, and what each of them does by itself means nothing: only their sum does.
    std::uint32_t number : 31 = 0;
    /// Of a cluster: false if another law or order gives another outcome.
    bool well_posed : 1 = true;
};

/// An event as it happened. [Memory]: what is kept of a ball.
template <math::Scalar S, class Memory = Moment<S>>
struct EventRecord {
    math::Instant<S> when;
    Kind kind;
    BallIndex first;
    std::uint32_t second;
    ClusterMark cluster;
    math::Vec<S> normal;  ///< from `first` towards the other, any length
    std::array<Memory, 2> before;
    std::array<Memory, 2> after;
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
    void clear() {}
};

/// Keeps the events.
template <math::Scalar S>
struct EventRecorder {
    static constexpr const char* kName = "events";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = false;
    std::vector<EventRecord<S>> events;

    void clear() { events.clear(); }
    template <class State>
    [[nodiscard]] static Moment<S> remember(const State& state) {
        return {state.position, state.velocity};
    }
};

/// Keeps what met and when, but no states: enough to count what came of a run.
template <math::Scalar S>
struct ContactRecorder {
    static constexpr const char* kName = "contacts";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = false;
    struct NoState {};
    std::vector<EventRecord<S, NoState>> events;

    void clear() { events.clear(); }
    template <class State>
    [[nodiscard]] static NoState remember(const State&) {
        return {};
    }
};

/// Keeps the events and every ball's pieces, in order of their ends.
template <math::Scalar S>
struct PieceRecorder {
    static constexpr const char* kName = "pieces";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = true;
    std::vector<EventRecord<S>> events;
    std::vector<PieceRecord<S>> pieces;

    void clear() {
        events.clear();
        pieces.clear();
    }
    template <class State>
    [[nodiscard]] static Moment<S> remember(const State& state) {
        return {state.position, state.velocity};
    }
    template <class State>
    void add_piece(BallIndex ball, const math::Instant<S>& from, const math::Instant<S>& to,
                   const State& state) {
        pieces.push_back({ball, from, to, state.position, state.velocity});
    }
};

/// One stretch of one ball's motion, with all that its motion law knows of it at `from`.
template <math::Scalar S, class State>
struct StatePieceRecord {
    BallIndex ball;
    math::Instant<S> from;
    math::Instant<S> to;
    State state;
};

/// Keeps the events and pieces of a motion law with more to it than place and velocity. Without
/// [Pieces], only the events.
template <math::Scalar S, class State, bool Pieces>
struct StateRecorder {
    static constexpr const char* kName = Pieces ? "pieces" : "events";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = Pieces;
    std::vector<EventRecord<S, State>> events;
    std::vector<StatePieceRecord<S, State>> pieces;

    void clear() {
        events.clear();
        pieces.clear();
    }
    [[nodiscard]] static State remember(const State& state) { return state; }
    void add_piece(BallIndex ball, const math::Instant<S>& from, const math::Instant<S>& to,
                   const State& state) {
        pieces.push_back({ball, from, to, state});
    }
};

}  // namespace osculo::engine

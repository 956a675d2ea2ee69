#pragma once

#include <concepts>

#include "osculo/engine/audit/motion_laws.hpp"

/// What the audit knows of all balls that may be in a rim, whatever moves them there: a state's
/// `stay`, which tells the place at a time in it, and `since`, that time.
namespace osculo::engine {

template <class State, class S>
concept StayingState = std::derived_from<State, motion::Rolling::State<S>> &&
    requires(const State& state) {
    { state.stay->most_speed() } -> std::convertible_to<S>;
    { state.since } -> std::convertible_to<S>;
};

template <math::Scalar S, StayingState<S> State>
[[nodiscard]] StatePieceRecord<S, motion::Rolling::State<S>> outside_rims(
    const StatePieceRecord<S, State>& piece) {
    return {piece.ball, piece.from, piece.to, piece.state};
}

template <math::Scalar S, StayingState<S> State>
[[nodiscard]] S path_length(const StatePieceRecord<S, State>& piece) {
    if (!piece.state.stay) return path_length(outside_rims<S>(piece));
    return math::duration<S>(piece.from, piece.to) * piece.state.stay->most_speed() +
           piece.state.stay->rim().radius;
}

/// The parabola that touches a stay at `start`; of others, the piece.
template <math::Scalar S, StayingState<S> State>
[[nodiscard]] RelativeParabola<S> stretch(const StatePieceRecord<S, State>& piece,
                                          const math::Instant<S>& start,
                                          const math::Instant<S>& end,
                                          const math::Vec<S>& origin = math::Vec<S>(S(0), S(0))) {
    if (!piece.state.stay) return stretch(outside_rims<S>(piece), start, end, origin);
    const auto now =
        piece.state.stay->at(S(piece.state.since + math::duration<S>(piece.from, start)));
    return {seen_from(now.position, origin), math::WidePoint<S>(now.velocity),
            math::WidePoint<S>(now.half_acceleration), end - start};
}
/// How far the piece may be from that parabola [m].
template <math::Scalar S, StayingState<S> State>
[[nodiscard]] S deviation(const StatePieceRecord<S, State>& piece, const math::Instant<S>& start,
                          const math::Instant<S>& end) {
    if (!piece.state.stay) return S(0);
    const S t = piece.state.since + math::duration<S>(piece.from, start);
    const S h = math::duration<S>(start, end);
    return h > S(0) ? S(piece.state.stay->jerk_bound(t, h) * h * h * h / S(6)) : S(0);
}

template <math::Scalar S, StayingState<S> State>
[[nodiscard]] State end_of(const StatePieceRecord<S, State>& piece) {
    State end = piece.state;
    const S t = math::duration<S>(piece.from, piece.to);
    if (end.stay) {
        end.since = end.since + t;
        end.follow();
    } else {
        static_cast<motion::Rolling::State<S>&>(end) = end_of(outside_rims<S>(piece));
    }
    return end;
}

}  // namespace osculo::engine

#pragma once

#include "osculo/engine/audit/smallest_gap_parabolic.hpp"
#include "osculo/engine/engine.hpp"
#include "osculo/math/error_bounds.hpp"

/// Pieces and events as the audit reads them, and the bounds it holds them to.
namespace osculo::engine {

template <class Type>
using PieceOf = typename decltype(Type::Recorder::pieces)::value_type;
template <class Type>
using EventOf = typename decltype(Type::Recorder::events)::value_type;
/// What events keep of a ball.
template <class Type>
using MemoryOf = typename decltype(EventOf<Type>::before)::value_type;

/// What a piece knows of its ball at its beginning.
template <math::Scalar S>
[[nodiscard]] Moment<S> beginning(const PieceRecord<S>& piece) {
    return {piece.position, piece.velocity};
}
template <math::Scalar S, class State>
[[nodiscard]] const State& beginning(const StatePieceRecord<S, State>& piece) {
    return piece.state;
}

/// At least the length of the way.
template <math::Scalar S>
[[nodiscard]] S path_length(const PieceRecord<S>& piece) {
    return math::norm<S>(piece.velocity) * math::duration<S>(piece.from, piece.to);
}
template <math::Scalar S, class State>
[[nodiscard]] S path_length(const StatePieceRecord<S, State>& piece) {
    const S t = math::duration<S>(piece.from, piece.to);
    return t *
           (math::norm<S>(piece.state.velocity) + t * math::norm<S>(piece.state.half_acceleration));
}

/// Where the piece is at an instant, in wide precision.
template <math::Scalar S>
[[nodiscard]] math::WidePoint<S> position_at(const PieceRecord<S>& piece,
                                             const math::Instant<S>& when) {
    const math::Wide<S> t = when - piece.from;
    return {piece.position.x + math::Wide<S>(piece.velocity.x()) * t,
            piece.position.y + math::Wide<S>(piece.velocity.y()) * t};
}

/// The piece from an instant until another one, in wide precision, as seen from [origin].
template <math::Scalar S>
[[nodiscard]] RelativePath<S> stretch(const PieceRecord<S>& piece, const math::Instant<S>& start,
                                      const math::Instant<S>& end,
                                      const math::Vec<S>& origin = math::Vec<S>(S(0), S(0))) {
    return {seen_from(position_at(piece, start), origin), math::WidePoint<S>(piece.velocity),
            end - start};
}
template <math::Scalar S, class State>
[[nodiscard]] RelativeParabola<S> stretch(const StatePieceRecord<S, State>& piece,
                                          const math::Instant<S>& start,
                                          const math::Instant<S>& end,
                                          const math::Vec<S>& origin = math::Vec<S>(S(0), S(0))) {
    const State& state = piece.state;
    RelativeParabola<S> path{seen_from(state.position, origin), math::WidePoint<S>(state.velocity),
                             math::WidePoint<S>(state.half_acceleration), end - start};
    const math::Wide<S> before = start - piece.from;
    path.start = path.at(before);
    path.velocity = path.velocity_at(before);
    return path;
}

/// a as it is seen from b, both from the same instant on for the same time.
template <math::Scalar S>
[[nodiscard]] RelativePath<S> seen_from(const RelativePath<S>& a, const RelativePath<S>& b) {
    return {seen_from<S>(a.start, b.start), seen_from<S>(a.velocity, b.velocity), a.time};
}
template <math::Scalar S>
[[nodiscard]] RelativeParabola<S> seen_from(const RelativeParabola<S>& a,
                                            const RelativeParabola<S>& b) {
    return {seen_from<S>(a.start, b.start), seen_from<S>(a.velocity, b.velocity),
            seen_from<S>(a.half_acceleration, b.half_acceleration), a.time};
}

/// How far off a contact distance may be: see math::kContactGap.
template <math::Scalar S>
[[nodiscard]] S gap_bound(const S& reach, const S& path) {
    return S(math::kContactGap) * math::epsilon<S>() * (reach + path);
}

/// What the rounding of wide places and instants leaves unresolved; [from] is what the place is
/// measured from.
template <math::Scalar S>
[[nodiscard]] S resolution(const math::WidePoint<S>& position, const S& speed,
                           const math::Instant<S>& when,
                           const math::Vec<S>& from = math::Vec<S>(S(0), S(0))) {
    return S(math::kContactGap) * math::wide_epsilon<S>() *
               (math::norm1<S>(position.rounded()) + math::norm1<S>(from) +
                speed * math::abs<S>(math::narrow(when))) +
           S(math::kUnderflow);
}

/// What rounding may take of velocity and radius * spin [m/s] where numbers end.
template <math::Scalar S, class State>
[[nodiscard]] S underflow(const State& state) {
    S largest(1);
    if constexpr (requires { state.radius; }) largest = std::max<S>(largest, state.radius);
    return S(math::kUnderflow) * largest;
}

/// Calls f with the obstacle of that kind and index.
template <class Type, class F>
void with_obstacle(const SceneData<Type>& scene, Kind kind, std::uint32_t index, F&& f) {
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        ((kind == kFirstObstacle + K ? f(std::get<K>(scene.obstacles)[index]) : void()), ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
}

/// Whether events of that kind have that effect on a ball.
template <class Type>
[[nodiscard]] bool has_effect(Kind kind, Effect effect) {
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
        return (
            (kind == kFirstObstacle + K &&
             kEffect<
                 typename std::tuple_element_t<K, typename Type::ObstacleStorage>::value_type> ==
                 effect) ||
            ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
}

/// Whether an event takes the ball away.
template <class Type>
[[nodiscard]] bool captures(const EventOf<Type>& event) {
    if constexpr (kHasRims<typename Type::Motion>) {
        if (event.kind == kTransition) return event.after[0].fallen;
    }
    return has_effect<Type>(event.kind, Effect::capture);
}

}  // namespace osculo::engine

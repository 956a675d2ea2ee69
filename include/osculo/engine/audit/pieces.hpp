#pragma once

#include "osculo/engine/engine.hpp"
#include "osculo/math/error_bounds.hpp"

/// Pieces and events as the audit reads them, and the bounds it holds them to.
namespace osculo::engine {

template <math::Scalar S>
[[nodiscard]] S path_length(const PieceRecord<S>& piece) {
    return math::norm<S>(piece.velocity) * math::duration<S>(piece.from, piece.to);
}

/// Where the piece is at an instant, in wide precision.
template <math::Scalar S>
[[nodiscard]] math::WidePoint<S> position_at(const PieceRecord<S>& piece,
                                             const math::Instant<S>& when) {
    const math::Wide<S> t = when - piece.from;
    return {piece.position.x + math::Wide<S>(piece.velocity.x()) * t,
            piece.position.y + math::Wide<S>(piece.velocity.y()) * t};
}

/// How far off a contact distance may be: see math::kContactGap.
template <math::Scalar S>
[[nodiscard]] S gap_bound(const S& reach, const S& path) {
    return S(math::kContactGap) * math::epsilon<S>() * (reach + path);
}

/// What the rounding of wide places and instants leaves unresolved; [from] is what the place is
/// measured from.
template <math::Scalar S>
[[nodiscard]] S resolution(const math::WidePoint<S>& position, const math::Vec<S>& velocity,
                           const math::Instant<S>& when,
                           const math::Vec<S>& from = math::Vec<S>(S(0), S(0))) {
    return S(math::kContactGap) * math::wide_epsilon<S>() *
           (math::norm1<S>(position.rounded()) + math::norm1<S>(from) +
            math::norm1<S>(velocity) * math::abs<S>(math::narrow(when)));
}

/// Calls f with the obstacle of that kind and index.
template <class Type, class F>
void with_obstacle(const SceneData<Type>& scene, Kind kind, std::uint32_t index, F&& f) {
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        ((kind == kFirstObstacle + K ? f(std::get<K>(scene.obstacles)[index]) : void()), ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
}

/// Whether events of that kind take the ball away.
template <class Type>
[[nodiscard]] bool event_captures(Kind kind) {
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
        return (
            (kind == kFirstObstacle + K &&
             kEffect<
                 typename std::tuple_element_t<K, typename Type::ObstacleStorage>::value_type> ==
                 Effect::capture) ||
            ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
}

}  // namespace osculo::engine

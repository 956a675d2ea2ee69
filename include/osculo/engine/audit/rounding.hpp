#pragma once

#include <algorithm>
#include <vector>

#include "osculo/engine/audit/contact.hpp"

namespace osculo::engine {

/// What the rounding of a ball's place has to do with its way, over the run [m]: gap_bound() of
/// that is how far things may overlap.
///
/// - The length of its way. Elastic contacts part, and what rounding left of a gap ends with them:
///   the longest piece counts. Inelastic ones may stay together, and then it adds up.
/// - The resolution of places at the speed and instant of a piece, which a slower piece keeps.
/// - What touches and closes in at less than the rounding of its speed meets again when it is
///   nearer by math::kTouch epsilon of its reach, however near it is: each contact that has come
///   about so counts its reach.
template <class Type>
[[nodiscard]] std::vector<typename Type::Scalar> rounding_paths(
    const SceneData<Type>& scene, const typename Type::Recorder& record) {
    using S = typename Type::Scalar;
    static_assert(math::kTouch == math::kContactGap);
    const bool elastic = !Type::Motion::kTransitions && scene.ball_ball_restitution == S(1) &&
                         scene.ball_cushion_restitution == S(1);
    std::vector<S> path(scene.bodies.size(), S(0));
    std::vector<S> unresolved(scene.bodies.size(), S(0));
    for (const PieceOf<Type>& piece : record.pieces) {
        const S length = path_length(piece);
        S& known = path[piece.ball];
        known = elastic ? std::max<S>(known, length) : S(known + length);
        const S speed = math::norm1<S>(beginning(piece).velocity);
        S& least = unresolved[piece.ball];
        least = std::max<S>(least, speed * math::abs<S>(math::narrow(piece.to)));
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        path[i] = path[i] + unresolved[i] * (math::wide_epsilon<S>() / math::epsilon<S>());
    }
    for (const EventOf<Type>& event : record.events) {
        if (event.kind == kTransition) continue;
        const ContactOf<S> contact = contact_of<Type>(scene, event);
        if (contact.gap > S(math::kTouch) * math::epsilon<S>() * contact.reach / S(-2)) continue;
        path[event.first] = path[event.first] + contact.reach;
    }
    return path;
}

}  // namespace osculo::engine

#pragma once

#include <algorithm>

#include "osculo/engine/audit/pieces.hpp"
#include "osculo/engine/audit/smallest_gap.hpp"

namespace osculo::engine {

/// Where the things of an event are when it happens.
template <math::Scalar S>
struct ContactOf {
    S gap;              ///< between their boundaries [m]
    S reach;            ///< of both together [m]
    S smaller;          ///< radius [m]
    math::Vec<S> from;  ///< what places are measured from
};

template <class Type>
[[nodiscard]] ContactOf<typename Type::Scalar> contact_of(const SceneData<Type>& scene,
                                                          const EventOf<Type>& event) {
    using S = typename Type::Scalar;
    const S& radius = scene.bodies[event.first].radius;
    ContactOf<S> contact{S(0), radius, radius, math::Vec<S>(S(0), S(0))};
    if (event.kind == kBallBall) {
        const S& other = scene.bodies[event.second].radius;
        contact.gap =
            length_beyond<S>(seen_from(event.before[0].position, event.before[1].position),
                             math::wide_sum<S>(radius, other));
        contact.reach = radius + other;
        contact.smaller = std::min<S>(radius, other);
    } else {
        with_obstacle<Type>(scene, event.kind, event.second, [&](const auto& obstacle) {
            contact.from = origin(obstacle);
            contact.gap =
                contact_gap(seen_from(event.before[0].position, contact.from), radius, obstacle);
            contact.reach = radius + contact_reach(obstacle);
        });
    }
    return contact;
}

}  // namespace osculo::engine

#pragma once

#include "osculo/impact/spinning_ball.hpp"
#include "osculo/math/vec.hpp"

/// Balls that are pressed against something.
///
/// A ball that a force keeps pressing against another thing (its own spin on the cloth, another
/// ball's slowing down) bounces ever lower, infinitely often in finite time. Real balls touch for
/// 0.2 to 0.3 ms; what happens within a time tau of that order has no meaning for impacts without
/// duration. So an impact of things that accelerate towards each other at a leaves them with a
/// separation speed of at least a tau / 2: they meet again after tau at the earliest (after the
/// contact time of Luding & McNamara 1998; NUMERICS 5). Nothing overlaps; the hops are at most
/// a tau^2 / 8 high; there are at most 1 / tau of them per second; and an impact can gain at most
/// m a^2 tau^2 / 8 of energy (m the reduced mass), less than what the force does in one hop.
namespace osculo::impact {

/// By how much a separation speed along [normal] (a unit vector) has to be raised, for a relative
/// velocity and half relative acceleration of what lies there [m/s].
template <math::Scalar S>
[[nodiscard]] S missing_separation(const math::Vec<S>& velocity,
                                   const math::Vec<S>& half_acceleration,
                                   const math::Vec<S>& normal, const S& contact_time) {
    const S least = -math::dot<S>(half_acceleration, normal) * contact_time;
    const S speed = math::dot<S>(velocity, normal);
    return least > S(0) && speed < least ? S(least - speed) : S(0);
}

/// A ball of the engine, as laws with friction take it, and back.
template <math::Scalar S, class Body>
[[nodiscard]] SpinningBall<S> spinning_ball(const Body& body) {
    return {body.mass, body.radius, body.state.inertia, body.state.velocity, body.state.spin};
}
template <math::Scalar S, class Body>
void take(const SpinningBall<S>& ball, Body& body) {
    body.state.velocity = ball.velocity;
    body.state.spin = ball.spin;
}

}  // namespace osculo::impact

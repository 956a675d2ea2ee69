#pragma once

#include <algorithm>
#include <type_traits>

#include "osculo/impact/spinning_ball.hpp"
#include "osculo/math/instant.hpp"
#include "osculo/math/vec.hpp"

/// Balls that are pressed against something.
///
/// A ball that a force keeps pressing against another thing (its own spin on the cloth, another
/// ball's slowing down) bounces ever lower, infinitely often in finite time. Real balls touch for
/// 0.2 to 0.3 ms; what happens within a time tau of that order has no meaning for impacts without
/// duration. So an impact of things that accelerate towards each other at a leaves them with a
/// separation speed of at least a tau / 2: they meet again after tau at the earliest (after the
/// contact time of Luding & McNamara 1998; NUMERICS 5). Nothing overlaps; the hops are at most
/// a tau^2 / 8 high; a pair alone has at most 1 / tau of them per second, a ball in a row up to
/// four times as many; and an impact can gain at most m a^2 tau^2 / 8 of energy (m the reduced
/// mass), less than what the force does in one hop.
///
/// A force that ends sooner, for the ball has stopped slipping by then, presses no longer than it
/// lasts, and tau is that time: a ball that just reaches another one does not push it away. So that
/// ever shorter slides do not follow each other for ever, tau is also at least twice the longest
/// hop of the ball, of those that have followed each other: hops double, from one on that the clock
/// can tell from none. (The longest, not the last: where two phases take turns, one presses and the
/// other does not.) They follow each other within twice the contact time, for a hop of that time
/// takes a little longer where the force lessens.
namespace osculo::impact {

/// How long a ball goes on accelerating as it does [s]: where that lessens as time goes by, until
/// the velocity it changes would be gone.
template <class State>
[[nodiscard]] auto acceleration_time(const State& state) {
    using S = std::decay_t<decltype(state.remaining)>;
    if constexpr (requires { state.acceleration_time(); }) return state.acceleration_time();
    if constexpr (requires { state.slowing; }) {
        const S rate = state.slowing.rate(S(1));
        return rate > S(0) ? S(S(1) / rate) : math::never<S>();
    }
    return state.half_acceleration.x() == S(0) && state.half_acceleration.y() == S(0)
               ? math::never<S>()
               : state.remaining;
}

/// The hops of a ball: times between impacts that followed each other.
template <math::Scalar S>
class Hops {
public:
    /// The longest, with an impact now, and no shorter than time passes at all; 0 if the last
    /// impact was longer ago than twice the contact time [s].
    [[nodiscard]] S longest(const math::Instant<S>& now, const S& contact_time) const {
        if (!any_) return S(0);
        const S hop = std::max<S>(math::duration<S>(last_, now), math::resolution<S>(now));
        return hop <= S(2) * contact_time ? std::max<S>(longest_, hop) : S(0);
    }
    /// Notes an impact; returns the longest.
    S note(const math::Instant<S>& now, const S& contact_time) {
        longest_ = longest(now, contact_time);
        last_ = now;
        any_ = true;
        return longest_;
    }

    /// As Engine::archive().
    template <class Archive>
    void archive(Archive& archive) {
        archive(last_, longest_, any_);
    }

private:
    math::Instant<S> last_{S(0)};
    S longest_{0};
    bool any_ = false;
};

/// tau [s] for a force that lasts for [duration], after hops of which the longest took [hop].
template <math::Scalar S>
[[nodiscard]] S pressing_time(const S& contact_time, const S& duration, const S& hop) {
    return std::min<S>(contact_time, std::max<S>(duration, S(2) * hop));
}

/// The separation speed along [normal] (a unit vector) that it takes, a tau / 2, for half the
/// relative acceleration of what lies there [m/s], and tau [s]; < 0 if nothing presses.
template <math::Scalar S>
[[nodiscard]] S least_separation(const math::Vec<S>& half_acceleration, const math::Vec<S>& normal,
                                 const S& pressing_time) {
    return -math::dot<S>(half_acceleration, normal) * pressing_time;
}

/// By how much a separation speed has to be raised, for a relative velocity [m/s].
template <math::Scalar S>
[[nodiscard]] S missing_separation(const math::Vec<S>& velocity,
                                   const math::Vec<S>& half_acceleration,
                                   const math::Vec<S>& normal, const S& pressing_time) {
    const S least = least_separation<S>(half_acceleration, normal, pressing_time);
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

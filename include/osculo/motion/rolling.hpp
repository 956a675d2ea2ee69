#pragma once

#include "osculo/math/instant.hpp"
#include "osculo/motion/half_deceleration.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::motion {

/// Rolling to rest without regard to spin: constant deceleration mu g along the velocity
/// (PHYSICS 2; the slowing down that Ko & Bang do by a constant per frame).
struct Rolling {
    static constexpr const char* kName = "rolling";
    static constexpr const char* kNameWithRims = "rolling+rims";
    static constexpr const char* kNameWithTippingRims = "rolling+tipping-rims";
    static constexpr bool kTransitions = true;
    static constexpr bool kSpin = false;

    template <math::Scalar S>
    struct Parameters {
        S deceleration{0};  ///< mu g [m/s^2], >= 0; 0 is free flight
    };

    template <math::Scalar S>
    struct State {
        math::WidePoint<S> position;                 ///< [m]
        math::Vec<S> velocity{S(0), S(0)};           ///< [m/s]
        math::Vec<S> half_acceleration{S(0), S(0)};  ///< [m/s^2]
        S remaining = math::never<S>();              ///< time until it rests [s]
    };

    /// Sets what follows from position and velocity. To be called whenever the velocity changes.
    template <math::Scalar S>
    static void begin(const Parameters<S>& law, State<S>& state) {
        const S speed = math::norm<S>(state.velocity);
        state.half_acceleration = {S(0), S(0)};
        state.remaining = math::never<S>();
        if (law.deceleration > S(0) && speed > S(0)) {
            state.half_acceleration = half_deceleration<S>(state.velocity, speed, law.deceleration);
            state.remaining = speed / law.deceleration;
        }
    }

    /// What happens after `remaining`: rest, exactly.
    template <math::Scalar S>
    static void transition(const Parameters<S>& law, State<S>& state) {
        state.velocity = {S(0), S(0)};
        begin(law, state);
    }

    template <math::Scalar S>
    [[nodiscard]] static ParabolicPath<S> path(const State<S>& state) {
        return {state.position, state.velocity, state.half_acceleration, state.remaining};
    }

    /// Moves the state on by t [s], 0 <= t <= remaining.
    template <math::Scalar S>
    static void advance(State<S>& state, const S& t) {
        state.position =
            math::displaced<S>(state.position, state.velocity, state.half_acceleration, t);
        state.velocity += (S(2) * t) * state.half_acceleration;
        if (math::is_finite<S>(state.remaining)) state.remaining -= t;
    }

    /// At least the length of the way that the state goes in t [s].
    template <math::Scalar S>
    [[nodiscard]] static S travel(const State<S>& state, const S& t) {
        return t * (math::norm1<S>(state.velocity) + t * math::norm1<S>(state.half_acceleration));
    }

    template <math::Scalar S>
    [[nodiscard]] static bool at_rest(const State<S>& state) {
        return state.velocity.x() == S(0) && state.velocity.y() == S(0);
    }
};

}  // namespace osculo::motion

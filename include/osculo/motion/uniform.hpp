#pragma once

#include "osculo/motion/path.hpp"

namespace osculo::motion {

/// Free flight, x + v t (PHYSICS 2).
struct Uniform {
    static constexpr const char* kName = "uniform";
    static constexpr bool kTransitions = false;
    static constexpr bool kSpin = false;

    /// Nothing to know.
    template <math::Scalar S>
    struct Parameters {};

    /// Place and motion of a ball at its own clock.
    template <math::Scalar S>
    struct State {
        math::WidePoint<S> position;        ///< [m]
        math::Vec<S> velocity{S(0), S(0)};  ///< [m/s]
    };

    /// How the ball goes on from its state while nothing happens to it.
    template <math::Scalar S>
    [[nodiscard]] static LinearPath<S> path(const State<S>& state) {
        return {state.position, state.velocity};
    }

    /// Moves the state on by t [s] >= 0.
    template <math::Scalar S>
    static void advance(State<S>& state, const S& t) {
        state.position = math::displaced<S>(state.position, state.velocity, t);
    }

    /// At least the length of the way that the state goes in t [s].
    template <math::Scalar S>
    [[nodiscard]] static S travel(const State<S>& state, const S& t) {
        return math::norm1<S>(state.velocity) * t;
    }

    template <math::Scalar S>
    [[nodiscard]] static bool at_rest(const State<S>& state) {
        return state.velocity.x() == S(0) && state.velocity.y() == S(0);
    }
};

}  // namespace osculo::motion

#pragma once

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/instant.hpp"
#include "osculo/motion/half_deceleration.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::motion {

/// What a ball does on the cloth.
enum class ClothPhase { rest, spinning, rolling, sliding };

/// A ball on a cloth: it slides until its contact point has stopped slipping, rolls until it stops,
/// and spins about the vertical until that, too, has worn off (PHYSICS 2, NUMERICS 7.1; Leckie &
/// Greenspan 2005). With the slip u = (vx - R wy, vy + R wx) of the contact point, k = I / (m R^2),
///
///   sliding   v' = -mu_s g u^,  w_xy' = mu_s g / (k R) (z x u^),  for |u| / (mu_s g (1 + 1/k))
///   rolling   v' = -mu_r g v^,  w_xy  = (z x v) / R,              for |v| / (mu_r g)
///   always    wz' = -mu_sp g / (k R) until wz = 0
///
/// and u^ is constant while sliding. Each friction may be zero: that phase then lasts for ever.
struct Cloth {
    static constexpr const char* kName = "cloth";
    static constexpr bool kTransitions = true;
    static constexpr bool kSpin = true;

    template <math::Scalar S>
    struct Parameters {
        S sliding{0};   ///< mu_s g [m/s^2]
        S rolling{0};   ///< mu_r g [m/s^2]
        S spinning{0};  ///< mu_sp g [m/s^2]
    };

    template <math::Scalar S>
    struct State {
        math::WidePoint<S> position;           ///< [m]
        math::Vec<S> velocity{S(0), S(0)};     ///< [m/s]
        math::Vec3<S> spin{S(0), S(0), S(0)};  ///< [rad/s]
        S radius{1};                           ///< [m]
        S inertia{S(2) / S(5)};                ///< k = I / (m R^2)
        ClothPhase phase = ClothPhase::rest;
        math::Vec<S> half_acceleration{S(0), S(0)};  ///< [m/s^2]
        math::Vec<S> spin_rate{S(0), S(0)};          ///< of w_xy while sliding [rad/s^2]
        S spin_decay{0};                             ///< of |wz| [rad/s^2]
        S remaining = math::never<S>();              ///< time until the phase ends [s]
    };

    /// Velocity of the contact point on the cloth [m/s].
    template <math::Scalar S>
    [[nodiscard]] static math::Vec<S> slip(const State<S>& state) {
        return {state.velocity.x() - state.radius * state.spin.y(),
                state.velocity.y() + state.radius * state.spin.x()};
    }

    /// Finds the phase that velocity and spin are in. To be called whenever they change. A slip
    /// below the rounding of its two terms is none: the ball rolls at once.
    template <math::Scalar S>
    static void begin(const Parameters<S>& law, State<S>& state) {
        const math::Vec<S> u = slip(state);
        const S slip_speed = math::norm<S>(u);
        const S terms =
            math::norm1<S>(state.velocity) +
            state.radius * (math::abs<S>(state.spin.x()) + math::abs<S>(state.spin.y()));
        if (slip_speed > S(math::kSlip) * math::epsilon<S>() * terms) {
            slide(law, state, math::Vec<S>(u / slip_speed), slip_speed);
        } else {
            roll(law, state);
        }
    }

    /// What happens after `remaining`: the next phase, from exact values.
    template <math::Scalar S>
    static void transition(const Parameters<S>& law, State<S>& state) {
        if (state.phase == ClothPhase::rolling) state.velocity = {S(0), S(0)};
        if (state.phase == ClothPhase::spinning) state.spin.z() = S(0);
        roll(law, state);
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
        if (state.phase == ClothPhase::rolling) {
            roll_with(state);
        } else {
            state.spin.x() += state.spin_rate.x() * t;
            state.spin.y() += state.spin_rate.y() * t;
        }
        const S lost = state.spin_decay * t;
        const S wz = state.spin.z();
        state.spin.z() = wz > lost ? S(wz - lost) : wz < -lost ? S(wz + lost) : S(0);
        if (math::is_finite<S>(state.remaining)) state.remaining -= t;
    }

    /// At least the length of the way that the state goes in t [s].
    template <math::Scalar S>
    [[nodiscard]] static S travel(const State<S>& state, const S& t) {
        return t * (math::norm1<S>(state.velocity) + t * math::norm1<S>(state.half_acceleration));
    }

    template <math::Scalar S>
    [[nodiscard]] static bool at_rest(const State<S>& state) {
        return state.phase == ClothPhase::rest;
    }

private:
    /// The spin of a ball that rolls with its velocity.
    template <math::Scalar S>
    static void roll_with(State<S>& state) {
        state.spin.x() = -state.velocity.y() / state.radius;
        state.spin.y() = state.velocity.x() / state.radius;
    }

    template <math::Scalar S>
    static void set_decay(const Parameters<S>& law, State<S>& state) {
        state.spin_decay =
            state.spin.z() == S(0) ? S(0) : S(law.spinning / (state.inertia * state.radius));
    }

    template <math::Scalar S>
    static void slide(const Parameters<S>& law, State<S>& state, const math::Vec<S>& direction,
                      const S& slip_speed) {
        state.phase = ClothPhase::sliding;
        state.half_acceleration = direction * (-law.sliding / S(2));
        const S rate = law.sliding / (state.inertia * state.radius);
        state.spin_rate = {-rate * direction.y(), rate * direction.x()};
        set_decay(law, state);
        state.remaining = law.sliding > S(0)
                              ? S(slip_speed / (law.sliding * (S(1) + S(1) / state.inertia)))
                              : math::never<S>();
    }

    /// Rolls, or spins on the spot, or rests.
    template <math::Scalar S>
    static void roll(const Parameters<S>& law, State<S>& state) {
        roll_with(state);
        state.spin_rate = {S(0), S(0)};
        state.half_acceleration = {S(0), S(0)};
        state.remaining = math::never<S>();
        set_decay(law, state);
        const S speed = math::norm<S>(state.velocity);
        if (speed > S(0)) {
            state.phase = ClothPhase::rolling;
            if (law.rolling > S(0)) {
                state.half_acceleration = half_deceleration<S>(state.velocity, speed, law.rolling);
                state.remaining = speed / law.rolling;
            }
        } else if (state.spin.z() != S(0)) {
            state.phase = ClothPhase::spinning;
            if (law.spinning > S(0)) {
                state.remaining = math::abs<S>(state.spin.z()) / state.spin_decay;
            }
        } else {
            state.phase = ClothPhase::rest;
        }
    }
};

}  // namespace osculo::motion

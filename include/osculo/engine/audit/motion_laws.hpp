#pragma once

#include "osculo/engine/audit/pieces.hpp"
#include "osculo/motion/cloth.hpp"
#include "osculo/motion/rolling.hpp"
#include "osculo/motion/uniform.hpp"

/// What the audit knows of motion laws: the state that a piece ends in, and whether the piece is
/// what the law says. From the formulas of the laws alone. A law from outside brings its own
/// end_of, motion_change, motion_scale, twice_energy_per_mass, obeys and largest_acceleration.
namespace osculo::engine {

/// In units of rounding: see math::kMotionNoise.
template <math::Scalar S>
[[nodiscard]] S motion_slack() {
    return S(math::kMotionNoise) * math::epsilon<S>();
}

/// a + b t, rounded once.
template <math::Scalar S>
[[nodiscard]] S grown(const S& a, const S& b, const S& t) {
    return math::narrow(math::Wide<S>(math::wide_product<S>(b, t) + a));
}
template <math::Scalar S>
[[nodiscard]] math::Vec<S> grown(const math::Vec<S>& a, const math::Vec<S>& b, const S& t) {
    return {grown<S>(a.x(), b.x(), t), grown<S>(a.y(), b.y(), t)};
}

// Free flight.

template <math::Scalar S>
[[nodiscard]] Moment<S> end_of(const PieceRecord<S>& piece) {
    return {position_at(piece, piece.to), piece.velocity};
}
/// Largest change of velocity [m/s], spins counted with the radius.
template <math::Scalar S>
[[nodiscard]] S motion_change(const Moment<S>& a, const Moment<S>& b) {
    return a.velocity == b.velocity ? S(0) : math::never<S>();
}

/// Twice the energy per mass [m^2/s^2].
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const motion::Uniform::State<S>& state) {
    return math::dot<S>(state.velocity, state.velocity);
}

// Rolling to rest.

template <math::Scalar S>
[[nodiscard]] motion::Rolling::State<S> end_of(
    const StatePieceRecord<S, motion::Rolling::State<S>>& piece) {
    const S t = math::duration<S>(piece.from, piece.to);
    motion::Rolling::State<S> end = piece.state;
    end.position = stretch(piece, piece.to, piece.to).start;
    end.velocity = grown<S>(end.velocity, S(2) * end.half_acceleration, t);
    return end;
}
template <math::Scalar S>
[[nodiscard]] S motion_change(const motion::Rolling::State<S>& a,
                              const motion::Rolling::State<S>& b) {
    return math::norm_max<S>(a.velocity - b.velocity);
}
/// The speeds that the rounding of a state within t [s] is relative to [m/s].
template <math::Scalar S>
[[nodiscard]] S motion_scale(const motion::Rolling::State<S>& state, const S& t) {
    return math::norm1<S>(state.velocity) + S(2) * t * math::norm1<S>(state.half_acceleration);
}
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const motion::Rolling::State<S>& state) {
    return math::dot<S>(state.velocity, state.velocity);
}

/// Whether 2 half_acceleration = -strength * (direction of v), for a v with that rounding.
template <math::Scalar S>
[[nodiscard]] bool slows_down(const math::Vec<S>& half_acceleration, const math::Vec<S>& v,
                              const S& strength, const S& rounding) {
    const S speed = math::norm<S>(v);
    if (!(speed > S(0))) return true;
    const math::Vec<S> error = S(2) * half_acceleration + strength * (v / speed);
    return math::norm<S>(error) <=
           strength * (rounding / speed + motion_slack<S>()) + S(math::kUnderflow);
}

/// Whether a ball in that state [s] moves as the law says, for t [s] at the longest.
template <math::Scalar S>
[[nodiscard]] bool obeys(const motion::Rolling::Parameters<S>& law,
                         const motion::Rolling::State<S>& state, const S& t) {
    const S speed = math::norm<S>(state.velocity);
    return slows_down<S>(state.half_acceleration, state.velocity, law.deceleration, S(0)) &&
           (!(speed > S(0)) || t * law.deceleration <= speed * (S(1) + motion_slack<S>()));
}
template <math::Scalar S>
[[nodiscard]] S largest_acceleration(const motion::Rolling::Parameters<S>& law) {
    return law.deceleration;
}

// On a cloth.

template <math::Scalar S>
[[nodiscard]] motion::Cloth::State<S> end_of(
    const StatePieceRecord<S, motion::Cloth::State<S>>& piece) {
    const S t = math::duration<S>(piece.from, piece.to);
    motion::Cloth::State<S> end = piece.state;
    end.position = stretch(piece, piece.to, piece.to).start;
    end.velocity = grown<S>(end.velocity, S(2) * end.half_acceleration, t);
    if (end.phase == motion::ClothPhase::rolling) {
        end.spin.x() = -end.velocity.y() / end.radius;
        end.spin.y() = end.velocity.x() / end.radius;
    } else {
        end.spin.x() = grown<S>(end.spin.x(), end.spin_rate.x(), t);
        end.spin.y() = grown<S>(end.spin.y(), end.spin_rate.y(), t);
    }
    const S left = grown<S>(math::abs<S>(end.spin.z()), -end.spin_decay, t);
    end.spin.z() = !(left > S(0)) ? S(0) : end.spin.z() < S(0) ? S(-left) : left;
    return end;
}
template <math::Scalar S>
[[nodiscard]] S motion_change(const motion::Cloth::State<S>& a, const motion::Cloth::State<S>& b) {
    if (a.radius != b.radius || a.inertia != b.inertia) return math::never<S>();
    const math::Vec3<S> turning = a.radius * (a.spin - b.spin);
    const S horizontal = math::norm_max<S>(math::Vec<S>(turning.x(), turning.y()));
    return std::max(
        {math::norm_max<S>(a.velocity - b.velocity), horizontal, math::abs<S>(turning.z())});
}
template <math::Scalar S>
[[nodiscard]] S motion_scale(const motion::Cloth::State<S>& state, const S& t) {
    const math::Vec<S> turning(state.radius * state.spin.x(), state.radius * state.spin.y());
    return math::norm1<S>(state.velocity) + math::norm1<S>(turning) +
           state.radius * math::abs<S>(state.spin.z()) +
           t * (S(2) * math::norm1<S>(state.half_acceleration) +
                state.radius * (math::norm1<S>(state.spin_rate) + state.spin_decay));
}
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const motion::Cloth::State<S>& state) {
    const math::Vec3<S> turning = state.radius * state.spin;
    return math::dot<S>(state.velocity, state.velocity) + state.inertia * turning.dot(turning);
}

template <math::Scalar S>
[[nodiscard]] bool obeys(const motion::Cloth::Parameters<S>& law,
                         const motion::Cloth::State<S>& state, const S& t) {
    using motion::ClothPhase;
    using Vec = math::Vec<S>;
    const S slack = motion_slack<S>();
    const S within = S(1) + slack;
    const math::Vec3<S> turning = state.radius * state.spin;

    const S decay = state.spin.z() == S(0) ? S(0) : S(law.spinning / state.inertia);
    if (!(math::abs<S>(state.radius * state.spin_decay - decay) <= slack * decay)) return false;

    // The velocity of the ball's surface where it touches the cloth: v + w x (0, 0, -R).
    const Vec slip(state.velocity.x() - turning.y(), state.velocity.y() + turning.x());
    const S slip_speed = math::norm<S>(slip);
    const S rounding =
        slack * (math::norm1<S>(state.velocity) + math::norm1<S>(Vec(turning.x(), turning.y()))) +
        underflow<S>(state);
    if (state.phase == ClothPhase::sliding) {
        // Friction against the slip, and its torque (0, 0, -R) x F: w' = (5/2) mu g / R z x u^.
        const Vec torque(-state.inertia * state.radius * state.spin_rate.y() / S(2),
                         state.inertia * state.radius * state.spin_rate.x() / S(2));
        return slip_speed > S(0) &&
               slows_down<S>(state.half_acceleration, slip, law.sliding, rounding) &&
               slows_down<S>(torque, slip, law.sliding, rounding) &&
               t * law.sliding * (S(1) + S(1) / state.inertia) <= slip_speed * within + rounding;
    }
    const Vec none(S(0), S(0));
    if (state.spin_rate != none || !(slip_speed <= rounding)) return false;
    if (state.phase == ClothPhase::rolling) {
        const S speed = math::norm<S>(state.velocity);
        return speed > S(0) &&
               slows_down<S>(state.half_acceleration, state.velocity, law.rolling, S(0)) &&
               t * law.rolling <= speed * within;
    }
    const bool at_rest = state.velocity == none && state.half_acceleration == none &&
                         turning.x() == S(0) && turning.y() == S(0);
    const bool spins = state.phase == ClothPhase::spinning;
    return at_rest && spins == (state.spin.z() != S(0)) &&
           t * decay <= math::abs<S>(turning.z()) * within;
}
template <math::Scalar S>
[[nodiscard]] S largest_acceleration(const motion::Cloth::Parameters<S>& law) {
    return std::max<S>(law.sliding, law.rolling);
}

}  // namespace osculo::engine

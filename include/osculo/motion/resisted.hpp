#pragma once

#include "osculo/math/instant.hpp"
#include "osculo/motion/certified_path.hpp"
#include "osculo/motion/slowing.hpp"
#include "osculo/motion/swept_box.hpp"

namespace osculo::motion {

/// A ball that slows down along a straight line: at position + velocity sigma(t), with the velocity
/// times q(t), for 0 <= t <= end.
template <math::Scalar S>
struct ResistedPath {
    math::WidePoint<S> position;  ///< [m]
    math::Vec<S> velocity;        ///< [m/s]
    Slowing<S> slowing;
    S end;                       ///< [s]; infinite without a constant deceleration
    S longest;                   ///< sigma(end) or little more [s]; may be infinite
    mutable S last_time = S(0);  ///< by slowed(), as the next
    mutable Slowed<S> last_slowed{S(0), S(1)};

    /// slowing.after(t). Asked for several times in a row at each t.
    [[nodiscard]] const Slowed<S>& slowed(const S& t) const {
        if (t != last_time) last_slowed = slowing.after(t);
        last_time = t;
        return last_slowed;
    }
    [[nodiscard]] PathPoint<S> at(const S& t) const {
        const Slowed<S>& now = slowed(t);
        return {math::displaced<S>(position, velocity, now.sigma), now.q * velocity};
    }
    [[nodiscard]] ParabolicPath<S> quadratic(const S& t) const {
        const Slowed<S>& now = slowed(t);
        return {math::displaced<S>(position, velocity, now.sigma), now.q * velocity,
                (slowing.rate(now.q) / S(-2)) * velocity, end > t ? S(end - t) : S(0)};
    }
    /// It falls with the speed: that at t counts. Infinite where numbers cannot tell it.
    [[nodiscard]] S jerk_bound(const S& t, const S& /*h*/) const {
        const S& q = slowed(t).q;
        const S jerk = jerk_at(q);
        return too_slow(q, jerk) ? math::never<S>() : jerk;
    }
    /// False for a ball so slow that quadratic drag, where that matters, is less than numbers can
    /// tell: below some 1e-96 m/s in double.
    [[nodiscard]] bool resolved() const { return !too_slow(S(1), jerk_at(S(1))); }

    /// Moves the start of the path on by t [s] <= end.
    void shift(const S& t) {
        const Slowed<S> now = slowing.after(t);
        // What is left of the speed, if numbers can tell how soon that is gone.
        const S q = math::is_finite<S>(slowing.m / now.q) ? now.q : S(0);
        position = math::displaced<S>(position, velocity, now.sigma);
        velocity *= q;
        slowing = slowing.from(q);
        end = end > t ? S(end - t) : S(0);
        longest = q > S(0) && longest > now.sigma ? S((longest - now.sigma) / q) : S(0);
        last_time = S(0);
        last_slowed = {S(0), S(1)};
    }

    [[nodiscard]] bool stands() const { return velocity.x() == S(0) && velocity.y() == S(0); }

private:
    [[nodiscard]] S jerk_at(const S& q) const {
        return (slowing.k + S(2) * slowing.c * q) * (slowing.rate(q) * math::norm1<S>(velocity));
    }
    [[nodiscard]] bool too_slow(const S& q, const S& jerk) const {
        if (S(0x1p-60) * jerk > S(0)) return false;
        const S of_square = slowing.c * q;
        return of_square > S(0) && of_square >= math::epsilon<S>() * (slowing.k + slowing.m / q);
    }
};

/// A box that the centre does not leave for `until` [s] >= 0. It goes no farther than with the
/// constant deceleration alone: sigma <= t - m t^2 / 2.
template <math::Scalar S>
[[nodiscard]] geometry::Box<S> swept_box(const ResistedPath<S>& path, const S& until) {
    const S t = std::min<S>(until, path.end);
    const S lost = path.slowing.m * t;
    S sigma = std::min<S>(t, path.longest);
    if (lost < S(1)) {
        const S slack = S(math::kRejectionSlack) * math::epsilon<S>();
        sigma = std::min<S>(sigma, S(t * (S(1) - lost / S(2)) * (S(1) + slack)));
    }
    return swept_box<S>(LinearPath<S>{path.position, path.velocity}, sigma);
}

/// Slowing down along a straight line at constant + linear v + quadratic v^2 (PHYSICS 2): rolling
/// resistance, viscous and turbulent drag, each may be 0. Each ball has its own coefficients, for
/// drag depends on its mass and radius. It rests at a finite time if constant > 0.
struct Resisted {
    static constexpr const char* kName = "resisted";
    static constexpr bool kTransitions = true;
    static constexpr bool kSpin = false;

    template <math::Scalar S>
    struct Parameters {
        S largest{0};  ///< what any ball's deceleration can be at the most [m/s^2]: for audits
    };

    template <math::Scalar S>
    struct State {
        math::WidePoint<S> position;                 ///< [m]
        math::Vec<S> velocity{S(0), S(0)};           ///< [m/s]
        Resistance<S> law;                           ///< the ball's own
        math::Vec<S> half_acceleration{S(0), S(0)};  ///< at the start [m/s^2]
        Slowing<S> slowing;
        S remaining = math::never<S>();  ///< time until it rests [s]
        S longest{0};                    ///< sigma(remaining) or little more [s]
    };

    /// Sets what follows from position and velocity. To be called whenever the velocity changes.
    template <math::Scalar S>
    static void begin(const Parameters<S>& /*law*/, State<S>& state) {
        const S speed = math::norm<S>(state.velocity);
        state.half_acceleration = {S(0), S(0)};
        state.slowing = {};
        state.remaining = math::never<S>();
        state.longest = S(0);
        if (!(speed > S(0))) return;
        state.slowing = Slowing<S>::of(state.law, speed);
        if (!math::is_finite<S>(state.slowing.m)) {  // a speed that is gone in no time
            state.slowing = {};
            state.remaining = S(0);
            return;
        }
        state.half_acceleration = state.velocity * (state.slowing.rate(S(1)) / S(-2));
        state.remaining = state.slowing.rest_time();
        state.longest = math::is_finite<S>(state.remaining)
                            ? S(state.slowing.after(state.remaining).sigma *
                                (S(1) + S(2 * math::kPathNoise) * math::epsilon<S>()))
                            : state.slowing.limit();
    }

    /// What happens after `remaining`: rest, exactly.
    template <math::Scalar S>
    static void transition(const Parameters<S>& law, State<S>& state) {
        state.velocity = {S(0), S(0)};
        begin(law, state);
    }

    template <math::Scalar S>
    [[nodiscard]] static ResistedPath<S> path(const State<S>& state) {
        return {state.position, state.velocity, state.slowing, state.remaining, state.longest};
    }

    /// Moves the state on by t [s], 0 <= t <= remaining.
    template <math::Scalar S>
    static void advance(State<S>& state, const S& t) {
        ResistedPath<S> way = path(state);
        way.shift(t);
        state.position = way.position;
        state.velocity = way.velocity;
        state.slowing = way.slowing;
        state.longest = way.longest;
        state.half_acceleration = state.velocity * (state.slowing.rate(S(1)) / S(-2));
        if (math::is_finite<S>(state.remaining)) state.remaining -= t;
    }

    /// At least the length of the way that the state goes in t [s].
    template <math::Scalar S>
    [[nodiscard]] static S travel(const State<S>& state, const S& t) {
        return math::norm1<S>(state.velocity) * std::min<S>(t, state.longest);
    }

    /// Whether numbers can tell what the ball does.
    template <math::Scalar S>
    [[nodiscard]] static bool resolves(const State<S>& state) {
        return path(state).resolved();
    }

    template <math::Scalar S>
    [[nodiscard]] static bool at_rest(const State<S>& state) {
        return state.velocity.x() == S(0) && state.velocity.y() == S(0);
    }
};

}  // namespace osculo::motion

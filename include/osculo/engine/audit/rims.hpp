#pragma once

#include "osculo/engine/audit/stays.hpp"
#include "osculo/motion/with_rims.hpp"

/// What the audit knows of balls in rims that pull (motion/with_rims.hpp): the field and what it
/// keeps, from PHYSICS 1.4 and 5. Places and velocities are the law's own, and are held against the
/// field.
namespace osculo::engine {

template <math::Scalar S>
using RollingRims = motion::WithRims<motion::Rolling>::State<S>;

/// Where a ball is in its rim's field: q, sqrt(1 - q^2), and the place from the centre.
template <math::Scalar S>
struct InRim {
    S q, root;
    math::Vec<S> x;

    InRim(const motion::RimPaperMotion<S>& stay, const math::WidePoint<S>& position,
          const S& radius)
        : x(math::difference<S>(position, stay.rim().center)) {
        q = (stay.rim().radius - math::norm<S>(x)) / radius;
        root = math::square_root<S>(std::max<S>((S(1) - q) * (S(1) + q), S(0)));
    }
};

template <math::Scalar S>
[[nodiscard]] S motion_change(const RollingRims<S>& a, const RollingRims<S>& b) {
    return math::norm_max<S>(a.velocity - b.velocity);
}
template <math::Scalar S>
[[nodiscard]] S motion_scale(const RollingRims<S>& state, const S& t) {
    if (state.stay) return state.stay->most_speed();
    return motion_scale<S>(static_cast<const motion::Rolling::State<S>&>(state), t);
}
/// With that of the field, which is 0 on the rim.
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const RollingRims<S>& state) {
    S energy = math::dot<S>(state.velocity, state.velocity);
    if (state.stay) {
        const InRim<S> in(*state.stay, state.position, state.ball_radius);
        energy = energy - S(2) / S(3) * state.stay->gravity() * state.ball_radius *
                              (S(1) - in.root * in.root * in.root);
    }
    return energy;
}

/// Energy and angular momentum are those of the start, the acceleration is the field's, and the
/// place follows velocity and acceleration, all looked at at some instants.
template <math::Scalar S>
[[nodiscard]] bool obeys_field(const RollingRims<S>& state, const S& t) {
    constexpr int kInstants = 8;
    const motion::RimPaperMotion<S>& stay = *state.stay;
    const S scale = stay.most_speed();
    const S noise = S(16) * motion_slack<S>();
    const S energy = twice_energy_per_mass<S>(state);
    const auto moment_of = [&](const math::WidePoint<S>& position, const math::Vec<S>& v) {
        return math::accurate_cross<S>(math::difference<S>(position, stay.rim().center), v);
    };
    const S moment = moment_of(state.position, state.velocity);
    const auto begin = stay.at(state.since);
    const S shift = math::norm<S>(math::difference<S>(begin.position, state.position));
    const S change = math::norm<S>(math::Vec<S>(begin.velocity - state.velocity));
    if (!(shift <= noise * stay.rim().radius && change <= noise * scale)) return false;
    for (int i = 0; i <= kInstants; ++i) {
        const S when = state.since + t * S(i) / S(kInstants);
        const auto now = stay.at(when);
        RollingRims<S> there = state;
        there.position = now.position;
        there.velocity = now.velocity;
        const InRim<S> in(stay, now.position, state.ball_radius);
        const S off = math::abs<S>(twice_energy_per_mass<S>(there) - energy);
        if (!(off <= noise * scale * scale * stay.rim().radius / state.ball_radius)) return false;
        const S turned = math::abs<S>(moment_of(now.position, now.velocity) - moment);
        if (!(turned <= noise * scale * stay.rim().radius)) return false;
        if (i == kInstants) break;
        // Short enough for what is left out to be small, long enough for rounding to be.
        const S h = t / S(64 * kInstants);
        const auto later = stay.at(S(when + h));
        const S pull = stay.gravity() * in.q * in.root / math::norm<S>(in.x);
        const math::Vec<S> way = h * (now.velocity - (h * pull / S(2)) * in.x);
        const math::WidePoint<S> went{later.position.x - now.position.x,
                                      later.position.y - now.position.y};
        const S error = math::norm<S>(math::Vec<S>(went.rounded() - way));
        const S bound = stay.jerk_bound(when, h) * h * h * h / S(6);
        if (!(error <= bound + noise * stay.rim().radius)) return false;
    }
    return true;
}
template <math::Scalar S>
[[nodiscard]] bool obeys(const motion::WithRims<motion::Rolling>::Parameters<S>& law,
                         const RollingRims<S>& state, const S& t) {
    if (state.stay) return obeys_field<S>(state, t);
    return obeys<S>(static_cast<const motion::Rolling::Parameters<S>&>(law),
                    static_cast<const motion::Rolling::State<S>&>(state), t);
}
/// q sqrt(1 - q^2) is at most 1/2.
template <math::Scalar S>
[[nodiscard]] S largest_acceleration(const motion::WithRims<motion::Rolling>::Parameters<S>& law) {
    return std::max<S>(law.deceleration, law.gravity / S(2));
}

}  // namespace osculo::engine

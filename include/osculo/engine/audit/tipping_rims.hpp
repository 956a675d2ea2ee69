#pragma once

#include "osculo/engine/audit/stays.hpp"
#include "osculo/motion/with_tipping_rims.hpp"

/// What the audit knows of balls that tip over the edge of a rim (motion/with_tipping_rims.hpp):
/// gravity, the edge's push and its impacts, from PHYSICS 5. Places and velocities are the law's
/// own, and are held against them.
namespace osculo::engine {

template <math::Scalar S>
using RollingTippingRims = motion::WithTippingRims<motion::Rolling>::State<S>;
template <math::Scalar S>
using TippingLaw = motion::WithTippingRims<motion::Rolling>::Parameters<S>;

/// Where a ball is over a hole: what is around, along and off the edge.
template <math::Scalar S>
struct OverHole {
    S d;         ///< of the centre from the hole's axis
    S distance;  ///< of the centre from the edge
    S sine, cosine;
    math::Vec<S> out;
    S around, along, off;  ///< speeds: inwards and down, along and away from the edge
    S twice_kinetic;       ///< per mass
    S moment;              ///< angular momentum about the axis, per mass

    OverHole(const geometry::Rim<S>& rim, const motion::Hovering<S>& ball) {
        const math::Vec<S> x = math::difference<S>(ball.position, rim.center);
        d = math::norm<S>(x);
        out = x / d;
        distance = math::norm<S>(math::Vec<S>(S(rim.radius - d), ball.height));
        sine = (rim.radius - d) / distance;
        cosine = ball.height / distance;
        const S radial = math::dot<S>(ball.velocity, out);
        along = math::cross<S>(out, ball.velocity);
        around = -radial * cosine - ball.climb * sine;
        off = ball.climb * cosine - radial * sine;
        twice_kinetic = math::dot<S>(ball.velocity, ball.velocity) + ball.climb * ball.climb;
        moment = math::accurate_cross<S>(x, ball.velocity);
    }
};
template <math::Scalar S>
[[nodiscard]] motion::Hovering<S> in_space(const RollingTippingRims<S>& state) {
    return {state.position, state.velocity, state.height, state.climb};
}

template <math::Scalar S>
[[nodiscard]] S motion_change(const RollingTippingRims<S>& a, const RollingTippingRims<S>& b) {
    const S plan = math::norm_max<S>(a.velocity - b.velocity);
    if (!a.stay || !b.stay) return plan;  // on the table: what was vertical is lost there
    return std::max<S>(plan, math::abs<S>(S(a.climb - b.climb)));
}
/// In a rim, places are known to the rounding of that, and with them the speed along the edge to as
/// much of it as that is of the distance from the axis.
template <math::Scalar S>
[[nodiscard]] S motion_scale(const RollingTippingRims<S>& state, const S& t) {
    if (!state.stay) {
        return motion_scale<S>(static_cast<const motion::Rolling::State<S>&>(state), t);
    }
    const OverHole<S> in(state.stay->rim(), in_space<S>(state));
    const S speed =
        math::square_root<S>(in.twice_kinetic + S(2) * state.stay->gravity() * in.distance);
    const S& rim = state.stay->rim().radius;
    return state.stay->on_edge() ? S(speed * rim / (rim - state.ball_radius)) : speed;
}
/// With that of its height, which is 0 on the table. A ball that rolls on the edge shares with its
/// rotation what it gains there.
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const RollingTippingRims<S>& state) {
    S energy = math::dot<S>(state.velocity, state.velocity);
    if (state.stay) {
        energy = energy + state.climb * state.climb +
                 S(2) * state.stay->gravity() / state.stay->heaviness() *
                     (state.height - state.ball_radius);
    }
    return energy;
}

/// Energy and angular momentum are those of the start, it stays on the edge or off it, and place
/// and height follow velocity and acceleration, all looked at at some instants.
template <math::Scalar S>
[[nodiscard]] bool obeys_edge(const RollingTippingRims<S>& state, const S& t) {
    constexpr int kInstants = 8;
    const auto& stay = *state.stay;
    const geometry::Rim<S>& rim = stay.rim();
    const S noise = S(16) * motion_slack<S>();
    const S scale = motion_scale<S>(state, t);
    const S gravity = stay.gravity() / stay.heaviness();
    const OverHole<S> first(rim, in_space<S>(state));
    const S energy = first.twice_kinetic + S(2) * gravity * state.height;
    const auto begin = stay.in_space(state.since);
    const S shift = math::norm<S>(math::difference<S>(begin.position, state.position));
    const S change = math::norm<S>(math::Vec<S>(begin.velocity - state.velocity)) +
                     math::abs<S>(S(begin.climb - state.climb));
    if (!(shift + math::abs<S>(S(begin.height - state.height)) <= noise * rim.radius)) return false;
    if (!(change <= noise * scale)) return false;
    for (int i = 0; i <= kInstants; ++i) {
        const S when = state.since + t * S(i) / S(kInstants);
        const auto now = stay.in_space(when);
        const OverHole<S> in(rim, now);
        const S off = math::abs<S>(S(in.twice_kinetic + S(2) * gravity * now.height - energy));
        if (!(off <= noise * scale * scale)) return false;
        if (!(math::abs<S>(S(in.moment - first.moment)) <= noise * scale * rim.radius))
            return false;
        const S gap = in.distance - state.ball_radius;
        if (!(gap >= -noise * rim.radius)) return false;
        if (stay.on_edge() && !(gap <= noise * rim.radius)) return false;
        if (i == kInstants) break;
        S push(0);
        if (stay.on_edge()) {
            push = gravity * in.cosine - in.around * in.around / state.ball_radius +
                   in.along * in.along / in.d * in.sine;
        }
        // Short enough for what is left out to be small, long enough for rounding to be.
        const S h = t / S(64 * kInstants);
        const auto later = stay.in_space(S(when + h));
        const math::Vec<S> way = h * (now.velocity - (h * push * in.sine / S(2)) * in.out);
        const math::WidePoint<S> went{later.position.x - now.position.x,
                                      later.position.y - now.position.y};
        const S rise = h * (now.climb + h * (push * in.cosine - gravity) / S(2));
        const S error = math::norm<S>(math::Vec<S>(went.rounded() - way)) +
                        math::abs<S>(S(later.height - now.height - rise));
        const S bound = S(2) * stay.jerk_bound(when, h) * h * h * h / S(6);
        const S size = rim.radius + math::abs<S>(now.height);
        if (!(error <= bound + noise * size)) return false;
    }
    return true;
}
template <math::Scalar S>
[[nodiscard]] bool obeys(const TippingLaw<S>& law, const RollingTippingRims<S>& state, const S& t) {
    if (state.stay) return obeys_edge<S>(state, t);
    return obeys<S>(static_cast<const motion::Rolling::Parameters<S>&>(law),
                    static_cast<const motion::Rolling::State<S>&>(state), t);
}
template <math::Scalar S>
[[nodiscard]] S largest_acceleration(const TippingLaw<S>& law) {
    return std::max<S>(law.deceleration, law.gravity);
}

/// Whether a transition from that state is an impact with the edge.
template <math::Scalar S>
[[nodiscard]] bool hits_edge(const RollingTippingRims<S>& before) {
    return before.stay && before.stay->end() == motion::TippingEnd::edge;
}
/// Whether that impact is one: they touch and do not part, nothing changes but along the normal in
/// space, by the edge's restitution or to rest where it would be back within the contact time.
template <math::Scalar S>
[[nodiscard]] bool hit_explained(const TippingLaw<S>& law, const RollingTippingRims<S>& before,
                                 const RollingTippingRims<S>& after) {
    if (!after.stay) return false;
    const geometry::Rim<S>& rim = before.stay->rim();
    const OverHole<S> was(rim, in_space<S>(before));
    const OverHole<S> is(rim, in_space<S>(after));
    const S noise = S(16) * motion_slack<S>();
    const S scale = motion_scale<S>(before, S(0));
    const S near = noise * rim.radius;
    if (!(math::abs<S>(S(was.distance - before.ball_radius)) <= near)) return false;
    if (!(math::abs<S>(S(is.along - was.along)) <= noise * scale)) return false;
    if (!(math::abs<S>(S(is.around - was.around)) <= noise * scale)) return false;
    const S bounce = std::max<S>(was.off, S(-law.restitutions[before.rim] * was.off));
    if (math::abs<S>(S(is.off - bounce)) <= noise * scale) return was.off <= noise * scale;
    const S push = law.gravity * was.cosine - was.around * was.around / before.ball_radius +
                   was.along * was.along / was.d * was.sine;
    return math::abs<S>(is.off) <= noise * scale &&
           S(2) * bounce <= push * law.contact_time + noise * scale;
}

}  // namespace osculo::engine

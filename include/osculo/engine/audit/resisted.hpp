#pragma once

#include <algorithm>
#include <array>
#include <concepts>

#include "osculo/engine/audit/motion_laws.hpp"
#include "osculo/motion/disc.hpp"
#include "osculo/motion/relative_jerk.hpp"

/// What the audit knows of balls with drag: their law as its differential equation, and the gaps
/// between them.
namespace osculo::engine {

/// The ball of a piece, from an instant on for a time, as seen from an origin.
template <math::Scalar S>
struct ResistedStretch {
    motion::ResistedPath<S> path;
    math::Wide<S> time;

    [[nodiscard]] math::WidePoint<S> at(const math::Wide<S>& t) const {
        return path.at(math::narrow(t)).position;
    }
    /// The same way without regard to when: straight, with sigma for time.
    [[nodiscard]] RelativePath<S> line() const {
        return {path.position, math::WidePoint<S>(path.velocity),
                math::Wide<S>(path.slowing.after(math::narrow(time)).sigma)};
    }
};

/// Two of them, both from the same instant on for the same time.
template <math::Scalar S>
struct ResistedPairStretch {
    ResistedStretch<S> first, second;
};

/// The states of Resisted and of what adds to it.
template <class State, class S>
concept ResistedState = std::derived_from<State, motion::Resisted::State<S>>;

template <math::Scalar S, ResistedState<S> State>
[[nodiscard]] S path_length(const StatePieceRecord<S, State>& piece) {
    const S t = math::duration<S>(piece.from, piece.to);
    return math::norm<S>(piece.state.velocity) * std::min<S>(t, piece.state.longest);
}

template <math::Scalar S, ResistedState<S> State>
[[nodiscard]] ResistedStretch<S> stretch(const StatePieceRecord<S, State>& piece,
                                         const math::Instant<S>& start, const math::Instant<S>& end,
                                         const math::Vec<S>& origin = math::Vec<S>(S(0), S(0))) {
    ResistedStretch<S> result{motion::Resisted::path<S>(piece.state), end - start};
    const S before = math::duration<S>(piece.from, start);
    if (before > S(0)) result.path.shift(before);
    result.path.position = seen_from(result.path.position, origin);
    return result;
}
template <math::Scalar S>
[[nodiscard]] ResistedPairStretch<S> seen_from(const ResistedStretch<S>& a,
                                               const ResistedStretch<S>& b) {
    return {a, b};
}

template <math::Scalar S>
[[nodiscard]] Box box_around(const ResistedStretch<S>& stretch) {
    return box_around<S>(stretch.path.position.rounded(), stretch.at(stretch.time).rounded());
}
/// Where the first can be as seen from the second.
template <math::Scalar S>
[[nodiscard]] Box box_around(const ResistedPairStretch<S>& pair) {
    const Box a = box_around(pair.first);
    const Box b = box_around(pair.second);
    const double size =
        std::max({std::abs(a.low_x), std::abs(a.high_x), std::abs(a.low_y), std::abs(a.high_y),
                  std::abs(b.low_x), std::abs(b.high_x), std::abs(b.low_y), std::abs(b.high_y)});
    return Box{a.low_x - b.high_x, a.high_x - b.low_x, a.low_y - b.high_y, a.high_y - b.low_y}
        .grown(4 * math::epsilon<double>() * size);
}

namespace detail {

/// The smallest gap of a pair on [from, from + time], if it is less than [smallest]: on a stretch
/// of time in which the ways stay within R of parabolas the gap is at most R less than that of
/// these; where that does not settle it, on either half, until R is no more than rounding.
template <math::Scalar S>
void keep_smallest(const ResistedPairStretch<S>& pair, const math::Wide<S>& reach, const S& from,
                   const S& time, GapAt<S>& smallest) {
    const S way = from * (math::norm1<S>(pair.first.path.velocity) +
                          math::norm1<S>(pair.second.path.velocity));
    const S rounding = math::epsilon<S>() * (math::narrow(reach) + way);
    const S jerk = relative_jerk_bound(pair.first.path, pair.second.path, from, time);
    const S half = time / S(2);
    if (!math::is_finite<S>(jerk)) {
        // Too large now, not later on; or what numbers never tell, nor does the engine know it.
        const S end = from + time;
        const S last =
            pair.first.path.jerk_bound(end, S(0)) + pair.second.path.jerk_bound(end, S(0));
        if (!math::is_finite<S>(last) || !(from + half > from)) return;
        keep_smallest<S>(pair, reach, from, half, smallest);
        keep_smallest<S>(pair, reach, S(from + half), half, smallest);
        return;
    }
    const S margin = jerk * time * time * time / S(6);
    const motion::ParabolicPath<S> one = pair.first.path.quadratic(from);
    const motion::ParabolicPath<S> other = pair.second.path.quadratic(from);
    const RelativeParabola<S> parabola{
        seen_from(one.position, other.position),
        math::WidePoint<S>(math::Vec<S>(one.velocity - other.velocity)),
        math::WidePoint<S>(math::Vec<S>(one.half_acceleration - other.half_acceleration)),
        math::Wide<S>(time)};
    const GapAt<S> found = smallest_distance_beyond<S>(parabola, reach);
    const math::Wide<S> when = math::Wide<S>(found.t + from);
    if (found.gap - margin >= smallest.gap) return;
    if (margin <= rounding || !(from + half > from)) {
        smallest.keep_smaller(found.gap, when);
        return;
    }
    const math::WidePoint<S> place = seen_from(pair.first.at(when), pair.second.at(when));
    smallest.keep_smaller(length_beyond<S>(place, reach), when);
    keep_smallest<S>(pair, reach, from, half, smallest);
    keep_smallest<S>(pair, reach, S(from + half), half, smallest);
}

}  // namespace detail

/// Two balls: smallest |x| - reach.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_distance_beyond(const ResistedPairStretch<S>& pair,
                                                const math::Wide<S>& reach) {
    const math::Wide<S>& end = pair.first.time;
    GapAt<S> smallest{
        length_beyond<S>(seen_from(pair.first.path.position, pair.second.path.position), reach)};
    smallest.keep_smaller(
        length_beyond<S>(seen_from(pair.first.at(end), pair.second.at(end)), reach), end);
    detail::keep_smallest<S>(pair, reach, S(0), math::narrow(end), smallest);
    return smallest;
}

/// A ball and an obstacle: along the straight line that is its way.
template <math::Scalar S, class Obstacle>
[[nodiscard]] GapAt<S> smallest_gap_along(const ResistedStretch<S>& stretch, const S& radius,
                                          const Obstacle& obstacle) {
    GapAt<S> found = smallest_gap(stretch.line(), radius, obstacle);
    const S sigma = math::narrow(found.t);
    if (sigma > S(0)) {
        found.t = math::Wide<S>(stretch.path.slowing.time_of(sigma, math::narrow(stretch.time)));
    }
    return found;
}
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const ResistedStretch<S>& stretch, const S& radius,
                                    const geometry::Point<S>& point) {
    return smallest_gap_along(stretch, radius, point);
}
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const ResistedStretch<S>& stretch, const S& radius,
                                    const geometry::Segment<S>& segment) {
    return smallest_gap_along(stretch, radius, segment);
}
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const ResistedStretch<S>& stretch, const S& radius,
                                    const geometry::Arc<S>& arc) {
    return smallest_gap_along(stretch, radius, arc);
}
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const ResistedStretch<S>& stretch, const S& radius,
                                    const geometry::Rim<S>& rim) {
    return smallest_gap_along(stretch, radius, rim);
}

template <math::Scalar S, ResistedState<S> State>
[[nodiscard]] State end_of(const StatePieceRecord<S, State>& piece) {
    const motion::PathPoint<S> end =
        motion::Resisted::path<S>(piece.state).at(math::duration<S>(piece.from, piece.to));
    State state = piece.state;
    state.position = end.position;
    state.velocity = end.velocity;
    return state;
}
template <math::Scalar S>
[[nodiscard]] S motion_change(const motion::Resisted::State<S>& a,
                              const motion::Resisted::State<S>& b) {
    if (!(a.law == b.law)) return math::never<S>();
    return math::norm_max<S>(a.velocity - b.velocity);
}
template <math::Scalar S>
[[nodiscard]] S motion_scale(const motion::Resisted::State<S>& state, const S& t) {
    return math::norm1<S>(state.velocity) + S(2) * t * math::norm1<S>(state.half_acceleration);
}
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const motion::Resisted::State<S>& state) {
    return math::dot<S>(state.velocity, state.velocity);
}

// Discs: what they turn is theirs to keep.

template <math::Scalar S>
[[nodiscard]] S motion_change(const motion::Disc::State<S>& a, const motion::Disc::State<S>& b) {
    if (a.radius != b.radius || a.inertia != b.inertia) return math::never<S>();
    const math::Vec3<S> turning = a.radius * (a.spin - b.spin);
    const S flat = math::norm_max<S>(math::Vec<S>(turning.x(), turning.y()));
    const motion::Resisted::State<S>& moves = a;
    return std::max({motion_change<S>(moves, b), flat, math::abs<S>(turning.z())});
}
template <math::Scalar S>
[[nodiscard]] S motion_scale(const motion::Disc::State<S>& state, const S& t) {
    const motion::Resisted::State<S>& moves = state;
    return motion_scale<S>(moves, t) + state.radius * math::abs<S>(state.spin.z());
}
template <math::Scalar S>
[[nodiscard]] S twice_energy_per_mass(const motion::Disc::State<S>& state) {
    const math::Vec3<S> turning = state.radius * state.spin;
    return math::dot<S>(state.velocity, state.velocity) + state.inertia * turning.dot(turning);
}

/// Way and speed after t by the differential equation alone: power series in steps so short that
/// their terms shrink fast. Its rounding: some ten epsilon for each step. Ends when the speed is
/// all but gone, or falls too fast for numbers; t is then what is left of the time.
template <math::Scalar S>
[[nodiscard]] motion::Slowed<S> integrated(const motion::Slowing<S>& law, S& t) {
    constexpr int kMostTerms = 4 * 64;
    std::array<S, kMostTerms> q{};
    motion::Slowed<S> now{S(0), S(1)};
    while (t > S(0)) {
        const S rate = S(8) * (law.m / now.q + law.k + law.c * now.q);
        if (!math::is_finite<S>(rate)) break;
        S h = rate * t > S(1) ? S(S(1) / rate) : t;
        if (!(h < t)) h = t;
        // In units of h, whose powers would leave the range of numbers.
        q[0] = now.q;
        S way = now.q;
        S end = now.q;
        for (std::size_t n = 0; n + 1 < q.size(); ++n) {
            S square(0);
            for (std::size_t i = 0; i <= n; ++i) square += q[i] * q[n - i];
            const S sum = (n == 0 ? law.m : S(0)) + law.k * q[n] + law.c * square;
            q[n + 1] = -(h * sum) / S(static_cast<double>(n + 1));
            end += q[n + 1];
            way += q[n + 1] / S(static_cast<double>(n + 2));
            if (math::abs<S>(q[n + 1]) <= math::epsilon<S>() * S(0.01) * now.q) break;
        }
        now.sigma += way * h;
        now.q = end > S(0) ? end : S(0);
        t = t > h ? S(t - h) : S(0);
        if (now.q <= S(0x1p-40)) break;
    }
    return now;
}

/// Whether a ball in that state moves as the law says, for t [s] at the longest: what the piece
/// knows follows from its law and velocity, and its way from the differential equation.
template <math::Scalar S>
[[nodiscard]] bool obeys(const motion::Resisted::Parameters<S>& /*law*/,
                         const motion::Resisted::State<S>& state, const S& t) {
    const S slack = motion_slack<S>();
    const S speed = math::norm<S>(state.velocity);
    if (!(speed > S(0))) return state.half_acceleration == math::Vec<S>(S(0), S(0));
    const auto& [constant, linear, quadratic] = state.law;
    const auto near = [&](const S& a, const S& b) {
        return math::abs<S>(a - b) <= slack * math::abs<S>(b);
    };
    const S strength = constant + speed * (linear + speed * quadratic);
    if (!near(state.slowing.m * speed, constant) || !near(state.slowing.k, linear) ||
        !near(state.slowing.c, S(quadratic * speed)) || t > state.remaining * (S(1) + slack) ||
        !slows_down<S>(state.half_acceleration, state.velocity, strength, S(0))) {
        return false;
    }
    if (!(t > S(0))) return true;
    S left = t;
    const motion::Slowed<S> by_steps = integrated<S>(state.slowing, left);
    const motion::Slowed<S> said = state.slowing.after(t);
    // What it has not followed to the end: less than the speed that was left goes with.
    const S rest = left > S(0) ? by_steps.q : S(0);
    if (linear > S(0)) left = std::min<S>(left, S(S(1) / linear));
    const S enough = S(64) * slack + S(4) * slack * t * state.slowing.rate(S(1));
    return math::abs<S>(by_steps.sigma - said.sigma) <= enough * said.sigma + rest * left &&
           math::abs<S>(by_steps.q - said.q) <= enough + rest;
}
template <math::Scalar S>
[[nodiscard]] S largest_acceleration(const motion::Resisted::Parameters<S>& law) {
    return law.largest;
}
/// That of one ball at a speed.
template <math::Scalar S, ResistedState<S> State>
[[nodiscard]] S acceleration_at(const State& state, const S& speed) {
    const motion::Resistance<S>& law = state.law;
    return law.constant + speed * (law.linear + speed * law.quadratic);
}

}  // namespace osculo::engine

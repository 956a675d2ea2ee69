#pragma once

#include <algorithm>

#include "osculo/math/first_root_parabolic.hpp"
#include "osculo/motion/certified_path.hpp"

/// When does a gap close on paths that are not quadratic in time? By certified quadratic segments
/// (NUMERICS 2.2): on [t, t + h] a path stays within R = J h^3 / 6 of its parabola at t, J a bound
/// of its third derivative, so that nothing can happen before the parabola meets a target that is
/// larger by R. Segments are as long as R is a part of the gap; near the contact, the gap falls
/// certainly and Newton's iteration on the path itself finds the time.
namespace osculo::detect {

/// The gap that is looked at, at one instant: its function f (of the sign of the gap), the slope of
/// f, and the gap itself in metres.
template <math::Scalar S>
struct GapAt {
    S value;
    S slope;
    S gap;
};

/// A parabola relative to a target, c + b t + a t^2, and how far its place may be off.
template <math::Scalar S>
struct LocalParabola {
    math::WidePoint<S> place;
    math::Vec<S> c, b, a;
    S blur;  ///< [m]

    /// Bounds of speed, distance and acceleration in the next h [s] under a jerk [m/s^3].
    [[nodiscard]] S speed(const S& h, const S& jerk) const {
        return math::norm1<S>(b) + h * (S(2) * math::norm1<S>(a) + h * jerk / S(2));
    }
    [[nodiscard]] S distance(const S& h, const S& jerk) const {
        return math::norm1<S>(c) + h * speed(h, jerk);
    }
    [[nodiscard]] S acceleration(const S& h, const S& jerk) const {
        return S(2) * math::norm1<S>(a) + h * jerk;
    }
};

namespace detail {

template <math::Scalar S>
[[nodiscard]] math::WidePoint<S> wide_difference(const math::WidePoint<S>& p,
                                                 const math::WidePoint<S>& q) {
    return {p.x - q.x, p.y - q.y};
}

/// Rounding of a place on a path.
template <math::Scalar S, class Path>
[[nodiscard]] S path_blur(const Path& path, const math::WidePoint<S>& place) {
    S way = math::norm1<S>(math::difference<S>(place, path.position));
    if constexpr (requires { path.size; }) way = way + path.size;
    return S(math::kPathNoise) * math::epsilon<S>() * way;
}

}  // namespace detail

/// One path seen from another one.
template <math::Scalar S, class First, class Second>
requires motion::CertifiedPath<First, S> && motion::CertifiedPath<Second, S>
struct BetweenPaths {
    using Scalar = S;
    const First& first;
    const Second& second;

    [[nodiscard]] motion::PathPoint<S> at(const S& t) const {
        const motion::PathPoint<S> one = first.at(t);
        const motion::PathPoint<S> other = second.at(t);
        return {detail::wide_difference<S>(one.position, other.position),
                one.velocity - other.velocity};
    }
    [[nodiscard]] LocalParabola<S> parabola(const S& t) const {
        const motion::ParabolicPath<S> one = first.quadratic(t);
        const motion::ParabolicPath<S> other = second.quadratic(t);
        const math::WidePoint<S> place = detail::wide_difference<S>(one.position, other.position);
        return {place, place.rounded(), one.velocity - other.velocity,
                one.half_acceleration - other.half_acceleration,
                S(detail::path_blur<S>(first, one.position) +
                  detail::path_blur<S>(second, other.position))};
    }
    [[nodiscard]] S jerk(const S& t, const S& h) const {
        return first.jerk_bound(t, h) + second.jerk_bound(t, h);
    }
    /// The same, of two that go side by side much less; takes longer.
    [[nodiscard]] S closer_jerk(const S& t, const S& h) const {
        if constexpr (requires { relative_jerk_bound(first, second, t, h); }) {
            return relative_jerk_bound(first, second, t, h);
        } else {
            return jerk(t, h);
        }
    }
    /// At the start.
    [[nodiscard]] S speed() const {
        return math::norm1<S>(first.at(S(0)).velocity) + math::norm1<S>(second.at(S(0)).velocity);
    }
};

/// A path seen from a fixed point.
template <math::Scalar S, class Path>
requires motion::CertifiedPath<Path, S>
struct FromPoint {
    using Scalar = S;
    const Path& path;
    math::Vec<S> point;

    [[nodiscard]] motion::PathPoint<S> at(const S& t) const {
        const motion::PathPoint<S> now = path.at(t);
        return {math::wide_difference<S>(now.position, point), now.velocity};
    }
    [[nodiscard]] LocalParabola<S> parabola(const S& t) const {
        const motion::ParabolicPath<S> now = path.quadratic(t);
        const math::WidePoint<S> place = math::wide_difference<S>(now.position, point);
        return {place, place.rounded(), now.velocity, now.half_acceleration,
                detail::path_blur<S>(path, now.position)};
    }
    [[nodiscard]] S jerk(const S& t, const S& h) const { return path.jerk_bound(t, h); }
    [[nodiscard]] S closer_jerk(const S& t, const S& h) const { return jerk(t, h); }
    [[nodiscard]] S speed() const { return math::norm1<S>(path.at(S(0)).velocity); }
};

/// Coming to a circle around the origin from outside, or, [outwards], from inside: f = |x|^2 - s^2
/// or s^2 - |x|^2.
template <class Motion>
struct CircleCrossing {
    using S = typename Motion::Scalar;
    Motion motion;
    S radius;
    bool outwards;

    [[nodiscard]] GapAt<S> at(const math::WidePoint<S>& place, const math::Vec<S>& velocity) const {
        using Wide = math::Wide<S>;
        const Wide square = place.x * place.x + place.y * place.y;
        S value = math::narrow(Wide(square - math::wide_product<S>(radius, radius)));
        const math::Vec<S> c = place.rounded();
        S slope = S(2) * math::accurate_dot<S>(c, velocity);
        if (outwards) {
            value = -value;
            slope = -slope;
        }
        return {value, slope, S(value / (math::norm<S>(c) + radius))};
    }
    /// At least |f''| in the next h [s].
    [[nodiscard]] S bend(const LocalParabola<S>& p, const S& h, const S& jerk) const {
        const S speed = p.speed(h, jerk);
        return S(2) * (speed * speed + p.distance(h, jerk) * p.acceleration(h, jerk));
    }
    [[nodiscard]] bool bends_down(const LocalParabola<S>& p) const {
        const S half = math::dot<S>(p.b, p.b) + S(2) * math::dot<S>(p.c, p.a);
        return outwards ? half > S(0) : half < S(0);
    }
    [[nodiscard]] S scale() const { return radius; }
    /// df / d(gap) where they touch.
    [[nodiscard]] S steepness() const { return S(2) * radius; }
    /// When the parabola comes within [margin] (negative: deeper than the gap's zero by as much).
    [[nodiscard]] S on_parabola(const LocalParabola<S>& p, const S& margin, const S& h) const {
        const S s = outwards ? S(radius - margin) : S(radius + margin);
        if (!outwards) {
            return math::first_entry<S>(math::ParabolicApproach<S>{p.c, p.b, p.a, s}, h);
        }
        if (p.a.x() == S(0) && p.a.y() == S(0)) {
            const S t = math::first_exit<S>(p.c, p.b, s, {}, true);
            return t <= h ? t : math::never<S>();
        }
        return math::first_exit<S>(math::ParabolicApproach<S>{p.c, p.b, p.a, s}, h, true);
    }
    /// Whether it certainly stays off for h [s], told by a fraction of the arithmetic.
    [[nodiscard]] bool certainly_off(const LocalParabola<S>& p, const S& margin, const S& h) const {
        return !outwards && math::certainly_outside<S>(
                                p.c, p.b, p.a, S(radius + margin + p.blur), h, math::norm1<S>(p.c),
                                math::norm1<S>(p.b), S(math::kRejectionSlack) * math::epsilon<S>());
    }
};

/// Coming down to the line at [offset] along the unit vector [normal] or, [outwards], up to it:
/// f = n.x - offset or offset - n.x.
template <class Motion>
struct LineCrossing {
    using S = typename Motion::Scalar;
    Motion motion;
    math::Vec<S> normal;
    S offset;
    bool outwards;

    [[nodiscard]] GapAt<S> at(const math::WidePoint<S>& place, const math::Vec<S>& velocity) const {
        using Wide = math::Wide<S>;
        const Wide along = place.x * Wide(normal.x()) + place.y * Wide(normal.y());
        const S gap = math::narrow(Wide(along - offset));
        const S slope = math::accurate_dot<S>(velocity, normal);
        return outwards ? GapAt<S>{S(-gap), S(-slope), S(-gap)} : GapAt<S>{gap, slope, gap};
    }
    [[nodiscard]] S bend(const LocalParabola<S>& p, const S& h, const S& jerk) const {
        return S(2) * math::abs<S>(math::dot<S>(p.a, normal)) + jerk * h;
    }
    [[nodiscard]] bool bends_down(const LocalParabola<S>& p) const {
        const S pull = math::dot<S>(p.a, normal);
        return outwards ? pull > S(0) : pull < S(0);
    }
    [[nodiscard]] S scale() const { return offset; }
    [[nodiscard]] S steepness() const { return S(1); }
    /// The first zero at which the margin is used up, by the form that does not cancel.
    [[nodiscard]] S on_parabola(const LocalParabola<S>& p, const S& margin, const S& h) const {
        const S sign = outwards ? S(-1) : S(1);
        const S gap = at(p.place, p.b).gap - margin;
        const S speed = sign * math::dot<S>(p.b, normal);
        const S pull = sign * math::dot<S>(p.a, normal);
        const S disc = math::difference_of_products<S>(speed, speed, S(4) * pull, gap);
        if (!(disc > S(0))) {
            // Overlapping by rounding, and pulled back before they part.
            const S turn = gap < S(0) && pull < S(0) ? S(-speed / (S(2) * pull)) : math::never<S>();
            return turn <= h ? turn : math::never<S>();
        }
        const S root = math::square_root<S>(disc);
        S t = math::never<S>();
        if (speed < S(0)) {
            t = S(2) * gap / (root - speed);
        } else if (pull < S(0)) {
            t = (speed + root) / (S(-2) * pull);
        }
        return t <= h ? t : math::never<S>();
    }
    [[nodiscard]] bool certainly_off(const LocalParabola<S>& p, const S& margin, const S& h) const {
        return !math::is_finite<S>(on_parabola(p, S(margin + p.blur), h));
    }
};

/// What certified segments come to at most: after so many of them the answer is the time they have
/// reached, at which a gap that rounding does not explain ends a run as `numeric`.
inline constexpr int kMostSegments = 1 << 13;
/// So many say that it pays to look closer.
inline constexpr int kManySegments = 8;

namespace detail {

/// The zero of f on [from, to], where f is certain to fall from f > 0: Newton's iteration on the
/// path itself from x, in a bracket.
template <class Crossing, class S = typename Crossing::S>
[[nodiscard]] S falling_zero(const Crossing& crossing, S from, S to, S x) {
    S last_step = to - from;
    for (int i = 0; i < 4 * math::ScalarTraits<S>::kDigits; ++i) {
        if (!(x > from && x < to)) return to;
        const motion::PathPoint<S> now = crossing.motion.at(x);
        const GapAt<S> f = crossing.at(now.position, now.velocity);
        (f.value > S(0) ? from : to) = x;
        const S step = f.value / f.slope;
        S next = x - step;
        S size = math::abs<S>(step);
        const bool sound = f.slope < S(0);
        if (sound && size <= S(4) * math::epsilon<S>() * math::abs<S>(next)) {
            return std::clamp<S>(next, from, to);
        }
        if (!(sound && next > from && next < to) || (i > 8 && S(2) * size > last_step)) {
            next = from + (to - from) / S(2);
            size = to - from;
            if (!(next > from && next < to)) return to;
        }
        last_step = size;
        x = next;
    }
    return x;
}

/// The longest of rest, rest / 2, rest / 4 ... on which the path stays within [margin] of its
/// parabola at t; [closer]: as far as closer_jerk() can tell.
template <class Motion, class S = typename Motion::Scalar>
[[nodiscard]] S segment_length(const Motion& motion, const S& t, S rest, const S& margin,
                               bool closer) {
    const S most = S(6) * margin;
    for (int i = 0; i < 4 * math::ScalarTraits<S>::kDigits; ++i, rest *= S(0.5)) {
        const S jerk = closer ? motion.closer_jerk(t, rest) : motion.jerk(t, rest);
        const auto within = [&] { return jerk * rest * rest * rest <= most; };
        if (!math::is_finite<S>(jerk) || (closer && !within())) continue;
        // What bounds the jerk on a segment bounds it on the first half.
        for (; rest > S(0) && !within(); ++i) rest *= S(0.5);
        break;
    }
    return rest;
}

/// The longest of rest, rest / 2, rest / 4 ... in which a gap that opens with that slope is certain
/// to go on opening.
template <class Crossing, class S = typename Crossing::S>
[[nodiscard]] S parting_length(const Crossing& crossing, const LocalParabola<S>& p, const S& slope,
                               const S& t, S rest) {
    for (int i = 0; i < 4 * math::ScalarTraits<S>::kDigits; ++i, rest *= S(0.5)) {
        if (rest * crossing.bend(p, rest, crossing.motion.jerk(t, rest)) < slope) break;
    }
    return rest;
}

/// Whether things touch and approach only as rounding has left it.
template <class Crossing, class S = typename Crossing::S>
[[nodiscard]] bool only_touches(const Crossing& crossing, const math::ContactHistory<S>& history) {
    if (history.just_resolved) return true;
    if (!(history.noise > S(0))) return false;
    const LocalParabola<S> p = crossing.motion.parabola(S(0));
    const GapAt<S> f = crossing.at(p.place, p.b);
    return f.gap <= S(math::kTouch) * math::epsilon<S>() * crossing.scale() &&
           -f.slope <= history.noise * crossing.steepness();
}

}  // namespace detail

/// First t in [from, last] at which the gap, closing, is zero or less, or never(), which it may
/// also be if that is after [horizon]; the horizon changes nothing else. [touching]: at `from` they
/// are known to touch, and to part or to be at rest against each other but for rounding; they meet
/// again when they have parted, or have come nearer by a noticeable amount, of what they are now if
/// they close in at less than the [noise] of their speed.
///
/// Nothing is stepped over but what is less than the rounding of the paths, math::kPathNoise
/// epsilon of their lengths, and nothing is found that is more than that away. The error of t is
/// that of the path over the closing speed, and some ulp. Ends always (kMostSegments); no
/// allocation.
template <class Crossing, class S = typename Crossing::S>
[[nodiscard]] S first_certified(const Crossing& crossing, const S& from, const S& last,
                                const S& horizon, bool touching, const S& noise = S(0)) {
    const auto& motion = crossing.motion;
    const S noticeable = S(math::kTouch) * math::epsilon<S>() * crossing.scale();
    S t = from;
    S level = touching ? noticeable : S(0);  // how much deeper than its zero the target is [m]
    for (int n = 0; n < kMostSegments; ++n) {
        const LocalParabola<S> p = motion.parabola(t);
        const GapAt<S> f = crossing.at(p.place, p.b);
        if (!math::is_finite<S>(f.slope + f.gap + p.blur)) return t;  // out of range
        const bool closing = f.slope < S(0) || (f.slope == S(0) && crossing.bends_down(p));
        if (f.gap <= S(0) && !closing) level = noticeable;
        if (n == 0 && touching && f.gap < S(0) && closing &&
            -f.slope <= noise * crossing.steepness()) {
            level = noticeable - f.gap;  // nearer than they are now
        }
        if (n > 0 && f.gap > S(2) * noticeable) level = S(0);
        const S gap = f.gap + level;
        if (gap <= S(0) && closing) return t;
        const S rest = last - t;
        const S wanted = std::min<S>(rest, horizon - t);
        if (!(wanted > S(0))) return math::never<S>();

        if (n == 0 && gap > S(0)) {
            // Most never come near: one parabola for all the way.
            const S margin = motion.jerk(t, wanted) * wanted * wanted * wanted / S(6);
            if (margin + p.blur < gap && crossing.certainly_off(p, margin, wanted)) {
                return math::never<S>();
            }
        }
        if (f.slope < S(0) && level == S(0)) {
            // Certain to fall to zero within twice Newton's step?
            const S h = S(-2) * f.value / f.slope;
            if (h <= rest) {
                const S jerk = motion.jerk(t, h);
                if (h * crossing.bend(p, h, jerk) <= -f.slope / S(2)) {
                    return detail::falling_zero(crossing, t, S(t + h), S(t + h / S(2)));
                }
            }
        }
        const S blur = p.blur + S(2) * math::epsilon<S>() * crossing.scale();
        if (gap < S(-8) * blur && f.slope > S(0)) {  // on its way out from behind a wall
            const S h = detail::parting_length(crossing, p, f.slope, t, rest);
            if (h == rest) return math::never<S>();
            if (t + h > t) {
                t += h;
                continue;
            }
        }
        const bool fine = gap <= S(8) * blur;  // no more to be gained
        const S margin = fine ? blur : S(gap / S(8));
        const S h = detail::segment_length(motion, t, rest, margin, n >= kManySegments);
        const S wait = crossing.on_parabola(p, S((fine ? S(0) : margin) - level), h);
        const bool off = !math::is_finite<S>(wait);
        if (!(t + h > t)) return t;  // out of range
        if (fine && !off) return t + wait;
        if (off && h == rest) return math::never<S>();
        t += off ? h : wait;
    }
    return t;
}

namespace detail {

/// The first such crossing that accept(t) agrees to. What refuses one is past the target, or [past]
/// it from the start, and has to come back by the [opposite] crossing first.
template <class Crossing, class Accept, class S = typename Crossing::S>
[[nodiscard]] S first_accepted(const Crossing& crossing, bool past, const S& last, const S& horizon,
                               bool touching, const S& noise, const Accept& accept) {
    Crossing opposite = crossing;
    opposite.outwards = !crossing.outwards;
    S t(0);
    if (!past) {  // inside of a circle by its opening, or beside the end of a line?
        const motion::PathPoint<S> start = crossing.motion.at(t);
        const S deep = S(2 * math::kTouch) * math::epsilon<S>() * crossing.scale();
        past = crossing.at(start.position, start.velocity).gap < -deep && !accept(t);
    }
    for (int n = 0; n < kMostSegments; ++n, past = touching = true) {
        const S before = t;
        if (past) {
            t = first_certified(opposite, t, last, horizon, touching);
            if (!math::is_finite<S>(t)) return t;
            touching = true;
        }
        t = first_certified(crossing, t, last, horizon, touching, noise);
        if (!math::is_finite<S>(t) || accept(t)) return t;
        if (n > 0 && !(t > before)) break;  // numbers cannot tell one from the next
    }
    return t;
}

}  // namespace detail

/// A little more than a horizon: what comes at it, but for rounding, is found from every start.
/// Times err by more than those of polynomials.
template <math::Scalar S>
[[nodiscard]] S beyond(const S& horizon) {
    return horizon * S(1.0009765625);
}

/// Until when contacts of paths without an end are looked for: until a ball as fast as they are at
/// the start would have gone 2^60 times the distance [m], or once if there is no such time. Others
/// until the [end] of the first.
template <math::Scalar S>
[[nodiscard]] S certified_last(const S& end, const S& distance, const S& speed) {
    if (math::is_finite<S>(end)) return end;
    if (!(speed > S(0))) return S(0);
    for (const S& factor : {S(0x1p60), S(1)}) {
        const S time = factor * (distance / speed);
        if (math::is_finite<S>(time)) return time;
    }
    return S(0);
}

namespace detail {

/// The first contact of paths that start off the target.
template <math::Scalar S, class Crossing>
[[nodiscard]] S first_certified_contact(const Crossing& crossing, const S& end,
                                        const math::ContactHistory<S>& history, const S& horizon) {
    S last = end;
    if (!math::is_finite<S>(last)) {
        const LocalParabola<S> p = crossing.motion.parabola(S(0));
        last = certified_last<S>(end, S(math::norm1<S>(p.c) + crossing.scale()),
                                 crossing.motion.speed());
    }
    return first_certified(crossing, S(0), last, beyond<S>(horizon),
                           only_touches(crossing, history), history.noise);
}

}  // namespace detail

}  // namespace osculo::detect

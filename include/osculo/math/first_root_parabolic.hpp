#pragma once

#include <algorithm>
#include <array>

#include "osculo/math/first_root.hpp"
#include "osculo/math/polynomial.hpp"

/// When does a point on a parabola come down to a circle? The point is at c + b t + a t^2 (a is
/// HALF its acceleration) for 0 <= t <= T, the circle of radius s around the origin. With d = c + b
/// t + a t^2 and v = b + 2 a t: Q = |d|^2 - s^2 is the gap function and D = d.v half its slope, a
/// cubic that rises in the end. The path approaches where D < 0: on at most two intervals, on each
/// of which Q falls (NUMERICS 1.1, 1.2, 1.5).
namespace osculo::math {

/// A parabola and the circle around the origin.
template <Scalar S>
struct ParabolicApproach {
    Vec<S> c, b, a;
    S s;

    [[nodiscard]] Vec<S> place(const S& t) const { return c + t * (b + t * a); }
    [[nodiscard]] Vec<S> velocity(const S& t) const { return b + (S(2) * t) * a; }

    /// D as a cubic.
    [[nodiscard]] Cubic<S> approach() const {
        return {accurate_dot<S>(b, c), S(dot<S>(b, b) + S(2) * accurate_dot<S>(a, c)),
                S(S(3) * accurate_dot<S>(a, b)), S(S(2) * dot<S>(a, a))};
    }
    /// Q(t) in wide precision.
    [[nodiscard]] Wide<S> wide_gap(const S& t) const {
        const auto coordinate = [&t](const S& x, const S& u, const S& w) {
            const Wide<S> speed = wide_product<S>(w, t) + u;
            return Wide<S>(speed * Wide<S>(t) + x);
        };
        const Wide<S> x = coordinate(c.x(), b.x(), a.x());
        const Wide<S> y = coordinate(c.y(), b.y(), a.y());
        return Wide<S>(x * x + y * y) - wide_product<S>(s, s);
    }
    /// Q(t), sure of its sign: in S if the rounding error allows, else in wide precision.
    [[nodiscard]] S gap(const S& t) const {
        const Vec<S> d = place(t);
        const S q = dot<S>(d, d) - s * s;
        if constexpr (Builtin<S>) {
            const S eps = epsilon<S>();
            const auto reach = [&t](const S& x, const S& u, const S& w) {
                return abs<S>(x) + t * (abs<S>(u) + t * abs<S>(w));
            };
            const S mx = reach(c.x(), b.x(), a.x());
            const S my = reach(c.y(), b.y(), a.y());
            const S error =
                S(kRejectionSlack) * eps *
                ((abs<S>(d.x()) + eps * mx) * mx + (abs<S>(d.y()) + eps * my) * my + s * s);
            if (abs<S>(q) <= error) return narrow(wide_gap(t));
        }
        return q;
    }
};

namespace detail {

/// Certain rejections without a root, on the safe side of rounding: no contact in [0, end].
template <Scalar S>
[[nodiscard]] bool certainly_apart(const ParabolicApproach<S>& p, const S& end) {
    const S slack = S(kRejectionSlack) * epsilon<S>();
    const S ss = p.s * p.s;
    const S cc = dot<S>(p.c, p.c);
    const S c1 = norm1<S>(p.c);
    const S b1 = norm1<S>(p.b);
    const S a1 = norm1<S>(p.a);
    // Across b: the part of d there is linear in t^2, so smallest at an end.
    const S across = cross<S>(p.b, p.c);
    const S across_end = across + cross<S>(p.b, p.a) * end * end;
    if ((across > S(0)) == (across_end > S(0))) {
        const S least =
            std::min<S>(abs<S>(across), abs<S>(across_end)) - slack * (b1 * (c1 + a1 * end * end));
        if (least > S(0) && least * least > ss * dot<S>(p.b, p.b) * (S(1) + slack)) return true;
    }
    // Along c: |d| >= d.c / |c|, a quadratic in t.
    const S cb = dot<S>(p.c, p.b);
    const S ca = dot<S>(p.c, p.a);
    S least = std::min<S>(cc, cc + end * (cb + end * ca));
    if (ca > S(0) && cb < S(0) && -cb < S(2) * ca * end) {
        least = std::min<S>(least, cc - cb * cb / (S(4) * ca));
    }
    least -= slack * (cc + c1 * end * (b1 + end * a1));
    return least > S(0) && least * least > ss * cc * (S(1) + slack);
}

/// The root of Q between from and to, where Q changes its sign once, [falling] or rising: Newton's
/// iteration in a bracket, with Q in wide precision.
template <Scalar S>
[[nodiscard]] S crossing(const ParabolicApproach<S>& p, S from, S to, S x, bool falling) {
    S last_step = to - from;
    if (!(x > from && x < to)) x = from + (to - from) / S(2);
    for (int i = 0; i < 4 * ScalarTraits<S>::kDigits; ++i) {
        if (!(x > from && x < to)) return to;
        const S q = narrow(p.wide_gap(x));
        const S slope = S(2) * dot<S>(p.place(x), p.velocity(x));
        ((q > S(0)) == falling ? from : to) = x;
        const S step = q / slope;
        S next = x - step;
        S size = abs<S>(step);
        const bool sound = falling ? slope < S(0) : slope > S(0);
        if (sound && size <= S(4) * epsilon<S>() * abs<S>(next)) {
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

/// The contact within an interval of approach, from <= t <= to, or never(). [turns]: the approach
/// ends at `to` because D = 0 there, so that Q has its minimum.
template <Scalar S>
[[nodiscard]] S contact_within(const ParabolicApproach<S>& p, const S& from, const S& to,
                               bool turns) {
    const S q_from = p.gap(from);
    if (!(q_from > S(0))) return from;  // touching, and now approaching
    const S q_to = p.gap(to);
    if (q_to > S(0)) return never<S>();
    S start = from + (to - from) * (q_from / (q_from - q_to));
    if (turns) {
        // Near its minimum Q is a parabola itself: exact for grazes.
        const Vec<S> v = p.velocity(to);
        const S curvature = dot<S>(v, v) + S(2) * dot<S>(p.place(to), p.a);
        if (curvature > S(0)) start = to - square_root<S>(-q_to / curvature);
    }
    return crossing<S>(p, from, to, start, true);
}

template <Scalar S>
[[nodiscard]] S first_entry(const ParabolicApproach<S>& p, const S& end, bool starts_apart) {
    if (certainly_apart<S>(p, end)) return never<S>();
    const Cubic<S> d = p.approach();
    S fall_from, fall_to;  // D falls between these, if at all
    const bool falls = d.extrema(fall_from, fall_to);

    const bool approaches =
        d.p0 < S(0) || (d.p0 == S(0) && (d.p1 < S(0) || (d.p1 == S(0) && d.p2 < S(0))));
    if (approaches && !starts_apart) {
        S to = end;
        bool turns = false;
        const S top = falls && fall_from > S(0) ? std::min<S>(fall_from, end) : S(0);
        if (top > S(0) && d(top) > S(0)) {
            to = bracketed_root<S>(d, S(0), top, true);
            turns = true;
        } else {
            const S low = falls && fall_to > S(0) ? fall_to : S(0);
            if (low < end && d(end) > S(0)) {
                to = bracketed_root<S>(d, low, end, true);
                turns = true;
            }
        }
        const S t = contact_within<S>(p, S(0), to, turns);
        if (is_finite<S>(t)) return t;
    }
    // The second interval of approach begins where D falls through zero.
    if (!falls || !(fall_to > S(0))) return never<S>();
    const S low = std::max<S>(fall_from, S(0));
    const S high = std::min<S>(fall_to, end);
    if (!(low < high) || d(low) < S(0) || !(d(high) < S(0))) return never<S>();
    const S from = bracketed_root<S>(d, low, high, false);
    S to = end;
    const bool turns = fall_to < end && d(end) > S(0);
    if (turns) to = bracketed_root<S>(d, fall_to, end, true);
    return contact_within<S>(p, from, to, turns);
}

template <Scalar S>
[[nodiscard]] S first_exit(const ParabolicApproach<S>& p, const S& end, bool inside,
                           bool skip_first) {
    const Cubic<S> d = p.approach();
    // The zeros of D, one in each monotone stretch in which its sign changes.
    std::array<S, 4> stretch{S(0), end, end, end};
    std::size_t stretches = 1;
    S fall_from, fall_to;
    if (d.extrema(fall_from, fall_to)) {
        for (const S& t : {fall_from, fall_to}) {
            if (t > S(0) && t < end) stretch[stretches++] = t;
        }
    }
    std::array<S, 5> border{S(0)};
    std::size_t borders = 1;
    for (std::size_t k = 0; k < stretches; ++k) {
        const S low = stretch[k];
        const S high = k + 1 < stretches ? stretch[k + 1] : end;
        const bool rising = d(low) < S(0);
        if (rising != (d(high) < S(0))) border[borders++] = bracketed_root<S>(d, low, high, rising);
    }
    border[borders] = end;
    bool outwards = !(d.p0 < S(0));
    for (std::size_t k = 0; k < borders; ++k, outwards = !outwards) {
        if (!outwards || (k == 0 && skip_first)) continue;
        const S q_from = p.gap(border[k]);
        if (!(q_from < S(0))) {
            if (inside) return border[k];  // it is inside: outside by rounding only
            continue;
        }
        const S q_to = p.gap(border[k + 1]);
        if (q_to < S(0)) continue;
        const S start = border[k] + (border[k + 1] - border[k]) * (q_from / (q_from - q_to));
        return crossing<S>(p, border[k], border[k + 1], start, false);
    }
    return never<S>();
}

}  // namespace detail

/// First t in [0, end] at which the point, approaching, is at or inside the circle: Q <= 0 and
/// D < 0; never() if there is none.
///
/// [end] finite unless a = 0. Requires s > 0. With `history.just_resolved` the two are known to
/// touch and to part at t = 0, whatever rounding makes of Q and D there. No contact is missed or
/// invented; error below 2 ulp of t but for grazes of 1e-16 of the radius (86 ulp). No allocation.
template <Scalar S>
[[nodiscard]] S first_entry(const ParabolicApproach<S>& p, const S& end,
                            const ContactHistory<S>& history = {}, const S& horizon = never<S>()) {
    if (p.a.x() == S(0) && p.a.y() == S(0)) {
        const S t = first_entry<S>(p.c, p.b, p.s, history, std::min<S>(horizon, end));
        return t <= end ? t : never<S>();
    }
    const S last = std::min<S>(end, horizon);
    const S slope = accurate_dot<S>(p.b, p.c);
    const bool approaches =
        slope < S(0) || (slope == S(0) && dot<S>(p.b, p.b) + S(2) * dot<S>(p.a, p.c) < S(0));
    if (!approaches) return detail::first_entry<S>(p, last, history.just_resolved);
    const bool touching =
        history.just_resolved || (history.noise > S(0) && -slope <= history.noise * p.s &&
                                  p.gap(S(0)) <= S(2 * kTouch) * epsilon<S>() * p.s * p.s);
    if (!touching) return detail::first_entry<S>(p, last, false);
    // They touch, and approach only as rounding left it or because they are pulled together: they
    // meet when they have come nearer by a noticeable amount, as in uniform motion.
    const ParabolicApproach<S> nearer{p.c, p.b, p.a, S(p.s * (S(1) - S(kTouch) * epsilon<S>()))};
    return detail::first_entry<S>(nearer, last, false);
}

/// First t in [0, end] at which the point, moving outwards, is at or outside of the circle, having
/// been inside; never() if there is none. A point that is [inside] is so up to rounding. With
/// [skip_first] a stretch of outward motion at the start is passed over.
///
/// [end] finite. Requires s > 0 and a != 0. Errors as for first_entry().
template <Scalar S>
[[nodiscard]] S first_exit(const ParabolicApproach<S>& p, const S& end, bool inside,
                           bool skip_first = false) {
    return detail::first_exit<S>(p, end, inside, skip_first);
}

}  // namespace osculo::math

#pragma once

#include <algorithm>
#include <array>

#include "osculo/math/certainly_outside.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/math/polynomial.hpp"

/// When does a point on a parabola come down to a circle? The point is at c + b t + a t^2 (a is
/// HALF its acceleration) for 0 <= t <= T, the circle of radius s around the origin. With d = c + b
/// t + a t^2 and v = b + 2 a t: Q = |d|^2 - s^2 is the gap function and D = d.v half its slope, a
/// cubic that rises in the end. The path approaches where D < 0: on at most two intervals, on each
/// of which Q falls (NUMERICS 1.1, 1.2, 1.5).
namespace osculo::math {

namespace detail {

/// A zero of D, or the end of the path.
template <Scalar S>
struct Turn {
    S time;
    bool turns = false;  ///< D = 0: Q has a minimum or a maximum
    S error = S(0);      ///< of Q there, because the time is rounded
};

}  // namespace detail

/// A parabola and the circle around the origin.
template <Scalar S>
struct ParabolicApproach {
    Vec<S> c, b, a;
    S s;
    mutable Wide<S> start_gap_value{};  ///< by start_gap(), as the next
    mutable bool start_gap_known = false;

    [[nodiscard]] Vec<S> place(const S& t) const { return c + t * (b + t * a); }
    [[nodiscard]] Vec<S> velocity(const S& t) const { return b + (S(2) * t) * a; }

    /// D as a cubic.
    [[nodiscard]] Cubic<S> approach() const {
        return {accurate_dot<S>(b, c), narrow(half_curvature()), S(S(3) * accurate_dot<S>(a, b)),
                S(S(2) * dot<S>(a, a))};
    }
    /// |b|^2 + 2 a.c = Q''(0) / 2, in wide precision: the two may all but cancel.
    [[nodiscard]] Wide<S> half_curvature() const {
        return wide_dot<S>(b, b) + wide_dot<S>(a, c) * Wide<S>(S(2));
    }
    /// D(t) in wide precision, to a relative error where t is small.
    [[nodiscard]] Wide<S> wide_approach(const S& t) const {
        const Wide<S> time(t);
        Wide<S> sum = wide_dot<S>(a, a) * time;
        sum = Wide<S>(sum * Wide<S>(S(2)) + wide_dot<S>(a, b) * Wide<S>(S(3))) * time;
        sum = Wide<S>(sum + half_curvature()) * time;
        return sum + wide_dot<S>(b, c);
    }
    /// Q(0) to all digits. Where the two touch that takes as long as all the rest: once is enough.
    [[nodiscard]] const Wide<S>& start_gap() const {
        if (!start_gap_known) start_gap_value = detail::gap_function<S>(c, s);
        start_gap_known = true;
        return start_gap_value;
    }
    /// Whether the way until t is shorter than s.
    [[nodiscard]] bool starts_near(const S& t) const {
        return t * (norm1<S>(b) + t * norm1<S>(a)) <= s;
    }
    /// Q(t) in wide precision. After a way of less than s as a polynomial in t, whose first term
    /// is exact (a gap however small, soon closed, has all its digits); later from the place, the
    /// rounding of which hardly depends on how far away it started.
    [[nodiscard]] Wide<S> wide_gap(const S& t) const {
        if (t == S(0)) return start_gap();
        if (starts_near(t)) {
            const Wide<S> time(t);
            Wide<S> sum = wide_dot<S>(a, a) * time;
            sum = Wide<S>(sum + wide_dot<S>(a, b) * Wide<S>(S(2))) * time;
            sum = Wide<S>(sum + half_curvature()) * time;
            sum = Wide<S>(sum + wide_dot<S>(b, c) * Wide<S>(S(2))) * time;
            return sum + start_gap();
        }
        const auto coordinate = [&t](const S& x, const S& u, const S& w) {
            const Wide<S> speed = wide_product<S>(w, t) + u;
            return Wide<S>(speed * Wide<S>(t) + x);
        };
        const Wide<S> x = coordinate(c.x(), b.x(), a.x());
        const Wide<S> y = coordinate(c.y(), b.y(), a.y());
        return Wide<S>(x * x + y * y) - wide_product<S>(s, s);
    }
    /// Error of Q(t) computed in S for a place [d] = place(t).
    [[nodiscard]] S gap_error(const S& t, const Vec<S>& d) const {
        const S eps = epsilon<S>();
        const auto reach = [&t](const S& x, const S& u, const S& w) {
            return abs<S>(x) + t * (abs<S>(u) + t * abs<S>(w));
        };
        const S mx = reach(c.x(), b.x(), a.x());
        const S my = reach(c.y(), b.y(), a.y());
        return S(kRejectionSlack) * eps *
               ((abs<S>(d.x()) + eps * mx) * mx + (abs<S>(d.y()) + eps * my) * my + s * s);
    }
    /// Q(t), sure of its sign: in S if the rounding error allows, else in wide precision.
    [[nodiscard]] S gap(const S& t) const {
        const Vec<S> d = place(t);
        const S q = dot<S>(d, d) - s * s;
        if constexpr (Builtin<S>) {
            if (abs<S>(q) <= gap_error(t, d)) return narrow(wide_gap(t));
        }
        return q;
    }
    /// Error of Q(t) in wide precision, generously, over epsilon^2. Small where t is.
    [[nodiscard]] S wide_gap_error(const S& t, const Vec<S>& d) const {
        if (!starts_near(t)) return S(kTangent) * gap_error(t, d) / epsilon<S>();
        S start = abs<S>(narrow(start_gap()));
        if (start > S(kExactStage) * epsilon<S>() * s * s) start += S(2) * s * s;  // not exact
        const S bent = dot<S>(b, b) + S(2) * abs<S>(dot<S>(a, c));
        return S(kTangent * kRejectionSlack) *
               (start + t * (S(2) * abs<S>(accurate_dot<S>(b, c)) +
                             t * (bent + t * (S(2) * abs<S>(dot<S>(a, b)) + t * dot<S>(a, a)))));
    }
    /// Q at a turn or end. Where it all but vanishes at a turn, that is made sharper, and Q is 0 if
    /// it is a touch without contact to all digits there are.
    [[nodiscard]] S gap_at(detail::Turn<S>& turn) const {
        if (!turn.turns) return gap(turn.time);
        const Vec<S> d = place(turn.time);
        const S q = dot<S>(d, d) - s * s;
        if constexpr (Builtin<S>) {
            if (abs<S>(q) <= gap_error(turn.time, d) + turn.error) {
                turn.time = sharpened_turn(turn.time);
                // Go on to the true root of D, on the parabola that Q is there.
                const S slope = narrow(wide_approach(turn.time));
                const S beyond = slope * slope / bend(turn.time);
                const bool sound = abs<S>(beyond) <= turn.error;
                const S extreme = narrow(Wide<S>(wide_gap(turn.time) - (sound ? beyond : S(0))));
                const S least = epsilon<S>() * epsilon<S>() * wide_gap_error(turn.time, d);
                return abs<S>(extreme) <= least ? S(0) : extreme;
            }
        }
        return q;
    }
    /// Q''(t) / 2 = D'(t).
    [[nodiscard]] S bend(const S& t) const {
        const Vec<S> v = velocity(t);
        return dot<S>(v, v) + S(2) * dot<S>(place(t), a);
    }
    /// The root of D near [t], where the contact is if the two touch there: to all digits.
    [[nodiscard]] S sharpened_turn(S t) const {
        if constexpr (Builtin<S>) {
            for (int i = 0; i < 3; ++i) {
                const S step = narrow(wide_approach(t)) / bend(t);
                if (!(abs<S>(step) < S(0x1p-16) * t)) break;  // a double root has no more digits
                t -= step;
                if (abs<S>(step) <= epsilon<S>() * t) break;
            }
        }
        return t;
    }
};

namespace detail {

/// Certain rejection without a root, on the safe side of rounding: no contact in [0, end].
template <Scalar S>
[[nodiscard]] bool certainly_apart(const ParabolicApproach<S>& p, const S& end) {
    return certainly_outside<S>(p.c, p.b, p.a, p.s, end, norm1<S>(p.c), norm1<S>(p.b),
                                S(kRejectionSlack) * epsilon<S>());
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

/// The zeros of D in (0, end], one after the other.
template <Scalar S>
class Turns {
public:
    Turns(const ParabolicApproach<S>& p, const S& end) : p_(p), d_(p.approach()), end_(end) {
        S first(0);
        S last(0);
        if (!d_.extrema(first, last)) return;
        for (const S& t : {first, last}) {
            if (t > S(0) && t < end) stretch_ends_[stretches_++] = t;
        }
    }

    /// Whether D is negative at t = 0 or just after.
    [[nodiscard]] bool starts_falling() const {
        for (const S* x : {&d_.p0, &d_.p1, &d_.p2}) {
            if (*x != S(0)) return *x < S(0);
        }
        return false;  // p3 >= 0
    }

    /// The next zero, before which D is negative or not; else the end.
    [[nodiscard]] Turn<S> next(bool negative) {
        for (; stretch_ <= stretches_; low_ = high(), ++stretch_) {
            if (done_ || negative == (sure_value(high()) < S(0))) {
                done_ = false;
                continue;
            }
            done_ = true;  // D is monotone in a stretch: this was its only zero
            return zero(low_, high(), negative);
        }
        return {end_, turns_at_end()};
    }

private:
    [[nodiscard]] const S& high() const {
        return stretch_ < stretches_ ? stretch_ends_[stretch_] : end_;
    }
    [[nodiscard]] S noise(const S& t) const {
        return S(2 * kRejectionSlack) * epsilon<S>() * d_.size(t);
    }
    /// Whether D = 0 at the end, as where a ball comes to rest or a path ends in a tangent.
    [[nodiscard]] bool turns_at_end() const {
        const S least = S(kTangent) * epsilon<S>() * noise(end_);
        return abs<S>(sure_value(end_)) <= (Builtin<S> ? least : S(0));
    }
    /// D, sure of its sign.
    [[nodiscard]] S sure_value(const S& t) const {
        const S value = d_(t);
        if constexpr (Builtin<S>) {
            if (abs<S>(value) <= noise(t)) return narrow(p_.wide_approach(t));
        }
        return value;
    }
    [[nodiscard]] Turn<S> zero(const S& low, const S& high, bool rising) const {
        const S t = bracketed_root<S>(d_, low, high, rising);
        if constexpr (Builtin<S>) {
            const S blur = noise(t);
            const S bend = abs<S>(d_.slope(t));
            if (blur < S(0x1p-32) * bend * t) return {t, true, blur * (blur / bend)};
            // Nearly a multiple zero, as where a ball comes to rest: more digits are needed.
            struct WideD {
                const Turns& turns;
                S operator()(const S& x) const { return narrow(turns.p_.wide_approach(x)); }
                S slope(const S& x) const { return turns.d_.slope(x); }
            };
            return {bracketed_root<S>(WideD{*this}, low, high, rising), true};
        }
        return {t, true};
    }

    const ParabolicApproach<S>& p_;
    Cubic<S> d_;
    S end_;
    std::array<S, 2> stretch_ends_{};  ///< D is monotone up to each, and from there to the end
    std::size_t stretches_ = 0;
    std::size_t stretch_ = 0;
    S low_ = S(0);
    bool done_ = false;  ///< the zero of this stretch has been given
};

/// Accepts every contact.
struct AnyContact {
    template <class S>
    [[nodiscard]] bool operator()(const S&) const {
        return true;
    }
};

/// The contact while Q falls between two turns, or never().
template <Scalar S>
[[nodiscard]] S entry_within(const ParabolicApproach<S>& p, Turn<S> from, Turn<S> to) {
    const S q_from = p.gap_at(from);
    if (q_from < S(0) || (q_from == S(0) && !from.turns)) {
        return p.sharpened_turn(from.time);  // touching, and now approaching
    }
    const S q_to = p.gap_at(to);
    if (q_from == S(0)) return q_to < S(0) ? p.sharpened_turn(from.time) : never<S>();
    if (to.turns ? !(q_to < S(0)) : q_to > S(0)) return never<S>();
    S start = from.time + (to.time - from.time) * (q_from / (q_from - q_to));
    if (to.turns) {
        // Near its minimum Q is a parabola itself: exact for grazes.
        const S bend = p.bend(to.time);
        if (bend > S(0)) start = to.time - square_root<S>(-q_to / bend);
    }
    return crossing<S>(p, from.time, to.time, start, true);
}

template <Scalar S, class Accept>
[[nodiscard]] S first_entry(const ParabolicApproach<S>& p, const S& end, bool starts_apart,
                            const Accept& accept) {
    if (certainly_apart<S>(p, end)) return never<S>();
    Turns<S> turns(p, end);
    bool approaching = turns.starts_falling();
    bool possible = !starts_apart;
    Turn<S> from{S(0)};
    for (;; approaching = !approaching, possible = true) {
        const Turn<S> to = turns.next(approaching);
        if (approaching && possible) {
            const S t = entry_within<S>(p, from, to);
            if (is_finite<S>(t) && accept(t)) return t;
        }
        if (!(to.time < end)) return never<S>();
        from = to;
    }
}

template <Scalar S, class Accept>
[[nodiscard]] S first_exit(const ParabolicApproach<S>& p, const S& end, bool inside,
                           const Accept& accept) {
    if (!inside && certainly_apart<S>(p, end)) return never<S>();
    Turns<S> turns(p, end);
    bool inwards = turns.starts_falling();
    Turn<S> from{S(0)};
    for (;; inwards = !inwards) {
        Turn<S> to = turns.next(inwards);
        const S q_from = inwards ? S(0) : p.gap_at(from);
        if (!inwards && q_from < S(0)) {
            const S q_to = p.gap_at(to);
            if (to.turns ? q_to > S(0) : !(q_to < S(0))) {
                const S start = from.time + (to.time - from.time) * (q_from / (q_from - q_to));
                const S t = crossing<S>(p, from.time, to.time, start, false);
                if (accept(t)) return t;
                inside = false;
            }
        } else if (!inwards) {
            // Outside: by rounding only, if it was inside.
            const S t = p.sharpened_turn(from.time);
            if (inside && accept(t)) return t;
            inside = false;
        }
        if (!(to.time < end)) return never<S>();
        from = to;
    }
}

}  // namespace detail

/// First t in [0, end] at which the point, approaching, is at or inside the circle: Q <= 0 and
/// D < 0, and which [accept](t) agrees to; never() if there is none.
///
/// [end] finite unless a = 0, where accept is not asked. Requires s > 0. With
/// `history.just_resolved` the two are known to touch and to part at t = 0, whatever rounding makes
/// of Q and D there. For double and long double no contact is missed or invented but touches of
/// less than some 1e-30 of the place, and the error of t is below 1 ulp but where the circle is
/// crossed without speed (bench/README.md). No allocation.
template <Scalar S, class Accept = detail::AnyContact>
[[nodiscard]] S first_entry(const ParabolicApproach<S>& p, const S& end,
                            const ContactHistory<S>& history = {}, const S& horizon = never<S>(),
                            const Accept& accept = {}) {
    if (p.a.x() == S(0) && p.a.y() == S(0)) {
        const S t = first_entry<S>(p.c, p.b, p.s, history, std::min<S>(horizon, end));
        return t <= end ? t : never<S>();
    }
    const S last = std::min<S>(end, horizon);
    const S slope = accurate_dot<S>(p.b, p.c);
    const bool approaches =
        slope < S(0) || (slope == S(0) && dot<S>(p.b, p.b) + S(2) * dot<S>(p.a, p.c) < S(0));
    if (!approaches) return detail::first_entry<S>(p, last, history.just_resolved, accept);
    const bool touching =
        history.just_resolved || (history.noise > S(0) && -slope <= history.noise * p.s &&
                                  p.gap(S(0)) <= S(2 * kTouch) * epsilon<S>() * p.s * p.s);
    if (!touching) return detail::first_entry<S>(p, last, false, accept);
    // They touch, and approach only as rounding left it or because they are pulled together: they
    // meet when they have come nearer by a noticeable amount, as in uniform motion.
    const ParabolicApproach<S> nearer{p.c, p.b, p.a, S(p.s * (S(1) - S(kTouch) * epsilon<S>()))};
    return detail::first_entry<S>(nearer, last, false, accept);
}

/// First t in [0, end] at which the point, moving outwards, is at or outside of the circle, having
/// been inside, and which [accept](t) agrees to; never() if there is none. A point that is
/// [inside] is so up to rounding, until accept refuses.
///
/// [end] finite. Requires s > 0 and a != 0. Errors as for first_entry().
template <Scalar S, class Accept = detail::AnyContact>
[[nodiscard]] S first_exit(const ParabolicApproach<S>& p, const S& end, bool inside,
                           const Accept& accept = {}) {
    return detail::first_exit<S>(p, end, inside, accept);
}

}  // namespace osculo::math

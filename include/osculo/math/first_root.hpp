#pragma once

#include <cmath>

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/exact_sum.hpp"
#include "osculo/math/vec.hpp"

/// When does a point in straight uniform motion cross a circle? The point is at c + b t, the circle
/// of radius s around the origin; Q = |c + b t|^2 - s^2 is the gap function and b.(c + b t) half
/// its slope.
namespace osculo::math {

/// What is known of a contact before its time is asked for.
template <Scalar S>
struct ContactHistory {
    /// The last thing that happened to each of the two was their contact with each other: they
    /// touch, and the root of the gap function at zero is that contact.
    bool just_resolved = false;
    /// Rounding noise of the closing speed [m/s]; 0 for velocities that are data.
    S noise = S(0);
};

namespace detail {

/// |c|^2 - s^2. For the built-in types the sign is exact and the error far below one ulp.
template <Scalar S>
[[nodiscard]] Wide<S> gap_function(const Vec<S>& c, const S& s) {
    const Wide<S> ss = wide_product<S>(s, s);
    const Wide<S> gap = wide_dot<S>(c, c) - ss;
    if constexpr (Builtin<S>) {
        if (cancelled(gap, ss)) {
            ExactSum<S, 6> sum;
            sum.add_product(c.x(), c.x());
            sum.add_product(c.y(), c.y());
            sum.add_product(-s, s);
            return sum.value();
        }
    }
    return gap;
}

/// s^2 b^2 - (b x c)^2, as precise: a quarter of the discriminant of the gap function, for
/// b^2 c^2 - (b.c)^2 = (b x c)^2 (Lagrange).
template <Scalar S>
[[nodiscard]] Wide<S> discriminant(const Vec<S>& c, const Vec<S>& b, const S& s) {
    const Wide<S> ss = wide_product<S>(s, s);
    const Wide<S> moment = wide_cross<S>(b, c);
    const Wide<S> most = ss * wide_dot<S>(b, b);
    const Wide<S> result = most - moment * moment;
    if constexpr (Builtin<S>) {
        if (cancelled(result, most)) {
            const DoubleDouble<S> xx = two_product(b.x(), b.x());
            const DoubleDouble<S> yy = two_product(b.y(), b.y());
            const DoubleDouble<S> xy = two_product(b.x(), c.y());
            const DoubleDouble<S> yx = two_product(b.y(), c.x());
            ExactSum<S, 48> sum;
            for (const S p : {ss.lo, ss.hi}) {
                for (const S q : {xx.lo, yy.lo, xx.hi, yy.hi}) sum.add_product(p, q);
            }
            const std::array<S, 4> terms{xy.lo, -yx.lo, xy.hi, -yx.hi};
            for (const S p : terms) {
                for (const S q : terms) sum.add_product(-p, q);
            }
            return sum.value();
        }
    }
    return result;
}

/// Whether squares of squares of the lengths and speeds of a problem stay in range.
template <Scalar S>
[[nodiscard]] bool ordinary(const S& length, const S& speed) {
    constexpr double kLeast = 1e-40;
    constexpr double kMost = 1e40;
    return length > S(kLeast) && length < S(kMost) && speed > S(kLeast) && speed < S(kMost);
}

/// Solves the problem scaled by powers of two such that squares of squares stay in range. Exact.
template <Scalar S, class Solver>
[[nodiscard]] S with_safe_exponents(const Vec<S>& c, const Vec<S>& b, const S& s,
                                    ContactHistory<S> history, const S& horizon, Solver solve) {
    if constexpr (ScalarTraits<S>::kNarrowExponent) {
        const S length = std::max(norm_max<S>(c), s);
        const S speed = norm_max<S>(b);
        if (!ordinary<S>(length, speed) && speed > S(0)) {
            const int length_exponent = std::ilogb(length);
            const int speed_exponent = std::ilogb(speed);
            // In two steps: one factor could itself be out of range.
            const auto scaled = [](S x, int e) {
                return std::ldexp(std::ldexp(x, e / 2), e - e / 2);
            };
            const auto scaled_vec = [&](const Vec<S>& v, int e) {
                return Vec<S>(scaled(v.x(), e), scaled(v.y(), e));
            };
            const int time_exponent = length_exponent - speed_exponent;
            history.noise = scaled(history.noise, -speed_exponent);
            const S t = solve(scaled_vec(c, -length_exponent), scaled_vec(b, -speed_exponent),
                              scaled(s, -length_exponent), history,
                              is_finite<S>(horizon) ? scaled(horizon, -time_exponent) : horizon);
            return is_finite<S>(t) ? scaled(t, time_exponent) : t;
        }
    }
    return solve(c, b, s, history, horizon);
}

/// When two things that touch, and approach only as rounding left it, have come nearer by a
/// noticeable kTouch epsilon s; never() if they pass before. Then they meet again, and what
/// approach is left has the rounding of the speeds they have by then: however fast they once were,
/// they do not sink into each other. With [slope] = b.c < 0, [bb] = |b|^2, [ss] = s^2.
template <Scalar S>
[[nodiscard]] S noticed_approach(const S& slope, const S& bb, const S& ss) {
    const S noticeable = S(2 * kTouch) * epsilon<S>() * ss;  // change of |c + b t|^2
    const S disc = slope * slope - bb * noticeable;
    return disc > S(0) ? S(noticeable / (square_root<S>(disc) - slope)) : never<S>();
}

/// Cheap rejections, on the safe side of rounding: the line of the path passes the circle by.
/// [blur] bounds the error of b x c.
template <Scalar S>
[[nodiscard]] bool certainly_beside(const Vec<S>& c, const Vec<S>& b, const S& s, const S& blur,
                                    const S& slack) {
    const S lateral = abs<S>(cross<S>(b, c)) - blur;
    return lateral > S(0) && lateral * lateral > (s * s) * dot<S>(b, b) * (S(1) + slack);
}

/// The path to the contact is at least Q / (-2 slope) long in time, since sqrt(disc) <= -slope.
/// [slope] may be less than b.c; [blur] bounds an error of |c|^2 beyond rounding.
template <Scalar S>
[[nodiscard]] bool certainly_later(const Vec<S>& c, const S& s, const S& slope, const S& blur,
                                   const S& horizon, const S& slack) {
    const S cc = dot<S>(c, c);
    const S ss = s * s;
    return (cc - ss) - (slack * (cc + ss) + blur) > -S(2) * slope * horizon * (S(1) + slack);
}

template <Scalar S>
[[nodiscard]] S first_entry(const Vec<S>& c, const Vec<S>& b, const S& s,
                            const ContactHistory<S>& history, const S& horizon) {
    // Most pairs are told apart without exact arithmetic.
    const S slack = S(kRejectionSlack) * epsilon<S>();
    const S blur = slack * (norm1<S>(b) * norm1<S>(c));
    const S rounded_slope = dot<S>(b, c);
    if (rounded_slope > blur) return never<S>();
    if (!history.just_resolved) {
        if (certainly_beside<S>(c, b, s, blur, slack)) return never<S>();
        if (certainly_later<S>(c, s, rounded_slope - blur, S(0), horizon, slack)) return never<S>();
    }
    const S slope = accurate_dot<S>(b, c);
    if (!(slope < S(0))) return never<S>();  // not approaching now, so never
    const S bb = dot<S>(b, b);
    const S ss = s * s;
    if (history.just_resolved) return noticed_approach<S>(slope, bb, ss);

    const Wide<S> gap = gap_function<S>(c, s);
    if (history.noise > S(0) && narrow(gap) <= S(2 * kTouch) * epsilon<S>() * ss &&
        -slope <= history.noise * s) {
        return noticed_approach<S>(slope, bb, ss);
    }
    if (gap <= Wide<S>(S(0))) return S(0);

    const Wide<S> disc = discriminant<S>(c, b, s);
    if (!(disc > Wide<S>(S(0)))) return never<S>();  // a miss, or a touch without approach
    return quotient(gap, Wide<S>(wide_square_root(disc) - wide_dot<S>(b, c)));
}

template <Scalar S>
[[nodiscard]] S first_exit(const Vec<S>& c, const Vec<S>& b, const S& s,
                           const ContactHistory<S>& history, bool inside) {
    const Wide<S> bb = wide_dot<S>(b, b);
    if (!(bb > Wide<S>(S(0)))) return never<S>();
    const Wide<S> slope = wide_dot<S>(b, c);
    const bool inwards = slope < Wide<S>(S(0));
    if (history.just_resolved && !inwards) return S(0);
    const Wide<S> gap = gap_function<S>(c, s);
    if (!inwards && gap >= Wide<S>(S(0))) return S(0);
    const Wide<S> disc = discriminant<S>(c, b, s);
    if (!(disc > Wide<S>(S(0)))) {
        // On the circle but for rounding the gap function is t (2 slope + |b|^2 t). Where there is
        // a discriminant its root is taken instead: it does not hand the rounding of this contact
        // on to the next one, and so to all that follow.
        if (history.just_resolved) return quotient(Wide<S>(-slope - slope), bb);
        // Outside throughout: only by rounding if it is known to be inside, and then it moves
        // outwards from where it is closest to the centre.
        return inside ? quotient(Wide<S>(-slope), bb) : never<S>();
    }
    const Wide<S> root = wide_square_root(disc);
    return inwards ? quotient(Wide<S>(root - slope), bb) : quotient(Wide<S>(-gap), root + slope);
}

}  // namespace detail

/// True only if first_entry() would find nothing, or nothing before [horizon], for a point within
/// [error] of c (in the sum of both coordinates). For pairs that have not just been resolved.
template <Scalar S>
[[nodiscard]] bool certainly_no_entry(const Vec<S>& c, const S& error, const Vec<S>& b, const S& s,
                                      const S& horizon) {
    if constexpr (ScalarTraits<S>::kNarrowExponent) {
        if (!detail::ordinary<S>(std::max(norm_max<S>(c), s), norm_max<S>(b))) return false;
    }
    const S slack = S(kRejectionSlack) * epsilon<S>();
    const S size = norm1<S>(c);
    const S speed = norm1<S>(b);
    const S blur = speed * (slack * size + error);
    const S slope = dot<S>(b, c);
    return slope > blur || detail::certainly_beside<S>(c, b, s, blur, slack) ||
           detail::certainly_later<S>(c, s, S(slope - blur), S(S(3) * size * error), horizon,
                                      slack);
}

/// First t >= 0 at which the point, approaching, is at or inside the circle: Q <= 0 and slope < 0
/// (NUMERICS 1.1, 1.3); never() if there is none, or if it is certainly later than [horizon].
///
/// A tangent path is no contact. Requires s > 0, finite c and b. For double and long double no
/// contact is missed or invented and the error of t is below 1 ulp; for the wider types both hold
/// up to their own rounding of Q. One division, at most one square root; no allocation.
template <Scalar S>
[[nodiscard]] S first_entry(const Vec<S>& c, const Vec<S>& b, const S& s,
                            const ContactHistory<S>& history = {}, const S& horizon = never<S>()) {
    return detail::with_safe_exponents<S>(c, b, s, history, horizon, detail::first_entry<S>);
}

/// First t >= 0 at which the point, moving outwards, is at or outside of the circle, having been
/// inside: the contact of a ball with a circle around it. never() if it never gets inside; but a
/// point that is [inside] is so up to rounding, wherever c puts it.
///
/// Errors as for first_entry(). Requires s > 0, finite c and b.
template <Scalar S>
[[nodiscard]] S first_exit(const Vec<S>& c, const Vec<S>& b, const S& s,
                           const ContactHistory<S>& history = {}, bool inside = false) {
    return detail::with_safe_exponents<S>(
        c, b, s, history, never<S>(),
        [inside](const Vec<S>& c_, const Vec<S>& b_, const S& s_, const ContactHistory<S>& history_,
                 const S&) { return detail::first_exit<S>(c_, b_, s_, history_, inside); });
}

}  // namespace osculo::math

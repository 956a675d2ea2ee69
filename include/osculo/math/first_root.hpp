#pragma once

#include <cmath>

#include "osculo/math/error_bounds.hpp"
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

/// Solves the problem scaled by powers of two such that squares of squares stay in range. Exact.
template <Scalar S, class Solver>
[[nodiscard]] S with_safe_exponents(const Vec<S>& c, const Vec<S>& b, const S& s,
                                    ContactHistory<S> history, const S& horizon, Solver solve) {
    if constexpr (ScalarTraits<S>::kNarrowExponent) {
        const auto ordinary = [](S x) { return x > S(1e-60) && x < S(1e60); };
        const S length = std::max(norm_max<S>(c), s);
        const S speed = norm_max<S>(b);
        if (!(ordinary(length) && ordinary(speed)) && speed > S(0)) {
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

template <Scalar S>
[[nodiscard]] S first_entry(const Vec<S>& c, const Vec<S>& b, const S& s,
                            const ContactHistory<S>& history, const S& horizon) {
    const S slope = accurate_dot<S>(b, c);
    if (!(slope < S(0))) return never<S>();  // not approaching now, so never

    // Cheap rejections, on the safe side of rounding.
    const S slack = S(kRejectionSlack) * epsilon<S>();
    const S cc = dot<S>(c, c);
    const S bb = dot<S>(b, b);
    const S ss = s * s;
    const S lateral = abs<S>(cross<S>(b, c)) - slack * (norm1<S>(b) * norm1<S>(c));
    if (lateral > S(0) && lateral * lateral > ss * bb * (S(1) + slack)) return never<S>();
    // The path to the contact is at least Q / (-2 slope) long in time, since sqrt(disc) <= -slope.
    if ((cc - ss) - slack * (cc + ss) > -S(2) * slope * horizon * (S(1) + slack)) return never<S>();

    const Wide<S> wide_ss = wide_product<S>(s, s);
    const Wide<S> gap = wide_dot<S>(c, c) - wide_ss;
    if (history.noise > S(0) && narrow(gap) <= S(kTouch) * epsilon<S>() * ss &&
        -slope <= history.noise * s) {
        return never<S>();
    }
    if (gap <= Wide<S>(S(0))) return S(0);

    // b^2 c^2 - (b.c)^2 = (b x c)^2 (Lagrange) gives the discriminant without cancelling squares.
    const Wide<S> moment = wide_cross<S>(b, c);
    const Wide<S> discriminant = wide_ss * wide_dot<S>(b, b) - moment * moment;
    if (!(discriminant > Wide<S>(S(0)))) return never<S>();  // a miss, or a touch without approach
    return quotient(gap, Wide<S>(wide_square_root(discriminant) - wide_dot<S>(b, c)));
}

template <Scalar S>
[[nodiscard]] S first_exit(const Vec<S>& c, const Vec<S>& b, const S& s,
                           const ContactHistory<S>& history, const S& /*horizon*/) {
    const S bb = dot<S>(b, b);
    if (!(bb > S(0))) return never<S>();
    const S slope = accurate_dot<S>(b, c);
    if (history.just_resolved) {  // the gap function is t (2 slope + |b|^2 t)
        return slope < S(0) ? S(-S(2) * slope / bb) : S(0);
    }
    const Wide<S> wide_ss = wide_product<S>(s, s);
    const Wide<S> gap = wide_dot<S>(c, c) - wide_ss;
    if (!(slope < S(0)) && gap >= Wide<S>(S(0))) return S(0);
    const Wide<S> moment = wide_cross<S>(b, c);
    const Wide<S> discriminant = wide_ss * wide_dot<S>(b, b) - moment * moment;
    if (!(discriminant > Wide<S>(S(0)))) return never<S>();  // passes by without being inside
    const Wide<S> root = wide_square_root(discriminant);
    const Wide<S> wide_slope = wide_dot<S>(b, c);
    if (slope < S(0)) return quotient(Wide<S>(root - wide_slope), wide_dot<S>(b, b));
    return quotient(Wide<S>(-gap), Wide<S>(root + wide_slope));
}

}  // namespace detail

/// First t >= 0 at which the point, approaching, is at or inside the circle: Q <= 0 and slope < 0
/// (NUMERICS 1.1, 1.3); never() if there is none, or if it is certainly later than [horizon].
///
/// A tangent path is no contact. Requires s > 0, finite c and b. For double and long double no
/// contact is missed or invented and the error of t is below 1 ulp; for the wider types both hold
/// up to their own rounding of Q. One division, at most one square root; no allocation.
template <Scalar S>
[[nodiscard]] S first_entry(const Vec<S>& c, const Vec<S>& b, const S& s,
                            const ContactHistory<S>& history = {}, const S& horizon = never<S>()) {
    // Straight apart: having just collided, the two do not meet again on this motion.
    if (history.just_resolved) return never<S>();
    return detail::with_safe_exponents<S>(c, b, s, history, horizon, detail::first_entry<S>);
}

/// First t >= 0 at which the point, moving outwards, is at or outside of the circle, having been
/// inside: the contact of a ball with a circle around it. never() if it never gets inside.
///
/// Errors as for first_entry(). Requires s > 0, finite c and b.
template <Scalar S>
[[nodiscard]] S first_exit(const Vec<S>& c, const Vec<S>& b, const S& s,
                           const ContactHistory<S>& history = {}) {
    return detail::with_safe_exponents<S>(c, b, s, history, never<S>(), detail::first_exit<S>);
}

}  // namespace osculo::math

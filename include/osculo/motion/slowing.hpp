#pragma once

#include <algorithm>

#include "osculo/math/exponential.hpp"
#include "osculo/math/instant.hpp"
#include "osculo/math/logarithm.hpp"
#include "osculo/math/trigonometry.hpp"
#include "osculo/math/vec.hpp"

namespace osculo::motion {

/// Deceleration constant + linear v + quadratic v^2 along the velocity; each >= 0.
template <math::Scalar S>
struct Resistance {
    S constant{0};   ///< [m/s^2]
    S linear{0};     ///< [1/s]
    S quadratic{0};  ///< [1/m]

    friend bool operator==(const Resistance&, const Resistance&) = default;
};

/// How far a ball has come, over its speed at the start, and its speed, over that too.
template <math::Scalar S>
struct Slowed {
    S sigma;  ///< [s]
    S q;      ///< from 1 down to 0
};

/// How the share q of its initial speed v that a ball still has falls with time:
///
///     q' = -(m + k q + c q^2),  m = constant / v,  k = linear,  c = quadratic v,  q(0) = 1
///
/// and sigma, its integral (NUMERICS 2.1; here all cases are one). phi = e^(c sigma) obeys the
/// linear equation phi'' + k phi' + m c phi = 0. With B'' + k B' + m c B = 1, B(0) = B'(0) = 0 and
/// A = B' it is phi = 1 + c g, g = A - m B, and
///
///     sigma = log(1 + c g) / c,   q = (A' - m A) / (1 + c g),   A' = 1 - k A - m c B
///
/// in which nothing is divided by a coefficient that may vanish: A and B are those of constant
/// deceleration, t and t^2 / 2, for k = m c = 0.
template <math::Scalar S>
struct Slowing {
    S m{0}, k{0}, c{0};  ///< [1/s]

    friend bool operator==(const Slowing&, const Slowing&) = default;

    /// Of a ball with that speed [m/s] > 0.
    [[nodiscard]] static Slowing of(const Resistance<S>& law, const S& speed) {
        return {law.constant / speed, law.linear, law.quadratic * speed};
    }
    /// The same, counted from when a share q of the speed is left.
    [[nodiscard]] Slowing from(const S& q) const {
        return q > S(0) ? Slowing{m / q, k, c * q} : Slowing{};
    }

    /// -q'.
    [[nodiscard]] S rate(const S& q) const { return m + q * (k + q * c); }

    /// Way and speed after t [s] >= 0, at the most rest_time(). Error of sigma <= math::kPathNoise
    /// epsilon sigma, of q <= math::kPathNoise epsilon.
    [[nodiscard]] Slowed<S> after(const S& t) const {
        if (t == S(0)) return {S(0), S(1)};
        if (k == S(0) && c == S(0)) {  // q falls linearly
            const S q = S(1) - m * t;
            return {t * (S(1) - m * t / S(2)), q > S(0) ? q : S(0)};
        }
        const Response r = response(t);
        const S g = r.a - (m * t) * r.b;
        const S grown = c * g;
        const S q = (r.slope - m * r.a) / (S(1) + grown);
        return {g * math::log1p_ratio<S>(grown), q > S(0) ? q : S(0)};
    }

    /// When q = 0, or never(). With the roots of the characteristic equation as in response():
    /// artanh or arc tangent, each in the form that does not cancel.
    [[nodiscard]] S rest_time() const {
        if (!(m > S(0))) return math::never<S>();
        const S half = k / S(2);
        const S disc = discriminant();
        if (disc < S(0)) {
            const S w = math::square_root<S>(-disc);
            return math::first_quadrant_angle<S>(w, S(m + half)) / w;
        }
        const S l = math::square_root<S>(disc);
        const S slow = l + half > S(0) ? S(m * c / (l + half)) : S(0);
        const S time = S(1) / (m + slow);
        return time * math::log1p_ratio<S>(S(2) * l * time);
    }

    /// What sigma approaches if it never rests, or more: 1 / k with linear drag, else never().
    [[nodiscard]] S limit() const {
        return k > S(0) ? S(S(1) / k * (S(1) + S(8) * math::epsilon<S>())) : math::never<S>();
    }

    /// When it has come to sigma; [rest] at the latest. Newton's iteration on g(t), which never
    /// overshoots, for g is concave and below t, and the constant deceleration alone would need no
    /// longer; the last step on sigma itself.
    [[nodiscard]] S time_of(const S& sigma, const S& rest) const {
        const S straight = S(1) - S(2) * m * sigma;
        S t = S(2) * sigma / (S(1) + (straight > S(0) ? math::square_root<S>(straight) : S(0)));
        if (k != S(0) || c != S(0)) {
            const S goal = sigma * math::growth_ratio<S>(S(c * sigma));
            t = std::max<S>(t, goal);
            for (int i = 0; i < 4 * math::ScalarTraits<S>::kDigits && t < rest; ++i) {
                const Response r = response(t);
                const S step = (goal - (r.a - (m * t) * r.b)) / (r.slope - m * r.a);
                // Negative by rounding only.
                if (!(step > S(8) * math::epsilon<S>() * t)) break;
                t += step;
            }
            if (t < rest) {
                const Slowed<S> now = after(t);
                const S step = (sigma - now.sigma) / now.q;
                if (math::abs<S>(step) < S(0.0009765625) * t) t += step;
            }
        }
        return t < rest ? t : rest;
    }

private:
    /// B / t, A = B' and A'.
    struct Response {
        S b, a, slope;
    };

    /// k^2 / 4 - m c, to its own digits.
    [[nodiscard]] S discriminant() const {
        const S half = k / S(2);
        return math::difference_of_products<S>(half, half, m, c);
    }

    [[nodiscard]] Response response(const S& t) const {
        const S kt = k * t;
        const S mc = m * c;
        if (kt <= S(2) && mc * t * t <= S(2)) return series(t, kt, S(mc * t * t));
        const S disc = discriminant();
        Response r;
        if (disc < S(0)) {
            const S w = math::square_root<S>(-disc);
            const math::SinCos<S> angle = math::sin_cos<S>(S(w * t));
            const S left = math::decay<S>(S(kt / S(2))).left;
            r.a = left * angle.sin / w;
            r.slope = left * angle.cos - (k / S(2)) * r.a;
            r.b = (S(1) - k * r.a - r.slope) / (mc * t);
            return r;
        }
        // A = (e^-slow t - e^-fast t) / (fast - slow), the rates of which the slow one may vanish.
        const S l = math::square_root<S>(disc);
        const S fast = l + k / S(2);
        const S slow = mc / fast;
        const math::Decay<S> of_fast = math::decay<S>(S(fast * t));
        const math::Decay<S> of_slow = math::decay<S>(S(slow * t));
        if (l > S(0)) {
            r.a = of_slow.left * math::decay<S>(S(S(2) * l * t)).gone / (S(2) * l);
        } else {
            r.a = of_slow.left * t;
        }
        r.slope = of_fast.left - slow * r.a;
        if (S(4) * slow < fast) {
            const S lasting = slow > S(0) ? S(of_slow.gone / slow) : t;
            r.b = (lasting - of_fast.gone / fast) / (S(2) * l * t);
        } else {
            r.b = (S(1) - k * r.a - r.slope) / (mc * t);
        }
        return r;
    }

    /// The power series of B / t^2, by its differential equation: all terms in one sum.
    [[nodiscard]] Response series(const S& t, const S& kt, const S& mctt) const {
        S before(0);
        S term(0.5);
        S b = term;
        S a(1);  // A / t
        for (int n = 3; n < 8 * math::ScalarTraits<S>::kDigits; ++n) {
            const S next = -(kt / S(n)) * term - (mctt / S(n * (n - 1))) * before;
            before = term;
            term = next;
            b += term;
            a += S(n) * term;
            const S size = S(n) * (math::abs<S>(term) + math::abs<S>(before));
            if (!(size > S(0.0625) * math::epsilon<S>() * a)) break;
        }
        return {b * t, a * t, S(1) - kt * a - mctt * b};
    }
};

}  // namespace osculo::motion

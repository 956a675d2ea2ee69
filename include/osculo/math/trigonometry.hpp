#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "osculo/math/wide.hpp"

/// Angles by arithmetic and square roots alone: unlike those of a library these functions give the
/// same bits with every compiler and library, and they serve every scalar type.
namespace osculo::math {

/// pi / 2 as an unevaluated sum, exact to 427 bits; each part serves a type of 53 bits or more.
inline constexpr std::array<double, 8> kQuarterTurn = {
    0x1.921fb54442d18p+0,   0x1.1a62633145c07p-54,  -0x1.f1976b7ed8fbcp-110,
    0x1.4cf98e804177dp-164, 0x1.31d89cd9128a5p-218, 0x1.0f31c6809bbdfp-276,
    0x1.519b3cd3a431bp-331, 0x1.8158536f92f8ap-386};

/// pi / 2, rounded.
template <Scalar S>
[[nodiscard]] S quarter_turn() {
    S sum(kQuarterTurn[7]);
    for (std::size_t i = 7; i-- > 0;) sum += S(kQuarterTurn[i]);
    return sum;
}

template <Scalar S>
struct SinCos {
    S sin;
    S cos;
};

namespace detail {

/// angle - turns * pi / 2, to rounding for the built-in types: the product is formed in parts.
template <Scalar S>
[[nodiscard]] S without_turns(const S& angle, const S& turns) {
    if constexpr (Builtin<S>) {
        Wide<S> rest(angle);
        for (std::size_t i = 0; i < 4; ++i) {
            rest = rest - wide_product<S>(turns, static_cast<S>(kQuarterTurn[i]));
        }
        return narrow(rest);
    } else {
        return angle - turns * quarter_turn<S>();
    }
}

}  // namespace detail

/// Sine and cosine of an angle [rad]. Requires |angle| <= 2^40. Error <= 2 epsilon of the results
/// for the built-in types (near their zeros too, up to |angle| epsilon^2), and 2 epsilon +
/// |angle| epsilon for the others.
template <Scalar S>
[[nodiscard]] SinCos<S> sin_cos(const S& angle) {
    const double turns = std::floor(to_double<S>(angle) / kQuarterTurn[0] + 0.5);
    const S x = turns == 0.0 ? angle : detail::without_turns<S>(angle, S(turns));
    // Both Taylor series at |x| <= pi / 4 + rounding, without their first terms; what is left out
    // is below the last term.
    S sine(0);
    S cosine(0);
    S term = x;
    const S least = S(0.125) * epsilon<S>() * abs<S>(x);
    for (int n = 2; abs<S>(term) > least; ++n) {
        term *= x / S(n);
        if (n % 2 == 0) {
            term = -term;
            cosine += term;
        } else {
            sine += term;
        }
    }
    sine += x;
    cosine += S(1);
    switch (static_cast<long long>(turns) & 3) {
        case 0: return {sine, cosine};
        case 1: return {cosine, S(-sine)};
        case 2: return {S(-sine), S(-cosine)};
        default: return {S(-cosine), sine};
    }
}

/// The angle in [0, pi / 2] whose sine and cosine are proportional to two numbers >= 0, not both 0.
/// Relative error <= 10 epsilon.
template <Scalar S>
[[nodiscard]] S first_quadrant_angle(const S& sine, const S& cosine) {
    // tan(x / 2) four times over, so that the series of the arc tangent at <= 0.0985 is short.
    const S larger = std::max<S>(sine, cosine);
    const S y = sine / larger;
    const S x = cosine / larger;
    S t = y / (square_root<S>(x * x + y * y) + x);
    for (int i = 0; i < 3; ++i) t = t / (S(1) + square_root<S>(S(1) + t * t));
    const S square = t * t;
    S power = t;
    S sum(0);
    S term = t;
    for (int n = 3; abs<S>(term) > S(0.125) * epsilon<S>() * t; n += 2) {
        power *= -square;
        term = power / S(n);
        sum += term;
    }
    return S(16) * (t + sum);
}

}  // namespace osculo::math

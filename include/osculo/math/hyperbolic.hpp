#pragma once

#include <array>
#include <cmath>

#include "osculo/math/wide.hpp"

/// Hyperbolic functions by arithmetic and square roots alone: the same bits with every compiler and
/// library, for every scalar type.
namespace osculo::math {

/// log 2 as an unevaluated sum, exact to 438 bits; each part serves a type of 53 bits or more.
inline constexpr std::array<double, 8> kLogarithmOf2 = {
    0x1.62e42fefa39efp-1,    0x1.abc9e3b39803fp-56,   0x1.7b57a079a1934p-111,
    -0x1.ace93a4ebe5d1p-165, -0x1.23a2a82ea0c24p-219, 0x1.d881b7aeb2615p-274,
    0x1.9552fb4afa1b1p-328,  0x1.da5d5c6b82704p-385};

template <Scalar S>
struct SinhCosh {
    S sinh;
    S cosh;
};

namespace detail {

/// x - doublings * log 2, to rounding for the built-in types.
template <Scalar S>
[[nodiscard]] S without_doublings(const S& x, const S& doublings) {
    if constexpr (Builtin<S>) {
        Wide<S> rest(x);
        for (std::size_t i = 0; i < 3; ++i) {
            rest = rest - wide_product<S>(doublings, static_cast<S>(kLogarithmOf2[i]));
        }
        return narrow(rest);
    } else {
        S logarithm(kLogarithmOf2[7]);
        for (std::size_t i = 7; i-- > 0;) logarithm += S(kLogarithmOf2[i]);
        return x - doublings * logarithm;
    }
}

}  // namespace detail

/// Hyperbolic sine and cosine. Requires |x| <= 300. Error <= 3 epsilon of the results for the
/// built-in types, and 3 epsilon + |x| epsilon for the others.
template <Scalar S>
[[nodiscard]] SinhCosh<S> sinh_cosh(const S& x) {
    const S size = abs<S>(x);
    const double doublings = std::floor(to_double<S>(size) / kLogarithmOf2[0] + 0.5);
    const S part = doublings == 0.0 ? size : detail::without_doublings<S>(size, S(doublings));
    // e^part - 1 for |part| <= log(2) / 2 + rounding.
    S sum(0);
    S term = part;
    const S least = S(0.125) * epsilon<S>() * abs<S>(part);
    for (int n = 2; abs<S>(term) > least; ++n) {
        term *= part / S(n);
        sum += term;
    }
    sum += part;
    // (e^x - 1) = 2^n (e^part - 1) + (2^n - 1), whose terms do not cancel.
    S power(1);
    for (int n = static_cast<int>(doublings); n > 0; --n) power *= S(2);
    const S grown = power * sum + (power - S(1));
    const S shrunk = grown / (S(1) + grown);  // 1 - e^-x
    const S sinh = (grown + shrunk) / S(2);
    return {x < S(0) ? S(-sinh) : sinh, S(S(1) + (grown - shrunk) / S(2))};
}

/// The inverse of the hyperbolic sine. Requires x^2 not to overflow. Relative error <= 20 epsilon
/// for |x| < 1e20.
template <Scalar S>
[[nodiscard]] S inverse_sinh(const S& x) {
    // sinh(u / 2) until the series at <= 0.1 is short.
    S half = abs<S>(x);
    S factor(1);
    while (half > S(0.1)) {
        half /= square_root<S>(S(2) * (S(1) + square_root<S>(S(1) + half * half)));
        factor *= S(2);
    }
    // asinh h = h - 1/2 h^3/3 + 1/2 3/4 h^5/5 - ...
    const S square = half * half;
    S power = half;
    S sum(0);
    S term = half;
    for (int n = 1; abs<S>(term) > S(0.125) * epsilon<S>() * half; ++n) {
        power *= -square * (S(2 * n - 1) / S(2 * n));
        term = power / S(2 * n + 1);
        sum += term;
    }
    const S result = factor * (half + sum);
    return x < S(0) ? S(-result) : result;
}

}  // namespace osculo::math

#pragma once

#include "osculo/math/floating_point.hpp"

namespace osculo::math {

/// e^-x for x >= 0, by additions, multiplications and divisions alone: unlike a library's exp it
/// gives the same bits with every compiler and library, and it serves every scalar type.
///
/// e^-x - 1 is summed at x / 2^n <= 1/4 and doubled n times by E <- E (E + 2). Absolute error
/// <= kExponentialError epsilon: a step's rounding error is doubled by each of the j later steps
/// while e^-x shrinks like e^(-2^j / 8). 0 where e^-x is below epsilon^1.4.
inline constexpr int kExponentialError = 4;

template <Scalar S>
[[nodiscard]] S decaying_exponential(const S& x) {
    if (!(x < S(ScalarTraits<S>::kDigits))) return S(0);
    S part = x;
    int doublings = 0;
    for (; part > S(0.25); ++doublings) part *= S(0.5);
    S term = -part;
    S sum = term;
    // An alternating series: what is left out is below its first term.
    for (int n = 2; abs<S>(term) > S(0.125) * epsilon<S>() * part; ++n) {
        term *= -part / S(n);
        sum += term;
    }
    for (int i = 0; i < doublings; ++i) sum *= sum + S(2);
    return S(1) + sum;
}

/// e^-x and what is missing from it to 1.
template <Scalar S>
struct Decay {
    S left;  ///< e^-x
    S gone;  ///< 1 - e^-x
};

/// Both for x >= 0, each to its own digits: relative errors <= (4 + 4 x) and 4 epsilon. Of the same
/// series as decaying_exponential().
template <Scalar S>
[[nodiscard]] Decay<S> decay(const S& x) {
    if (!(x < S(32 * ScalarTraits<S>::kDigits))) return {S(0), S(1)};
    S part = x;
    int doublings = 0;
    for (; part > S(0.25); ++doublings) part *= S(0.5);
    S term = part;
    S gone(0);
    for (int n = 2; abs<S>(term) > S(0.125) * epsilon<S>() * part; ++n) {
        term *= -part / S(n);
        gone += term;
    }
    gone += part;
    S left = S(1) - gone;
    for (int i = 0; i < doublings; ++i) {
        gone *= S(2) - gone;
        left *= left;
    }
    return {left, gone};
}

/// (e^x - 1) / x for x >= 0, 1 at x = 0: relative error <= (6 + 4 x) epsilon.
template <Scalar S>
[[nodiscard]] S growth_ratio(const S& x) {
    if (!(x > epsilon<S>())) return S(1) + x / S(2);  // x may have next to no digits
    const Decay<S> d = decay<S>(x);
    return d.gone / (d.left * x);
}

}  // namespace osculo::math

#pragma once

#include "osculo/math/floating_point.hpp"

namespace osculo::math {

/// log(1 + x) / x for x >= 0, 1 at x = 0: by arithmetic and square roots alone, so that the bits
/// are the same with every compiler and library, for every scalar type.
///
/// log(1 + x) = 2 log(1 + y) with y = sqrt(1 + x) - 1 = x / (1 + sqrt(1 + x)), until y <= 1/8; then
/// the series of 2 artanh(y / (2 + y)). Relative error <= kLogarithmError epsilon for x up to 1e15:
/// 1 for each halving of the logarithm, 3 for the series.
inline constexpr int kLogarithmError = 12;

template <Scalar S>
[[nodiscard]] S log1p_ratio(const S& x) {
    if (!(x > epsilon<S>())) return S(1) - x / S(2);  // x may have next to no digits
    S y = x;
    S factor(2);
    for (; y > S(0.125); factor *= S(2)) y = y / (S(1) + square_root<S>(S(1) + y));
    const S z = y / (S(2) + y);
    const S square = z * z;
    S power(1);
    S sum(0);
    for (int n = 3; power > S(0.125) * epsilon<S>(); n += 2) {
        power *= square;
        sum += power / S(n);
    }
    return factor * (z / x) * (S(1) + sum);
}

}  // namespace osculo::math

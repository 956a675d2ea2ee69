#pragma once

#include <array>

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/trigonometry.hpp"

/// Functions on [-1, 1] as sums of Chebyshev polynomials, for integrals that are asked for at every
/// upper limit: a series is as accurate as Gauss's rule with as many nodes, once its terms have
/// died away, and says by itself whether they have.
namespace osculo::math {

/// Terms of a series: 19 for double, 23, 42, 63 and 125 for the wider types.
template <Scalar S>
inline constexpr std::size_t kChebyshevTerms = ScalarTraits<S>::kDigits * 3 / 8;

/// c_0 + c_1 T_1(x) + ... + c_n T_n(x), n = kChebyshevTerms.
template <Scalar S>
using ChebyshevSeries = std::array<S, kChebyshevTerms<S> + 1>;

/// Cosines of the multiples of pi / (2 n), for all the series of a scalar type. Constant.
template <Scalar S>
struct ChebyshevNodes {
    static constexpr std::size_t kCount = kChebyshevTerms<S>;
    std::array<S, 4 * kCount> cosine;

    ChebyshevNodes() {
        for (std::size_t i = 0; i < cosine.size(); ++i) {
            cosine[i] =
                sin_cos<S>(S(static_cast<double>(i)) * quarter_turn<S>() / S(double(kCount))).cos;
        }
    }
    /// Node j of kCount, ascending.
    [[nodiscard]] const S& at(std::size_t j) const { return cosine[2 * (kCount - 1 - j) + 1]; }

    static const ChebyshevNodes& get() {
        static const ChebyshevNodes kNodes;
        return kNodes;
    }
};

/// Value by Clenshaw's recurrence, -1 <= x <= 1. Error <= 2 epsilon sum |c_k| or so.
template <Scalar S>
[[nodiscard]] S chebyshev_value(const ChebyshevSeries<S>& c, const S& x) {
    const S twice = x + x;
    S next(0);
    S last(0);
    for (std::size_t k = c.size() - 1; k > 0; --k) {
        const S now = c[k] + (twice * next - last);
        last = next;
        next = now;
    }
    return c[0] + (x * next - last);
}

/// Value and slope.
template <Scalar S>
struct ValueAndSlope {
    S value;
    S slope;
};
template <Scalar S>
[[nodiscard]] ValueAndSlope<S> chebyshev_value_and_slope(const ChebyshevSeries<S>& c, const S& x) {
    const S twice = x + x;
    S next(0), last(0), next_slope(0), last_slope(0);
    for (std::size_t k = c.size() - 1; k > 0; --k) {
        const S slope = S(2) * next + (twice * next_slope - last_slope);
        const S now = c[k] + (twice * next - last);
        last_slope = next_slope;
        next_slope = slope;
        last = next;
        next = now;
    }
    return {c[0] + (x * next - last), next + (x * next_slope - last_slope)};
}

/// The coefficients of the function with these values at the nodes; the last one is 0.
template <Scalar S>
[[nodiscard]] ChebyshevSeries<S> chebyshev_fit(const std::array<S, kChebyshevTerms<S>>& values) {
    const ChebyshevNodes<S>& nodes = ChebyshevNodes<S>::get();
    constexpr std::size_t kCount = kChebyshevTerms<S>;
    ChebyshevSeries<S> c{};
    for (std::size_t k = 0; k < kCount; ++k) {
        S sum(0);
        for (std::size_t j = 0; j < kCount; ++j) {
            sum += values[j] * nodes.cosine[(k * (2 * (kCount - 1 - j) + 1)) % (4 * kCount)];
        }
        c[k] = sum * S(k == 0 ? 1 : 2) / S(double(kCount));
    }
    return c;
}

/// Whether the terms have died away: the last three are rounding of the largest. [noise]: of the
/// values, in epsilon.
template <Scalar S>
[[nodiscard]] bool chebyshev_resolved(const ChebyshevSeries<S>& c, const S& noise) {
    S largest(0);
    for (const S& term : c) largest = abs<S>(term) > largest ? abs<S>(term) : largest;
    constexpr std::size_t kCount = kChebyshevTerms<S>;
    const S last = abs<S>(c[kCount - 1]) + abs<S>(c[kCount - 2]) + abs<S>(c[kCount - 3]);
    return last <= S(kChebyshevTail) * noise * epsilon<S>() * largest;
}

/// The integral from -1 to x of [scale] times the series.
template <Scalar S>
[[nodiscard]] ChebyshevSeries<S> chebyshev_integral(const ChebyshevSeries<S>& c, const S& scale) {
    ChebyshevSeries<S> integral{};
    S at_start(0);
    for (std::size_t k = 1; k < c.size(); ++k) {
        const S below = k == 1 ? S(S(2) * c[0]) : c[k - 1];
        const S above = k + 1 < c.size() ? c[k + 1] : S(0);
        integral[k] = scale * (below - above) / S(double(2 * k));
        at_start += k % 2 == 0 ? integral[k] : S(-integral[k]);
    }
    integral[0] = -at_start;
    return integral;
}

}  // namespace osculo::math

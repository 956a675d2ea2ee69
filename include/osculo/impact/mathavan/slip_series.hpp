#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/vec.hpp"

namespace osculo::impact::mathavan {

/// Order of the power series. A step then covers about 2^(-5/2) of the distance to the nearest
/// singularity, where work per distance is least (it grows like the square of the order).
template <math::Scalar S>
inline constexpr std::size_t kOrder = static_cast<std::size_t>(2 * math::ScalarTraits<S>::kDigits) /
                                      5;

/// Coefficients of 1, p, p^2, ... p^kOrder.
template <math::Scalar S>
using Series = std::array<S, kOrder<S> + 1>;

template <math::Scalar S>
[[nodiscard]] S value(const Series<S>& a, const S& p) {
    S sum = a[kOrder<S>];
    for (std::size_t i = kOrder<S>; i-- > 0;) sum = sum * p + a[i];
    return sum;
}

/// Coefficient j of a product.
template <math::Scalar S>
[[nodiscard]] S product(const Series<S>& a, const Series<S>& b, std::size_t j) {
    S sum = a[0] * b[j];
    for (std::size_t i = 1; i <= j; ++i) sum += a[i] * b[j - i];
    return sum;
}

/// A slip velocity u, its length n and its direction d = u / n as power series, one coefficient
/// after the other, from u = n d and n' = d . u'.
template <math::Scalar S>
struct SlipSeries {
    Series<S> u[2];
    Series<S> d[2];
    Series<S> n;

    [[nodiscard]] math::Vec<S> slip(std::size_t j) const { return {u[0][j], u[1][j]}; }
    [[nodiscard]] math::Vec<S> direction(std::size_t j) const { return {d[0][j], d[1][j]}; }
    void set_slip(std::size_t j, const math::Vec<S>& value) {
        u[0][j] = value.x();
        u[1][j] = value.y();
    }
    void set_direction(std::size_t j, const math::Vec<S>& value) {
        d[0][j] = value.x();
        d[1][j] = value.y();
    }

    /// n_j and d_j. Requires u_0 .. u_j, and u_0 != 0.
    void extend(std::size_t j) {
        if (j == 0) {
            n[0] = math::norm<S>(slip(0));
            set_direction(0, slip(0) / n[0]);
            return;
        }
        S length(0);
        for (std::size_t i = 0; i < j; ++i) {
            length += S(static_cast<double>(j - i)) * math::dot<S>(direction(i), slip(j - i));
        }
        n[j] = length / S(static_cast<double>(j));
        math::Vec<S> rest = slip(j);
        for (std::size_t i = 1; i <= j; ++i) rest -= n[i] * direction(j - i);
        set_direction(j, rest / n[0]);
    }

    /// For a slip that starts from zero, u = p U, n = p N, d = U / N: d_j is what this returns plus
    /// the part of U_j across d_0, over N_0. Requires U_0 .. U_(j-1), that is, u_1 .. u_j; j > 0.
    [[nodiscard]] math::Vec<S> known_direction(std::size_t j) const {
        S length(0);
        math::Vec<S> rest = math::Vec<S>::Zero();
        for (std::size_t i = 1; i < j; ++i) {
            length += S(static_cast<double>(j - i)) * math::dot<S>(direction(i), slip(j - i + 1));
            rest -= n[i] * direction(j - i);
        }
        rest -= (length / S(static_cast<double>(j))) * direction(0);
        return rest / n[0];
    }
    /// N_j and d_j from U_j = u_(j+1) and the above.
    void extend_from_zero(std::size_t j, const math::Vec<S>& known) {
        const math::Vec<S> next = slip(j + 1);
        if (j == 0) {
            n[0] = math::norm<S>(next);
            return;  // the direction was given
        }
        const S along = math::dot<S>(direction(0), next);
        set_direction(j, known + (next - along * direction(0)) / n[0]);
        S length(0);
        for (std::size_t i = 0; i < j; ++i) {
            length += S(static_cast<double>(j - i)) * math::dot<S>(direction(i), slip(j - i + 1));
        }
        n[j] = length / S(static_cast<double>(j));
    }
};

}  // namespace osculo::impact::mathavan

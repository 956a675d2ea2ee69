#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/floating_point.hpp"

/// Zeros of low polynomials, for the audit alone: detection has its own.
namespace osculo::engine {

/// Up to N numbers.
template <class T, std::size_t N>
class Few {
public:
    void add(const T& value) { values_[count_++] = value; }
    /// Keeps the ascending order.
    void insert(const T& value) {
        std::size_t k = count_++;
        for (; k > 0 && value < values_[k - 1]; --k) values_[k] = values_[k - 1];
        values_[k] = value;
    }
    [[nodiscard]] const T* begin() const { return values_.data(); }
    [[nodiscard]] const T* end() const { return values_.data() + count_; }

private:
    std::array<T, N> values_{};
    std::size_t count_ = 0;
};

/// p[0] + p[1] x + ... at x.
template <math::Scalar S, std::size_t N>
[[nodiscard]] S value_at(const std::array<S, N>& p, const S& x) {
    S value = p[N - 1];
    for (std::size_t k = N - 1; k > 0; --k) value = value * x + p[k - 1];
    return value;
}

/// Where the polynomial changes its sign between 0 and 1, in ascending order, to the last bit of
/// what its rounded values say. Between the zeros of its derivative it is monotone, and there
/// bisection cannot fail.
template <math::Scalar S, std::size_t N>
[[nodiscard]] Few<S, N - 1> zeros_between_0_and_1(const std::array<S, N>& p) {
    Few<S, N - 1> zeros;
    if constexpr (N > 1) {
        std::array<S, N - 1> derivative;
        for (std::size_t k = 1; k < N; ++k) derivative[k - 1] = S(static_cast<int>(k)) * p[k];
        const auto turns = zeros_between_0_and_1<S, N - 1>(derivative);
        S low(0);
        S value_low = p[0];
        const auto search_until = [&](const S& end) {
            const S value_end = value_at<S, N>(p, end);
            if ((value_low < S(0)) != (value_end < S(0))) {
                S a = low;
                S b = end;
                for (int i = 0; i < 2 * math::ScalarTraits<S>::kDigits; ++i) {
                    const S middle = a + (b - a) / S(2);
                    if (!(a < middle && middle < b)) break;
                    ((value_at<S, N>(p, middle) < S(0)) == (value_low < S(0)) ? a : b) = middle;
                }
                zeros.add(b);
            }
            low = end;
            value_low = value_end;
        };
        for (const S& turn : turns) search_until(turn);
        search_until(S(1));
    }
    return zeros;
}

}  // namespace osculo::engine

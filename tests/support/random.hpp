#pragma once

#include <cstdint>
#include <random>

#include "osculo/math/vec.hpp"

namespace osculo::support {

/// 2^exponent, exact.
template <math::Scalar S>
[[nodiscard]] S power_of_two(int exponent) {
    S result(1);
    const S factor = exponent < 0 ? S(0.5) : S(2);
    for (int i = exponent < 0 ? -exponent : exponent; i > 0; --i) result *= factor;
    return result;
}

/// 10^exponent to a few ulp.
template <math::Scalar S>
[[nodiscard]] S power_of_ten(int exponent) {
    S result(1);
    for (int i = exponent < 0 ? -exponent : exponent; i > 0; --i) result *= S(10);
    return exponent < 0 ? S(S(1) / result) : result;
}

/// Seeded random numbers, the same on every platform (the distributions of the standard library
/// are not), with all digits of the scalar type random.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// One of 0 .. count - 1.
    [[nodiscard]] int below(int count) {
        return static_cast<int>(engine_() % static_cast<std::uint64_t>(count));
    }
    /// One of low .. high.
    [[nodiscard]] int between(int low, int high) { return low + below(high - low + 1); }
    [[nodiscard]] bool coin() { return (engine_() & 1U) != 0; }

    /// In [0, 1).
    template <math::Scalar S>
    [[nodiscard]] S unit() {
        constexpr int kDigits = math::ScalarTraits<S>::kDigits;
        S sum(0);
        S scale(1);
        for (int left = kDigits; left > 0; left -= 32) {
            const int take = left < 32 ? left : 32;
            scale /= S(static_cast<double>(std::uint64_t(1) << take));
            sum += S(static_cast<double>(engine_() >> (64 - take))) * scale;
        }
        return sum;
    }
    template <math::Scalar S>
    [[nodiscard]] S uniform(const S& low, const S& high) {
        return low + (high - low) * unit<S>();
    }
    template <math::Scalar S>
    [[nodiscard]] S signed_unit() {
        return coin() ? unit<S>() : S(-unit<S>());
    }
    /// Between 2^low and 2^(high + 1), every power of two equally likely.
    template <math::Scalar S>
    [[nodiscard]] S magnitude(int low, int high) {
        return (S(1) + unit<S>()) * power_of_two<S>(between(low, high));
    }
    /// A unit vector to rounding; one in eight lies along an axis.
    template <math::Scalar S>
    [[nodiscard]] math::Vec<S> direction() {
        if (below(8) == 0) {
            const S one(coin() ? 1 : -1);
            return coin() ? math::Vec<S>(one, S(0)) : math::Vec<S>(S(0), one);
        }
        for (;;) {
            const math::Vec<S> v(signed_unit<S>(), signed_unit<S>());
            const S square = math::dot<S>(v, v);
            if (square > S(0.01) && square < S(1)) return v / math::square_root<S>(square);
        }
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace osculo::support

#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#if defined(__FAST_MATH__)
#error "osculo relies on IEEE arithmetic: compile without -ffast-math"
#endif

namespace osculo::math {

/// IEEE binary128, 113 bits. Only its arithmetic is used, so that nothing needs libquadmath.
__extension__ typedef __float128 Quad;

/// What the core needs to know about a scalar type.
template <class S>
struct ScalarTraits;

template <class S>
requires std::numeric_limits<S>::is_specialized struct ScalarTraits<S> {
    static constexpr int kDigits = std::numeric_limits<S>::digits;
    /// Squares and fourth powers of lengths and speeds of up to 1e150 overflow.
    static constexpr bool kNarrowExponent = std::numeric_limits<S>::max_exponent <= 1024;
    static S epsilon() { return std::numeric_limits<S>::epsilon(); }
    static S infinity() { return std::numeric_limits<S>::infinity(); }
};

template <>
struct ScalarTraits<Quad> {
    static constexpr int kDigits = 113;
    static constexpr bool kNarrowExponent = false;
    static Quad epsilon() { return Quad(0x1p-112); }
    static Quad infinity() { return Quad(std::numeric_limits<double>::infinity()); }
};

/// A type the core computes with: double, long double, Quad, Boost.Multiprecision binary floats.
template <class S>
concept Scalar = requires(S a, S b) {
    ScalarTraits<S>::kDigits;
    { a + b } -> std::convertible_to<S>;
    { a / b } -> std::convertible_to<S>;
    { a < b } -> std::convertible_to<bool>;
};

/// A type whose operations the processor rounds correctly, so that error-free transforms hold.
/// Spelled out, since with GNU extensions std::floating_point includes __float128 as well.
template <class S>
concept Builtin = std::same_as<S, float> || std::same_as<S, double> || std::same_as<S, long double>;

/// Distance from 1 to the next larger number.
template <Scalar S>
[[nodiscard]] S epsilon() {
    return ScalarTraits<S>::epsilon();
}

/// "Never", as a duration: the time of a contact that does not happen.
template <Scalar S>
[[nodiscard]] S never() {
    return ScalarTraits<S>::infinity();
}

template <Scalar S>
[[nodiscard]] S abs(const S& x) {
    if constexpr (Builtin<S>) return std::fabs(x);  // one instruction, where the sign of 0 hinders
    return x < S(0) ? S(-x) : x;
}

template <Scalar S>
[[nodiscard]] bool is_finite(const S& x) {
    return x - x == S(0);
}

/// x as the nearest double.
template <Scalar S>
[[nodiscard]] double to_double(const S& x) {
    return static_cast<double>(x);
}

template <Scalar S>
[[nodiscard]] S square_root(const S& x) {
    using std::sqrt;
    return sqrt(x);
}

/// Square root to 1 ulp: a double's root, sharpened by Newton's iteration (each step doubles the
/// digits). Requires x to be 0 or within double's range.
template <>
[[nodiscard]] inline Quad square_root<Quad>(const Quad& x) {
    if (!(x > 0)) return x < 0 ? Quad(std::numeric_limits<double>::quiet_NaN()) : x;
    // Scale by powers of 4 into the range where the double root is neither zero nor infinite.
    Quad scaled = x;
    Quad unscale = 1;
    for (; scaled > Quad(0x1p1000); unscale *= 0x1p500) scaled *= 0x1p-1000;
    for (; scaled < Quad(0x1p-1000); unscale *= 0x1p-500) scaled *= 0x1p1000;
    Quad root = std::sqrt(static_cast<double>(scaled));
    for (int i = 0; i < 2; ++i) root += (scaled - root * root) / (2 * root);
    return root * unscale;
}

}  // namespace osculo::math

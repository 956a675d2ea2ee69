#pragma once

#include <cmath>
#include <type_traits>

#include "osculo/math/floating_point.hpp"

namespace osculo::math {

/// An unevaluated sum hi + lo with |lo| <= ulp(hi)/2: twice the digits of S.
/// The operations are the classical error-free transforms of Dekker (Numer. Math. 18, 1971) and
/// Knuth (TAOCP 2, 4.2.2). For p-bit S the relative error of + and - is below 3.01 * 2^(-2p),
/// even where the result cancels, and that of * below 5.01 * 2^(-2p) (M. Joldes, J.-M. Muller and
/// V. Popescu, ACM Trans. Math. Softw. 44, 2017). No operand may be infinite.
template <Builtin S>
struct DoubleDouble {
    S hi = 0;
    S lo = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(S value) : hi(value) {}  // NOLINT(google-explicit-constructor)
    constexpr DoubleDouble(S high, S low) : hi(high), lo(low) {}

    friend constexpr bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
    friend constexpr bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
    }
    friend constexpr bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    friend constexpr bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
        return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo);
    }
    friend constexpr bool operator>=(const DoubleDouble& a, const DoubleDouble& b) {
        return b <= a;
    }
    constexpr DoubleDouble operator-() const { return {-hi, -lo}; }
};

/// a + b exactly.
template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> two_sum(S a, S b) {
    const S sum = a + b;
    const S b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b exactly; requires |a| >= |b| or a = 0.
template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> quick_two_sum(S a, S b) {
    const S sum = a + b;
    return {sum, b - (sum - a)};
}

/// a * b exactly, unless the low part underflows.
template <Builtin S>
[[nodiscard]] inline DoubleDouble<S> two_product(S a, S b) {
    const S product = a * b;
    if constexpr (std::is_same_v<S, long double>) {
        // x87 has no fused multiply-add and its emulation is slow: split in halves (Veltkamp).
        constexpr S kSplit = 4294967297.0L;  // 2^32 + 1
        const S ta = kSplit * a;
        const S a_high = ta - (ta - a);
        const S a_low = a - a_high;
        const S tb = kSplit * b;
        const S b_high = tb - (tb - b);
        const S b_low = b - b_high;
        return {product,
                ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
    } else {
        return {product, std::fma(a, b, -product)};
    }
}

template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> operator+(const DoubleDouble<S>& a,
                                                  const DoubleDouble<S>& b) {
    DoubleDouble<S> high = two_sum(a.hi, b.hi);
    const DoubleDouble<S> low = two_sum(a.lo, b.lo);
    high = quick_two_sum(high.hi, high.lo + low.hi);
    return quick_two_sum(high.hi, high.lo + low.lo);
}

template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> operator+(const DoubleDouble<S>& a,
                                                  const std::type_identity_t<S>& b) {
    const DoubleDouble<S> high = two_sum(a.hi, b);
    return quick_two_sum(high.hi, high.lo + a.lo);
}

template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> operator-(const DoubleDouble<S>& a,
                                                  const DoubleDouble<S>& b) {
    return a + (-b);
}

template <Builtin S>
[[nodiscard]] constexpr DoubleDouble<S> operator-(const DoubleDouble<S>& a,
                                                  const std::type_identity_t<S>& b) {
    return a + (-b);
}

template <Builtin S>
[[nodiscard]] inline DoubleDouble<S> operator*(const DoubleDouble<S>& a, const DoubleDouble<S>& b) {
    const DoubleDouble<S> product = two_product(a.hi, b.hi);
    return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// The type in which contacts are decided and instants and positions are kept: twice the digits of
/// the built-in types; the wider types serve as their own, for they are there to be compared with.
template <Scalar S>
using Wide = typename std::conditional_t<
    Builtin<S>, std::type_identity<DoubleDouble<std::conditional_t<Builtin<S>, S, double>>>,
    std::type_identity<S>>::type;

/// Relative rounding of wide numbers.
template <Scalar S>
[[nodiscard]] S wide_epsilon() {
    return Builtin<S> ? S(S(4) * epsilon<S>() * epsilon<S>()) : epsilon<S>();
}

/// A wide number rounded to its scalar.
template <Builtin S>
[[nodiscard]] constexpr S narrow(const DoubleDouble<S>& x) {
    return x.hi;
}
template <Scalar S>
[[nodiscard]] const S& narrow(const S& x) {
    return x;
}

/// What narrow() takes away.
template <Builtin S>
[[nodiscard]] constexpr S low_part(const DoubleDouble<S>& x) {
    return x.lo;
}
template <Scalar S>
[[nodiscard]] S low_part(const S&) {
    return S(0);
}

/// a * b and a + b, exact for the built-in types and rounded for the others.
template <Scalar S>
[[nodiscard]] Wide<S> wide_product(const S& a, const S& b) {
    if constexpr (Builtin<S>) {
        return two_product(a, b);
    } else {
        return a * b;
    }
}
template <Scalar S>
[[nodiscard]] Wide<S> wide_sum(const S& a, const S& b) {
    if constexpr (Builtin<S>) {
        return two_sum(a, b);
    } else {
        return a + b;
    }
}

/// a / b rounded to S, within 0.51 ulp for the built-in types. Requires b != 0.
template <Builtin S>
[[nodiscard]] inline S quotient(const DoubleDouble<S>& a, const DoubleDouble<S>& b) {
    const S first = a.hi / b.hi;
    const DoubleDouble<S> rest = a - b * DoubleDouble<S>(first);
    return first + rest.hi / b.hi;
}
template <Scalar S>
[[nodiscard]] S quotient(const S& a, const S& b) {
    return a / b;
}

/// a / b in wide precision. Requires b != 0.
template <Builtin S>
[[nodiscard]] inline DoubleDouble<S> wide_quotient(const DoubleDouble<S>& a,
                                                   const DoubleDouble<S>& b) {
    const S first = a.hi / b.hi;
    const DoubleDouble<S> rest = a - b * DoubleDouble<S>(first);
    return quick_two_sum(first, rest.hi / b.hi);
}
template <Scalar S>
[[nodiscard]] S wide_quotient(const S& a, const S& b) {
    return a / b;
}

/// Square root in wide precision. Requires x >= 0.
template <Builtin S>
[[nodiscard]] inline DoubleDouble<S> wide_square_root(const DoubleDouble<S>& x) {
    if (!(x.hi > 0)) return S(0);
    const S root = std::sqrt(x.hi);
    const DoubleDouble<S> rest = x - two_product(root, root);
    return quick_two_sum(root, rest.hi / (2 * root));
}
template <Scalar S>
[[nodiscard]] S wide_square_root(const S& x) {
    return square_root(x);
}

}  // namespace osculo::math

#pragma once

#include <iomanip>
#include <sstream>
#include <string>
#include <type_traits>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "osculo/math/vec.hpp"

/// The oracle of the numerical tests: plain formulas in so many digits that rounding does not
/// matter.
namespace osculo::support {

/// 332 bits hold the discriminant of a contact of doubles or long doubles without rounding as long
/// as their exponents are within some 80 of each other.
using Exact = boost::multiprecision::cpp_bin_float_100;

/// Its rounding is as small for data in 113 bits or 50 digits.
using Exacter = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>,
                                              boost::multiprecision::et_off>;

template <math::Scalar S>
using ExactFor = std::conditional_t<math::Builtin<S>, Exact, Exacter>;

/// x without rounding; of the wider types, double by double.
template <class R, math::Scalar S>
[[nodiscard]] R exact(const S& x) {
    if constexpr (math::Builtin<S>) {
        return R(x);
    } else {
        // Away from where the parts would be too small for double.
        if (x != S(0) && math::abs<S>(x) < S(0x1p-600)) {
            return exact<R>(S(x * S(0x1p500))) * ldexp(R(1), -500);
        }
        R sum(0);
        for (S rest = x; rest != S(0);) {
            const double part = math::to_double<S>(rest);
            sum += R(part);
            rest -= S(part);
        }
        return sum;
    }
}

template <class R, math::Builtin S>
[[nodiscard]] R exact(const math::DoubleDouble<S>& x) {
    return R(x.hi) + R(x.lo);
}

/// x rounded to S, ties to even for the built-in types.
template <math::Scalar S, class R>
[[nodiscard]] S rounded(const R& x) {
    if constexpr (std::is_same_v<S, math::Quad>) {
        const auto high = static_cast<double>(x);
        const auto middle = static_cast<double>(R(x - high));
        return math::Quad(high) + math::Quad(middle) +
               math::Quad(static_cast<double>(R(x - high - middle)));
    } else {
        return static_cast<S>(x);
    }
}

/// Distance between neighbouring numbers of type S at x.
template <math::Scalar S, class R>
[[nodiscard]] R ulp(const R& x) {
    using boost::multiprecision::fabs;
    using boost::multiprecision::ldexp;
    if (x == 0) return R(0);
    return ldexp(R(1), static_cast<int>(ilogb(R(fabs(x)))) - math::ScalarTraits<S>::kDigits + 1);
}

/// |x - reference| in ulp of the reference; 0 if both are 0.
template <math::Scalar S, class R>
[[nodiscard]] double error_in_ulp(const S& x, const R& reference) {
    using boost::multiprecision::fabs;
    const R error = fabs(R(exact<R>(x) - reference));
    if (error == 0) return 0;
    return reference == 0 ? 1e300 : static_cast<double>(R(error / ulp<S>(reference)));
}

/// All bits of x, to be pasted into a program where the type has such literals.
template <math::Scalar S>
[[nodiscard]] std::string bits(const S& x) {
    std::ostringstream out;
    if constexpr (math::Builtin<S>) {
        out << std::hexfloat << x;
    } else {
        out << std::setprecision(60) << exact<Exacter>(x);
    }
    return out.str();
}

template <math::Scalar S>
[[nodiscard]] std::string bits(const math::Vec<S>& v) {
    std::string text("{");
    return text.append(bits<S>(v.x())).append(", ").append(bits<S>(v.y())).append("}");
}

template <math::Scalar S>
[[nodiscard]] const char* name_of() {
    if constexpr (std::is_same_v<S, double>) return "double";
    if constexpr (std::is_same_v<S, long double>) return "long double";
    if constexpr (std::is_same_v<S, math::Quad>) return "quad";
    return "50 digits";
}

}  // namespace osculo::support

#pragma once

#include <string>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "osculo/math/floating_point.hpp"

namespace osculo::support {

using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Digits100 = boost::multiprecision::cpp_bin_float_100;

/// The scalar types that ready-made engines exist for.
using AllScalars = ::testing::Types<double, long double, math::Quad, Digits50, Digits100>;
/// Those that are quick.
using NativeScalars = ::testing::Types<double, long double, math::Quad>;

/// Names the instances of typed tests.
struct ScalarName {
    template <class S>
    static std::string GetName(int) {
        if constexpr (std::is_same_v<S, double>) return "double";
        if constexpr (std::is_same_v<S, long double>) return "extended";
        if constexpr (std::is_same_v<S, math::Quad>) return "quad";
        if constexpr (std::is_same_v<S, Digits50>) return "digits50";
        if constexpr (std::is_same_v<S, Digits100>) return "digits100";
        return "other";
    }
};

/// x in units of the rounding of S.
template <math::Scalar S>
[[nodiscard]] double in_epsilons(const S& x) {
    return math::to_double<S>(x / math::epsilon<S>());
}

}  // namespace osculo::support

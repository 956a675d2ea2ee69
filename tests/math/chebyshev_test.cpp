#include "osculo/math/chebyshev.hpp"

#include <gtest/gtest.h>

#include "osculo/math/hyperbolic.hpp"
#include "support/exact_scalars.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class Chebyshev : public testing::Test {};
TYPED_TEST_SUITE(Chebyshev, AllScalars, ScalarName);

template <class S, class F>
math::ChebyshevSeries<S> fitted(F f) {
    std::array<S, math::kChebyshevTerms<S>> values;
    for (std::size_t j = 0; j < values.size(); ++j) {
        values[j] = f(math::ChebyshevNodes<S>::get().at(j));
    }
    return math::chebyshev_fit<S>(values);
}

TYPED_TEST(Chebyshev, FollowsAFunctionItsSlopeAndItsIntegral) {
    using S = TypeParam;
    const auto series = fitted<S>([](const S& x) { return math::sinh_cosh<S>(x).cosh; });
    EXPECT_TRUE(math::chebyshev_resolved<S>(series, S(1)));
    const auto integral = math::chebyshev_integral<S>(series, S(3));
    // The cosines of the wider types err by their angle.
    const S bound = S(math::Builtin<S> ? 20 : 400) * math::epsilon<S>();
    for (int i = -8; i <= 8; ++i) {
        const S x = S(i) / S(8);
        const auto h = math::sinh_cosh<S>(x);
        EXPECT_TRUE(math::abs<S>(math::chebyshev_value<S>(series, x) - h.cosh) <= bound);
        const auto both = math::chebyshev_value_and_slope<S>(series, x);
        EXPECT_TRUE(both.value == math::chebyshev_value<S>(series, x));
        EXPECT_TRUE(math::abs<S>(both.slope - h.sinh) <= S(1000) * bound);
        const S area = S(3) * (h.sinh + math::sinh_cosh<S>(S(1)).sinh);
        EXPECT_TRUE(math::abs<S>(math::chebyshev_value<S>(integral, x) - area) <= S(3) * bound);
    }
}

TYPED_TEST(Chebyshev, SaysWhenItsTermsHaveNotDiedAway) {
    using S = TypeParam;
    const auto series = fitted<S>([](const S& x) { return S(1) / (S(1) + S(25) * x * x); });
    EXPECT_FALSE(math::chebyshev_resolved<S>(series, S(1)));
}

/// The tail of functions that are resolved is rounding, which a tenth of the bound does not cover.
TEST(ChebyshevTail, SufficesAndATenthDoesNot) {
    using S = double;
    int within = 0;
    int within_a_tenth = 0;
    constexpr int kCases = 2000;
    for (int i = 1; i <= kCases; ++i) {
        const S shift = S(i) / kCases;
        const auto series = fitted<S>([&](const S& x) {
            return S(1) / (S(4) + shift + x) + math::sinh_cosh<S>(S(x * shift)).cosh;
        });
        within += math::chebyshev_resolved<S>(series, S(1));
        within_a_tenth += math::chebyshev_resolved<S>(series, S(0.1));
    }
    EXPECT_EQ(within, kCases);
    EXPECT_LT(within_a_tenth, kCases);
}

}  // namespace

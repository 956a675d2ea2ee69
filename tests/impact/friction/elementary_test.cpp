#include <cmath>

#include <gtest/gtest.h>

#include "osculo/impact/friction.hpp"
#include "osculo/math/trigonometry.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

// The elementary functions that the impact laws need, against Boost's in 50 digits.
namespace osculo::math {
namespace {

using support::Digits50;

template <class S>
class Elementary : public testing::Test {
protected:
    static double error(const S& computed, const Digits50& exact) {
        return std::abs(static_cast<double>((support::exact<Digits50>(computed) - exact) /
                                            support::exact<Digits50>(epsilon<S>())));
    }
};
TYPED_TEST_SUITE(Elementary, support::NativeScalars, support::ScalarName);

TYPED_TEST(Elementary, Exponential) {
    using S = TypeParam;
    support::Random random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const S x = random.magnitude<S>(-40, 9);
        worst = std::max(
            worst, this->error(decaying_exponential<S>(x), exp(-support::exact<Digits50>(x))));
    }
    this->RecordProperty("worst_in_tenths", static_cast<int>(10 * worst));
    EXPECT_LE(worst, kExponentialError);
    EXPECT_GE(worst, 0.25) << "the bound is needlessly large";
    EXPECT_EQ(decaying_exponential<S>(S(0)), S(1));
    EXPECT_EQ(decaying_exponential<S>(never<S>()), S(0));
}

TYPED_TEST(Elementary, SineAndCosine) {
    using S = TypeParam;
    support::Random random(2);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const S x = random.uniform(S(-8), S(8));
        const SinCos<S> both = sin_cos<S>(x);
        worst = std::max({worst, this->error(both.sin, sin(support::exact<Digits50>(x))),
                          this->error(both.cos, cos(support::exact<Digits50>(x)))});
    }
    const double bound = Builtin<S> ? 2 : 10;
    EXPECT_LE(worst, bound);
    // Far away and near a zero, the built-in types reduce with more than their own digits.
    if (Builtin<S>) {
        const S far = S(1e9) * quarter_turn<S>();
        const Digits50 exact = sin(support::exact<Digits50>(far));
        EXPECT_LE(this->error(sin_cos<S>(far).sin / support::rounded<S>(exact), Digits50(1)), 4);
    }
}

TYPED_TEST(Elementary, FirstQuadrantAngle) {
    using S = TypeParam;
    support::Random random(3);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const S y = random.magnitude<S>(-60, 3);
        const S x = random.magnitude<S>(-60, 3);
        const Digits50 exact = atan2(support::exact<Digits50>(y), support::exact<Digits50>(x));
        worst = std::max(
            worst,
            this->error(first_quadrant_angle<S>(y, x) / support::rounded<S>(exact), Digits50(1)));
    }
    EXPECT_LE(worst, 10);
    EXPECT_EQ(first_quadrant_angle<S>(S(0), S(1)), S(0));
}

TEST(Friction, AlciatoresFit) {
    // TP A.28 quotes 0.11, 0.06 and 0.01 at these speeds.
    const impact::Friction<double> mu{0.009951, 0.108, 1.088};
    EXPECT_NEAR(mu(0.0707), 0.11, 0.001);
    EXPECT_NEAR(mu(0.707), 0.06, 0.001);
    EXPECT_NEAR(mu(7.07), 0.01, 0.0001);
    EXPECT_EQ((impact::Friction<double>{0.05}(3.0)), 0.05);
}

}  // namespace
}  // namespace osculo::math

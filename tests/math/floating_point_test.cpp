#include "osculo/math/floating_point.hpp"

#include <gtest/gtest.h>

#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class FloatingPoint : public testing::Test {};
TYPED_TEST_SUITE(FloatingPoint, AllScalars, ScalarName);

TYPED_TEST(FloatingPoint, EpsilonIsTheDistanceFromOneToTheNextNumber) {
    using S = TypeParam;
    const S eps = math::epsilon<S>();
    EXPECT_TRUE(S(1) + eps > S(1));
    EXPECT_TRUE(S(1) + eps / 2 == S(1));  // ties to even
    EXPECT_TRUE(eps == power_of_two<S>(1 - math::ScalarTraits<S>::kDigits));
}

TYPED_TEST(FloatingPoint, NeverIsNotFiniteAndLaterThanEverything) {
    using S = TypeParam;
    const S never = math::never<S>();
    EXPECT_FALSE(math::is_finite<S>(never));
    EXPECT_FALSE(math::is_finite<S>(S(never - never)));
    EXPECT_TRUE(math::is_finite<S>(S(0)));
    EXPECT_TRUE(math::is_finite<S>(S(-1e300)));
    EXPECT_TRUE(S(1e300) < never);
}

TYPED_TEST(FloatingPoint, SquareRootIsCorrectToOneUlp) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const S x = random.magnitude<S>(-1000, 1000);
        EXPECT_LE(error_in_ulp<S>(math::square_root<S>(x), R(sqrt(exact<R>(x)))), 1.0) << bits(x);
        const S root(random.between(1, 1 << 30));
        EXPECT_TRUE(math::square_root<S>(S(root * root)) == root) << bits(root);
    }
    EXPECT_TRUE(math::square_root<S>(S(0)) == S(0));
    const S of_negative = math::square_root<S>(S(-1));
    EXPECT_FALSE(math::is_finite<S>(of_negative));
}

}  // namespace

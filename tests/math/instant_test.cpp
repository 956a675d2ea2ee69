#include "osculo/math/instant.hpp"

#include <gtest/gtest.h>

#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class InstantTest : public testing::Test {};
TYPED_TEST_SUITE(InstantTest, BuiltinScalars, ScalarName);

TYPED_TEST(InstantTest, LocalDurationsLoseNothingAfterAGigasecond) {
    using S = TypeParam;
    Random random(11);
    for (int i = 0; i < 5000; ++i) {
        const math::Instant<S> start =
            math::after<S>(math::Instant<S>(S(1e9)), S(1000 * random.unit<S>()));
        const S wait = random.magnitude<S>(-30, 3);
        const math::Instant<S> end = math::after<S>(start, wait);
        const S measured = math::duration<S>(start, end);
        // The instant resolves 1e9 s to the wide rounding unit, the duration its own last place.
        const Exact resolution = Exact(1e9) * exact<Exact>(math::wide_epsilon<S>());
        EXPECT_LE(abs(Exact(Exact(measured) - Exact(wait))), resolution + ulp<S>(Exact(wait)) / 2)
            << bits(start.hi) << bits(start.lo) << bits(wait);
        EXPECT_EQ(measured, S(-math::duration<S>(end, start)));
        EXPECT_LT(start, end);
    }
}

TYPED_TEST(InstantTest, ABillionEventsInARowKeepTheClock) {
    using S = TypeParam;
    // 2^20 steps stand for them: after a step of 0.1 s the clock is right to 1e-15 of the step.
    math::Instant<S> clock(S(1e9));
    const S step(0.1);
    constexpr int kSteps = 1 << 20;
    for (int i = 0; i < kSteps; ++i) clock = math::after<S>(clock, step);
    const Exact reference = Exact(1e9) + kSteps * Exact(step);
    EXPECT_LE(abs(Exact(exact<Exact>(clock) - reference)), Exact(1e-16));
}

template <class S>
class AnyInstant : public testing::Test {};
TYPED_TEST_SUITE(AnyInstant, AllScalars, ScalarName);

TYPED_TEST(AnyInstant, NeverStaysNever) {
    using S = TypeParam;
    const math::Instant<S> start(S(12));
    EXPECT_TRUE(math::is_never<S>(math::after<S>(start, math::never<S>())));
    EXPECT_FALSE(math::is_never<S>(math::after<S>(start, S(3))));
    EXPECT_TRUE(math::duration<S>(start, math::after<S>(start, S(3))) == S(3));
    EXPECT_TRUE(start < math::Instant<S>(math::never<S>()));
}

}  // namespace

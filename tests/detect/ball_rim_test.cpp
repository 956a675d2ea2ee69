#include "osculo/detect/ball_rim.hpp"

#include <gtest/gtest.h>

#include "support/exact_scalars.hpp"
#include "support/obstacle_families.hpp"
#include "support/tally.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class BallRim : public testing::Test {};
TYPED_TEST_SUITE(BallRim, BuiltinScalars, ScalarName);

/// The centre of the ball counts; its radius does not.
TYPED_TEST(BallRim, IsEnteredWhenTheCentreCrosses) {
    using S = TypeParam;
    Random random(51);
    Tally tally;
    for (int i = 0; i < 10000; ++i) {
        const PointCase<S> p = kContactFamilies<S>[static_cast<std::size_t>(i % 13)].make(random);
        const math::Vec<S> center(random.signed_unit<S>(), random.signed_unit<S>());
        const motion::LinearPath<S> path{math::WidePoint<S>(math::Vec<S>(center + p.c)), p.b};
        const geometry::Rim<S> rim{center, p.s};
        const PointCase<S> seen{rounded_difference<S, Exact>(path.position, center), p.b, p.s};
        const S t = detect::first_contact<S>(path, S(0.3), rim, {}, math::never<S>());
        ASSERT_TRUE(tally.add<S>(t, exact_entry(seen))) << bits(seen);
        EXPECT_EQ(t, detect::first_contact<S>(path, S(7), rim, {}, math::never<S>()));
    }
    EXPECT_LE(tally.quantile(1), 1.0);
}

}  // namespace

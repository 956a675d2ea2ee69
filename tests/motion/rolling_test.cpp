#include "osculo/motion/rolling.hpp"

#include <gtest/gtest.h>

namespace osculo::motion {
namespace {

using Vec = math::Vec<double>;

Rolling::State<double> rolling(const Rolling::Parameters<double>& law, const Vec& velocity) {
    Rolling::State<double> state;
    state.velocity = velocity;
    Rolling::begin(law, state);
    return state;
}

TEST(Rolling, StopsAfterTheSquareOfTheSpeedOverTwiceTheDeceleration) {
    const Rolling::Parameters<double> law{0.125};
    Rolling::State<double> state = rolling(law, {3, 4});
    EXPECT_DOUBLE_EQ(state.remaining, 40);
    const double end = state.remaining;
    Rolling::advance(state, end);
    EXPECT_NEAR(math::norm<double>(state.position.rounded()), 100, 1e-12);  // v^2 / (2 a)
    Rolling::transition(law, state);
    EXPECT_TRUE(Rolling::at_rest(state));
    EXPECT_EQ(state.half_acceleration, Vec(0, 0));
    EXPECT_FALSE(math::is_finite(state.remaining));
}

TEST(Rolling, StopsFromAnySpeed) {
    for (const double speed : {1e-300, 1e-310, 5e-324}) {
        const Rolling::State<double> state = rolling({9.81}, {0, speed});
        EXPECT_EQ(state.half_acceleration, Vec(0, -9.81 / 2)) << speed;
        EXPECT_LE(state.remaining, speed) << speed;
    }
}

TEST(Rolling, WithoutFrictionIsFreeFlight) {
    Rolling::State<double> state = rolling({0}, {1, -2});
    EXPECT_FALSE(math::is_finite(state.remaining));
    Rolling::advance(state, 8.0);
    EXPECT_EQ(state.position.rounded(), Vec(8, -16));
    EXPECT_EQ(state.velocity, Vec(1, -2));
}

// In one go or in many parts.
TEST(Rolling, AdvancingInPartsIsAdvancingAtOnce) {
    const Rolling::Parameters<double> law{0.0981};
    Rolling::State<double> once = rolling(law, {1.7, 0.3});
    Rolling::State<double> parts = once;
    Rolling::advance(once, 10.0);
    for (int i = 0; i < 1000; ++i) Rolling::advance(parts, 0.01);
    EXPECT_NEAR(once.position.rounded().x(), parts.position.rounded().x(), 1e-13);
    EXPECT_NEAR(once.velocity.x(), parts.velocity.x(), 1e-13);
}

TEST(Rolling, AShiftedPathIsTheSamePath) {
    const Rolling::Parameters<double> law{0.0981};
    const auto path = Rolling::path(rolling(law, {1.7, 0.3}));
    auto later = path;
    later.shift(2.0);
    EXPECT_NEAR(later.end, path.end - 2, 1e-14);
    const auto at = [](const ParabolicPath<double>& p, double t) {
        return math::displaced<double>(p.position, p.velocity, p.half_acceleration, t).rounded();
    };
    EXPECT_NEAR(at(later, 3).x(), at(path, 5).x(), 1e-15);
    EXPECT_NEAR(at(later, 3).y(), at(path, 5).y(), 1e-15);
}

}  // namespace
}  // namespace osculo::motion

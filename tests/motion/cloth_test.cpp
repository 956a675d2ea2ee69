#include "osculo/motion/cloth.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace osculo::motion {
namespace {

using Vec = math::Vec<double>;
using State = Cloth::State<double>;

constexpr double kG = 9.81;
const Cloth::Parameters<double> kLaw{0.2 * kG, 0.01 * kG, 0.0127 * kG};

State ball(const Vec& velocity, const math::Vec3<double>& spin = {0, 0, 0},
           const Cloth::Parameters<double>& law = kLaw, double inertia = 0.4) {
    State state;
    state.velocity = velocity;
    state.spin = spin;
    state.radius = 0.028575;
    state.inertia = inertia;
    Cloth::begin(law, state);
    return state;
}

/// Goes on to the end of the phase and into the next.
void finish_phase(State& state, const Cloth::Parameters<double>& law = kLaw) {
    const double end = state.remaining;
    Cloth::advance(state, end);
    Cloth::transition(law, state);
}

// A ball hit in the middle slides 12/49 v^2 / (mu g), for 2/7 v / (mu g), and rolls on with 5/7 v.
TEST(Cloth, AStunnedBallRollsWithFiveSeventhsOfItsSpeed) {
    State state = ball({2, 0});
    EXPECT_EQ(state.phase, ClothPhase::sliding);
    EXPECT_NEAR(state.remaining, 2.0 / 7 * 2 / (0.2 * kG), 1e-15);
    finish_phase(state);
    EXPECT_EQ(state.phase, ClothPhase::rolling);
    EXPECT_NEAR(state.velocity.x(), 10.0 / 7, 1e-15);
    EXPECT_NEAR(state.position.rounded().x(), 12.0 / 49 * 4 / (0.2 * kG), 1e-15);
    EXPECT_EQ(Cloth::slip(state), Vec(0, 0));
    finish_phase(state);
    EXPECT_EQ(state.phase, ClothPhase::rest);
    EXPECT_EQ(state.velocity, Vec(0, 0));
    EXPECT_EQ(state.spin, math::Vec3<double>(0, 0, 0));
}

// v + k R (z x w) ... the angular momentum about the contact point is kept while it slides.
TEST(Cloth, SlidingKeepsWhatRollingIsMadeOf) {
    for (const double k : {0.4, 0.5, 2.0 / 3, 1.0}) {
        State state = ball({1.2, -0.7}, {30, -12, 5}, kLaw, k);
        const Vec u = Cloth::slip(state);
        const Vec expected = state.velocity - (k / (1 + k)) * u;
        finish_phase(state);
        EXPECT_EQ(state.phase, ClothPhase::rolling) << k;
        EXPECT_NEAR(state.velocity.x(), expected.x(), 1e-14) << k;
        EXPECT_NEAR(state.velocity.y(), expected.y(), 1e-14) << k;
    }
}

TEST(Cloth, SideSpinWearsOffByItself) {
    State state = ball({0, 0}, {0, 0, -20});
    EXPECT_EQ(state.phase, ClothPhase::spinning);
    const double decay = 2.5 * 0.0127 * kG / 0.028575;
    EXPECT_NEAR(state.remaining, 20 / decay, 1e-12);
    Cloth::advance(state, 1.0);
    EXPECT_NEAR(state.spin.z(), -20 + decay, 1e-13);
    finish_phase(state);
    EXPECT_EQ(state.phase, ClothPhase::rest);
    // While rolling it stops at zero and stays there.
    State rolling = ball({1, 0}, {0, 1 / 0.028575, 1});
    ASSERT_EQ(rolling.phase, ClothPhase::rolling);
    Cloth::advance(rolling, 5.0);
    EXPECT_EQ(rolling.spin.z(), 0);
    EXPECT_EQ(rolling.phase, ClothPhase::rolling);
}

TEST(Cloth, ABallThatAnImpactLeavesRollingRollsAtOnce) {
    const double r = 0.028575;
    const Vec v(0.3, 1.7);
    State state = ball(v, {-v.y() / r * (1 + 2e-16), v.x() / r * (1 - 2e-16), 0});
    EXPECT_EQ(state.phase, ClothPhase::rolling);
    state = ball(v, {-v.y() / r * (1 + 1e-13), v.x() / r, 0});
    EXPECT_EQ(state.phase, ClothPhase::sliding);
}

TEST(Cloth, FrictionsMayBeZero) {
    const Cloth::Parameters<double> none{0, 0, 0};
    State sliding = ball({1, 0}, {0, 0, 3}, none);
    EXPECT_FALSE(math::is_finite(sliding.remaining));
    Cloth::advance(sliding, 100.0);
    EXPECT_EQ(sliding.velocity, Vec(1, 0));
    EXPECT_EQ(sliding.spin.z(), 3);
    EXPECT_EQ(sliding.position.rounded(), Vec(100, 0));
    State rolling = ball({1, 0}, {0, 1 / 0.028575, 0}, none);
    EXPECT_EQ(rolling.phase, ClothPhase::rolling);
    EXPECT_FALSE(math::is_finite(rolling.remaining));
    State spinning = ball({0, 0}, {0, 0, 3}, none);
    EXPECT_EQ(spinning.phase, ClothPhase::spinning);
    EXPECT_FALSE(math::is_finite(spinning.remaining));
}

TEST(Cloth, ABackspinningBallComesBack) {
    State state = ball({1, 0}, {0, -100, 0});
    finish_phase(state);
    EXPECT_EQ(state.phase, ClothPhase::rolling);
    EXPECT_LT(state.velocity.x(), 0);
}

}  // namespace
}  // namespace osculo::motion

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "clusters.hpp"
#include "sequential.hpp"
#include "support/scalars.hpp"

// The exact outcomes of NUMERICS 4.2.
namespace osculo::support {
namespace {

using impact::ClusterStatus;
using impact::SymmetricSolver;

template <class S>
class SymmetricTable : public testing::Test {};
using Tested = testing::Types<float, double, long double, math::Quad, Digits50>;
TYPED_TEST_SUITE(SymmetricTable, Tested, ScalarName);

template <math::Scalar S>
void expect_velocities(const Stage<S>& stage, const std::vector<math::Vec<S>>& expected,
                       double epsilons = 16) {
    ASSERT_EQ(stage.cluster.balls.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const math::Vec<S> error = stage.cluster.balls[i].velocity - expected[i];
        EXPECT_LE(in_epsilons<S>(math::norm_max<S>(error)), epsilons)
            << "ball " << i << ": " << math::to_double<S>(stage.vx(i)) << ", "
            << math::to_double<S>(stage.vy(i));
    }
}
template <math::Scalar S>
void expect_speeds(const Stage<S>& stage, const std::vector<S>& expected, double epsilons = 16) {
    std::vector<math::Vec<S>> velocities;
    for (const S& x : expected) velocities.push_back({x, S(0)});
    expect_velocities<S>(stage, velocities, epsilons);
}
template <math::Scalar S>
impact::ClusterOutcome resolve(Stage<S>& stage) {
    const auto outcome = SymmetricSolver<S>().resolve(stage.cluster);
    EXPECT_EQ(outcome.status, ClusterStatus::separated);
    EXPECT_TRUE(outcome.no_approach);
    return outcome;
}

TYPED_TEST(SymmetricTable, T1CradleOfThree) {
    using S = TypeParam;
    auto stage = chain<S>({S(1), S(0), S(0)}, S(1));
    const auto outcome = resolve<S>(stage);
    expect_speeds<S>(stage, {S(0), S(0), S(1)});
    EXPECT_EQ(outcome.reflections, 2);
    EXPECT_TRUE(outcome.well_posed);
}
TYPED_TEST(SymmetricTable, T2CradleOfFive) {
    using S = TypeParam;
    auto stage = chain<S>({S(1), S(0), S(0), S(0), S(0)}, S(1));
    resolve<S>(stage);
    expect_speeds<S>(stage, {S(0), S(0), S(0), S(0), S(1)});
}
TYPED_TEST(SymmetricTable, T3CradleTwoIn) {
    using S = TypeParam;
    auto stage = chain<S>({S(1), S(1), S(0), S(0), S(0)}, S(1));
    resolve<S>(stage);
    expect_speeds<S>(stage, {S(0), S(0), S(0), S(1), S(1)});
}
TYPED_TEST(SymmetricTable, T4Squeeze) {
    using S = TypeParam;
    auto stage = chain<S>({S(1), S(0), S(-1)}, S(1));
    EXPECT_TRUE(resolve<S>(stage).well_posed);
    expect_speeds<S>(stage, {S(-1), S(0), S(1)});
}
TYPED_TEST(SymmetricTable, T5Bernoulli) {
    using S = TypeParam;
    auto stage = bernoulli<S>({S(1), S(0)}, S(1));
    const auto outcome = resolve<S>(stage);
    const S y = root_of<S>(3) / S(5);
    expect_velocities<S>(
        stage, {{fraction<S>(-1, 5), S(0)}, {fraction<S>(3, 5), y}, {fraction<S>(3, 5), -y}});
    EXPECT_FALSE(outcome.well_posed);

    auto sequential = bernoulli<S>({S(1), S(0)}, S(1));
    resolve_sequentially<S>(sequential.cluster, S(16) * math::epsilon<S>());
    const S r = root_of<S>(3) / S(8);
    expect_velocities<S>(
        sequential,
        {{fraction<S>(-1, 8), -r}, {fraction<S>(3, 4), S(2) * r}, {fraction<S>(3, 8), -r}});
}
TEST(SymmetricTableInDouble, T6BernoulliAskew) {
    const double pi = std::acos(-1.0);
    const math::Vec<double> velocity(std::cos(pi / 18), std::sin(pi / 18));
    auto stage = bernoulli<double>(velocity, 1);
    resolve<double>(stage);
    const math::Vec<double> table[] = {{-.19696, .05788}, {.69114, .39903}, {.49063, -.28327}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(stage.vx(i), table[i].x(), 6e-6);
        EXPECT_NEAR(stage.vy(i), table[i].y(), 6e-6);
    }
    // Exactly, by the two impulses of the double impact.
    const math::Vec<double> n[] = {{std::sqrt(3.0) / 2, 0.5}, {std::sqrt(3.0) / 2, -0.5}};
    const double closing[] = {math::dot<double>(velocity, n[0]), math::dot<double>(velocity, n[1])};
    math::Vec<double> cue = velocity;
    for (std::size_t i = 0; i < 2; ++i) {
        // 2 x with ((2, 1/2), (1/2, 2)) x = closing.
        const double impulse = 2 * (8 * closing[i] - 2 * closing[1 - i]) / 15;
        EXPECT_NEAR(stage.vx(i + 1), impulse * n[i].x(), 2e-15);
        EXPECT_NEAR(stage.vy(i + 1), impulse * n[i].y(), 2e-15);
        cue -= impulse * n[i];
    }
    EXPECT_NEAR(stage.vx(0), cue.x(), 2e-15);
    EXPECT_NEAR(stage.vy(0), cue.y(), 2e-15);
}
TYPED_TEST(SymmetricTable, T7UnequalMasses) {
    using S = TypeParam;
    auto stage = chain<S>({S(1), S(0), S(0)}, S(1), {S(1), S(2), S(3)});
    resolve<S>(stage);
    expect_speeds<S>(stage, {fraction<S>(-1, 3), fraction<S>(-2, 15), fraction<S>(8, 15)});
}

/// A ball on a ball frozen to a cushion, x from the second to the wall.
template <math::Scalar S>
Stage<S> frozen_to_cushion(const S& e) {
    auto stage = chain<S>({S(1), S(0)}, e);
    stage.wall(1, {S(1), S(0)}, e);
    return stage;
}
template <math::Scalar S>
Stage<S> corner(const S& e) {
    Stage<S> stage;
    const std::size_t ball = stage.ball({S(0), S(0)}, {fraction<S>(3, 5), fraction<S>(4, 5)});
    stage.wall(ball, {S(1), S(0)}, e);
    stage.wall(ball, {S(0), S(2)}, e);
    return stage;
}
/// Walls at 60 degrees to each other, symmetric to the x axis.
template <math::Scalar S>
Stage<S> wedge(const S& e) {
    Stage<S> stage;
    const std::size_t ball = stage.ball({S(0), S(0)}, {S(1), S(0)});
    stage.wall(ball, {S(1), root_of<S>(3)}, e);
    stage.wall(ball, {S(1), -root_of<S>(3)}, e);
    return stage;
}

TYPED_TEST(SymmetricTable, T8FrozenToACushion) {
    using S = TypeParam;
    auto stage = frozen_to_cushion<S>(S(1));
    EXPECT_TRUE(resolve<S>(stage).well_posed);
    expect_speeds<S>(stage, {S(-1), S(0)});
}
TYPED_TEST(SymmetricTable, T9Corner) {
    using S = TypeParam;
    for (const double e : {1.0, 0.5, 0.0}) {
        auto stage = corner<S>(S(e));
        EXPECT_TRUE(resolve<S>(stage).well_posed) << e;
        expect_velocities<S>(stage, {{fraction<S>(-3, 5) * S(e), fraction<S>(-4, 5) * S(e)}});
    }
}
TYPED_TEST(SymmetricTable, T10Wedge) {
    using S = TypeParam;
    auto stage = wedge<S>(S(1));
    EXPECT_TRUE(resolve<S>(stage).well_posed);
    expect_speeds<S>(stage, {S(-1)});
}
TYPED_TEST(SymmetricTable, T11RackOfFifteen) {
    using S = TypeParam;
    Rack<S> rack({S(1), S(0)}, S(1));
    ASSERT_EQ(rack.stage.cluster.contacts.size(), 31U);
    const auto outcome = resolve<S>(rack.stage);
    EXPECT_EQ(outcome.reflections, 6);
    EXPECT_FALSE(outcome.well_posed);
    EXPECT_NEAR(math::to_double<S>(rack.stage.vx(0)), -0.2, 1e-5);
    for (const int side : {0, 4}) {
        const std::size_t corner_ball = Rack<S>::index(4, side);
        EXPECT_NEAR(math::to_double<S>(rack.stage.vx(corner_ball)), 0.5118, 6e-5);
        EXPECT_NEAR(math::to_double<S>(rack.stage.vy(corner_ball)), side == 0 ? -0.2955 : 0.2955,
                    6e-5);
    }
    S worst(0);
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            const auto& v = rack.stage.cluster.balls[Rack<S>::index(row, place)].velocity;
            const auto& w = rack.stage.cluster.balls[Rack<S>::index(row, row - place)].velocity;
            worst = std::max({worst, math::abs<S>(v.x() - w.x()), math::abs<S>(v.y() + w.y())});
        }
    }
    EXPECT_LE(in_epsilons<S>(worst), 10);
}

TYPED_TEST(SymmetricTable, BelowOne) {
    using S = TypeParam;
    auto t1 = chain<S>({S(1), S(0), S(0)}, fraction<S>(9, 10));
    EXPECT_FALSE(resolve<S>(t1).well_posed);
    expect_speeds<S>(t1, {fraction<S>(1, 30), fraction<S>(1, 30), fraction<S>(14, 15)});
    auto half = chain<S>({S(1), S(0), S(0)}, S(0.5));
    resolve<S>(half);
    expect_speeds<S>(half, {fraction<S>(1, 6), fraction<S>(1, 6), fraction<S>(2, 3)});
    for (const S& e : {S(0), S(0.25), S(0.5), fraction<S>(19, 20)}) {
        auto t5 = bernoulli<S>({S(1), S(0)}, e);
        resolve<S>(t5);
        const S x = fraction<S>(3, 10) * (S(1) + e);
        const S y = root_of<S>(3) / S(10) * (S(1) + e);
        expect_velocities<S>(t5,
                             {{fraction<S>(2, 5) - fraction<S>(3, 5) * e, S(0)}, {x, y}, {x, -y}});
        auto t8 = frozen_to_cushion<S>(e);
        resolve<S>(t8);
        expect_speeds<S>(t8, {-e, S(0)});
        auto t10 = wedge<S>(e);
        resolve<S>(t10);
        expect_speeds<S>(t10, {-e});
    }
}

TYPED_TEST(SymmetricTable, PairByPairForComparison) {
    using S = TypeParam;
    const S noise = S(16) * math::epsilon<S>();
    auto t1 = chain<S>({S(1), S(0), S(0)}, fraction<S>(9, 10));
    EXPECT_EQ(resolve_sequentially<S>(t1.cluster, noise), 3);
    expect_speeds<S>(
        t1, {fraction<S>(47625, 1000000), fraction<S>(49875, 1000000), fraction<S>(9025, 10000)});
    auto half = chain<S>({S(1), S(0), S(0)}, S(0.5));
    resolve_sequentially<S>(half.cluster, noise);
    expect_speeds<S>(half, {fraction<S>(13, 64), fraction<S>(15, 64), fraction<S>(36, 64)});
    // Without restitution only ever closer; the projection is there at once.
    auto stuck = chain<S>({S(1), S(0), S(0)}, S(0));
    const int steps = resolve_sequentially<S>(stuck.cluster, S(1e-6));
    EXPECT_GT(steps, 15);
    auto at_once = chain<S>({S(1), S(0), S(0)}, S(0));
    EXPECT_EQ(resolve<S>(at_once).reflections, 0);
    expect_speeds<S>(at_once, {fraction<S>(1, 3), fraction<S>(1, 3), fraction<S>(1, 3)});
}

}  // namespace
}  // namespace osculo::support

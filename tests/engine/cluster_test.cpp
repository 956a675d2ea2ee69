#include <cmath>

#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/scalars.hpp"

// Contacts of one instant, through the engine: what touches is found and resolved at once. Expected
// outcomes: NUMERICS 4.2, closed forms.
namespace osculo::support {
namespace {

template <class S>
class Cluster : public ::testing::Test {};
TYPED_TEST_SUITE(Cluster, NativeScalars, ScalarName);

template <math::Scalar S>
void expect_velocities(const Played<SymmetricTable<S>>& played,
                       const std::vector<math::Vec<double>>& expected, double tolerance = 64) {
    ASSERT_EQ(played.bodies.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const math::Vec<S> error =
            played.velocity(i) - math::Vec<S>(S(expected[i].x()), S(expected[i].y()));
        // Expected values have the rounding of double.
        const double unit = std::max(math::to_double<S>(math::epsilon<S>()), 2.3e-16);
        EXPECT_LE(math::to_double<S>(math::norm1<S>(error)), tolerance * unit)
            << "ball " << i << ": " << math::to_double<S>(played.velocity(i).x()) << " "
            << math::to_double<S>(played.velocity(i).y());
    }
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

/// The first of them comes from the left, a little before it meets the others.
template <math::Scalar S>
Builder<SymmetricTable<S>> row(int in, int balls) {
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    for (int k = 0; k < in + balls; ++k) {
        const bool moves = k < in;
        builder.ball(Vec(S(2 * k) - (moves ? S(0.5) : S(0)), S(0)), Vec(S(moves ? 1 : 0), S(0)));
    }
    return builder;
}

TYPED_TEST(Cluster, CradlesPassTheBlowOn) {
    using S = TypeParam;
    for (int in = 1; in <= 3; ++in) {
        for (int balls = 2; balls <= 5; ++balls) {
            const auto played = play<SymmetricTable<S>>(row<S>(in, balls).scene, S(1));
            std::vector<math::Vec<double>> expected;
            for (int k = 0; k < in + balls; ++k) expected.push_back({k < balls ? 0.0 : 1.0, 0});
            expect_velocities<S>(played, expected);
        }
    }
}

TYPED_TEST(Cluster, SqueezedFromBothSidesTheMiddleOneStays) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    builder.ball(Vec(S(-3), S(0)), Vec(S(1), S(0)))
        .ball(Vec(S(0), S(0)), Vec(S(0), S(0)))
        .ball(Vec(S(3), S(0)), Vec(S(-1), S(0)));
    expect_velocities<S>(play<SymmetricTable<S>>(builder.scene, S(2)), {{-1, 0}, {0, 0}, {1, 0}});
}

/// A ball onto two that touch, its direction turned by the angle from their axis.
template <math::Scalar S, class Simultaneous = impact::Symmetric>
Builder<TableScene<S, Simultaneous>> onto_two(double angle, const S& restitution) {
    using Vec = math::Vec<S>;
    const S height = math::square_root<S>(S(3));
    const Vec direction(S(std::cos(angle)), S(std::sin(angle)));
    Builder<TableScene<S, Simultaneous>> builder;
    builder.ball(Vec(S(0), S(0)) - direction / S(2), direction)
        .ball(Vec(height, S(1)), Vec(S(0), S(0)))
        .ball(Vec(height, S(-1)), Vec(S(0), S(0)));
    builder.scene.ball_ball_restitution = restitution;
    return builder;
}

TYPED_TEST(Cluster, CueBallOntoTwoTouchingBalls) {
    using S = TypeParam;
    const double root = std::sqrt(3.0);
    // Away at 30 degrees to both sides, with 2 sqrt(3) / 5 of the speed.
    expect_velocities<S>(play<SymmetricTable<S>>(onto_two<S>(0, S(1)).scene, S(1)),
                         {{-0.2, 0}, {0.6, root / 5}, {0.6, -root / 5}});
    const double e = 0.5;
    expect_velocities<S>(play<SymmetricTable<S>>(onto_two<S>(0, S(e)).scene, S(1)),
                         {{0.4 - 0.6 * e, 0},
                          {0.3 * (1 + e), root / 10 * (1 + e)},
                          {0.3 * (1 + e), -root / 10 * (1 + e)}});
}

TEST(ClusterInDouble, IsOneEventPerContactWithOneNumber) {
    const auto played = play<SymmetricTable<double>>(onto_two<double>(0, 1.0).scene, 1.0);
    ASSERT_EQ(played.events, 2U);
    ASSERT_EQ(played.record.events.size(), 2U);
    for (const auto& event : played.record.events) {
        EXPECT_EQ(event.cluster.number, 1U);
        EXPECT_FALSE(event.cluster.well_posed);  // 104.5 degrees
    }
    // A cradle's outcome is unique.
    const auto cradle = play<SymmetricTable<double>>(row<double>(1, 2).scene, 1.0);
    ASSERT_EQ(cradle.record.events.size(), 2U);
    EXPECT_TRUE(cradle.record.events[0].cluster.well_posed);
}

TYPED_TEST(Cluster, BallOntoABallThatIsFrozenToAWall) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    builder.ball(Vec(S(-3), S(0)), Vec(S(1), S(0))).ball(Vec(S(0), S(0)), Vec(S(0), S(0)));
    builder.wall(Vec(S(1), S(-9)), Vec(S(1), S(9)));
    expect_velocities<S>(play<SymmetricTable<S>>(builder.scene, S(2)), {{-1, 0}, {0, 0}});
}

TYPED_TEST(Cluster, BallIntoACorner) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    builder.ball(Vec(S(0), S(0)), Vec(S(0.6), S(0.8)));
    builder.wall(Vec(S(1.6), S(-9)), Vec(S(1.6), S(9))).wall(Vec(S(-9), S(1.8)), Vec(S(9), S(1.8)));
    expect_velocities<S>(play<SymmetricTable<S>>(builder.scene, S(2)), {{-0.6, -0.8}});
}

TYPED_TEST(Cluster, TheSameTenDegreesOff) {
    using S = TypeParam;
    // NUMERICS 4.2, T6, to the digits given there.
    const double angle = std::acos(-1.0) / 18;
    const auto played = play<SymmetricTable<S>>(onto_two<S>(angle, S(1)).scene, S(1));
    const double expected[][2]{{-.19696, .05788}, {.69114, .39903}, {.49063, -.28327}};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(math::to_double<S>(played.velocity(k).x()), expected[k][0], 6e-6) << k;
        EXPECT_NEAR(math::to_double<S>(played.velocity(k).y()), expected[k][1], 6e-6) << k;
    }
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

TYPED_TEST(Cluster, ChainOfUnequalMasses) {
    using S = TypeParam;
    auto scene = row<S>(1, 2).scene;
    for (int k = 0; k < 3; ++k) scene.bodies[static_cast<std::size_t>(k)].mass = S(k + 1);
    expect_velocities<S>(play<SymmetricTable<S>>(scene, S(1)),
                         {{-1.0 / 3, 0}, {-2.0 / 15, 0}, {8.0 / 15, 0}});
}

/// Where a face ends in its end point, and where two faces join, a ball meets one thing.
TYPED_TEST(Cluster, WhatJoinsIsOneContact) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (const double offset : {0.0, 1e-30, -1e-30, 1e-17, -1e-17, 1e-12, -1e-12, 1e-6, -1e-6}) {
        for (const double slope : {0.0, 1e-17, -1e-17, 1e-9, -1e-9, 1e-3, -1e-3}) {
            Builder<SymmetricTable<S>> builder;
            builder.wall(Vec(S(-100), S(0)), Vec(S(0), S(0)), true)
                .wall(Vec(S(0), S(0)), Vec(S(100), S(0)), true)
                .ball(Vec(S(offset), S(5)), Vec(S(slope), S(-1)));
            const auto played = play<SymmetricTable<S>>(builder.scene, S(50), 10);
            ASSERT_EQ(played.events, 1U) << offset << " " << slope;
            ASSERT_EQ(played.velocity(0).y(), S(1));
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
}

/// Between parallel walls one diameter apart a ball cannot bounce: it goes on along them.
TYPED_TEST(Cluster, JammedBetweenWalls) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    builder.wall(Vec(S(-1000), S(0)), Vec(S(1000), S(0)), true)
        .wall(Vec(S(1000), S(2)), Vec(S(-1000), S(2)), true)
        .ball(Vec(S(0), S(1)), Vec(S(1), S(-1)));
    const auto played = play<SymmetricTable<S>>(builder.scene, S(100));
    EXPECT_EQ(played.status, Status::time_limit);
    EXPECT_EQ(played.events, 1U);
    EXPECT_EQ(played.position(0), Vec(S(100), S(1)));
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

/// The balls of a scene in another order, and back.
template <class Type>
std::vector<engine::Body<Type>> reordered(const std::vector<engine::Body<Type>>& bodies,
                                          std::size_t step) {
    std::vector<engine::Body<Type>> result(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) result[k * step % bodies.size()] = bodies[k];
    return result;
}

/// A rack of fifteen touching balls, the cue ball on its axis.
Builder<SymmetricTable<double>> rack(double spacing, double speed) {
    using Vec = math::Vec<double>;
    Builder<SymmetricTable<double>> builder;
    builder.ball(Vec(-2.25, 0), Vec(speed, 0));
    for (int r = 0; r < 5; ++r) {
        for (int c = 0; c <= r; ++c) {
            builder.ball(Vec(r * std::sqrt(0.75) * (2 + spacing), (c - r / 2.0) * (2 + spacing)),
                         Vec(0, 0));
        }
    }
    return builder;
}

TEST(ClusterInDouble, ARackIsHitSymmetrically) {
    for (const double e : {1.0, 0.95, 0.0}) {
        auto builder = rack(0, 1);
        builder.scene.ball_ball_restitution = e;
        const auto played = play<SymmetricTable<double>>(builder.scene, 0.3);
        for (int r = 0; r < 5; ++r) {
            const int first = 1 + r * (r + 1) / 2;
            for (int c = 0; c <= r; ++c) {
                const auto one = played.velocity(static_cast<std::size_t>(first + c));
                const auto mirrored = played.velocity(static_cast<std::size_t>(first + r - c));
                EXPECT_NEAR(one.x(), mirrored.x(), 1e-14) << e << " " << r << " " << c;
                EXPECT_NEAR(one.y(), -mirrored.y(), 1e-14) << e << " " << r << " " << c;
            }
        }
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
        if (e == 1.0) {  // NUMERICS 4.2, T11
            EXPECT_NEAR(played.velocity(0).x(), -0.2, 1e-4);
            EXPECT_NEAR(played.velocity(11).x(), 0.5118, 1e-4);
            EXPECT_NEAR(std::abs(played.velocity(11).y()), 0.2955, 1e-4);
        }
    }
}

TEST(ClusterInDouble, TheOrderOfBallsDoesNotMatter) {
    for (const double e : {1.0, 0.9, 0.0}) {
        auto builder = rack(0, 1);
        builder.scene.bodies[0].state.velocity = {1, 0.3};
        builder.scene.ball_ball_restitution = e;
        const auto played = play<SymmetricTable<double>>(builder.scene, 0.3);
        for (const std::size_t step : {3U, 5U, 7U, 15U}) {
            auto scene = builder.scene;
            scene.bodies = reordered(builder.scene.bodies, step);
            const auto other = play<SymmetricTable<double>>(scene, 0.3);
            for (std::size_t k = 0; k < 16; ++k) {
                const math::Vec<double> off = played.velocity(k) - other.velocity(k * step % 16);
                EXPECT_LT(math::norm<double>(off), 1e-13) << e << " " << step << " " << k;
            }
        }
    }
}

// Pair by pair, the first of two equal contacts decides.
TEST(ClusterInDouble, SequentialIsAnotherLaw) {
    const auto scene = onto_two<double, impact::Sequential>(0, 1.0).scene;
    const auto played = play<TableScene<double>>(scene, 1.0);
    EXPECT_GT(std::abs(played.velocity(0).y()), 0.1);  // (-1/8, -+sqrt(3)/8)
    EXPECT_NEAR(played.velocity(0).x(), -0.125, 1e-12);
    EXPECT_EQ(played.record.events.front().cluster.number, 0U);
}

// What does not touch is none of a cluster, however near.
TEST(ClusterInDouble, AGapKeepsThingsApart) {
    const auto played = play<SymmetricTable<double>>(rack(1e-9, 1).scene, 0.3);
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    // The cue ball gives the first one all of its speed before that meets any other.
    ASSERT_GE(played.record.events.size(), 3U);
    EXPECT_EQ(played.record.events[0].cluster.number, 0U);
    EXPECT_EQ(played.record.events[0].after[0].velocity, math::Vec<double>(0, 0));
    EXPECT_TRUE(played.record.events[0].when < played.record.events[1].when);
}

}  // namespace
}  // namespace osculo::support

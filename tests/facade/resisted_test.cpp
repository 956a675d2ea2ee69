#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

Scene one_ball(const ResistedMotion& motion, double speed) {
    Scene scene;
    scene.motion = motion;
    scene.balls = {test::ball("a", {0, 0}, {speed, 0}, 0.05)};
    scene.limits.time = 100;
    return scene;
}

// v' = -(m + c v^2) rests after atan(v sqrt(c / m)) / sqrt(m c), log(1 + c v^2 / m) / (2 c) away.
TEST(ResistedScene, RestsWhereAndWhenTheTextbookSays) {
    const double m = 0.1;
    const double c = 0.004;
    const double v = 5;
    const auto run = simulate(one_ball({m, 0, c, {}}, v));
    EXPECT_EQ(run.status, Status::at_rest);
    EXPECT_NEAR(run.time, std::atan(v * std::sqrt(c / m)) / std::sqrt(m * c), 1e-13);
    EXPECT_NEAR(run.balls[0].state.position.x, std::log(1 + c * v * v / m) / (2 * c), 1e-12);
    EXPECT_EQ(run.balls[0].state.velocity, (Point{0, 0}));
    EXPECT_EQ(run.events.size(), 1U);
    EXPECT_EQ(run.events[0].from, Phase::resisted);
    EXPECT_EQ(run.events[0].to, Phase::rest);
}

// A pool ball, with the numbers of NUMERICS 7.6: stopping distances with and without the air.
TEST(ResistedScene, AirShortensTheWayOfAPoolBall) {
    const double rolling = 0.01 * 9.81;
    for (const auto& [speed, distance, time] :
         {std::array{1.0, 5.02, 10.1}, {3.0, 40.5, 28.1}, {8.0, 180.0, 55.0}}) {
        ResistedMotion motion{rolling, 0, 0, Medium{1.2, 0, 0.47, true}};
        Scene scene = one_ball(motion, speed);
        scene.balls[0].mass = 0.17;
        scene.balls[0].radius = 0.028575;
        const auto run = simulate(scene);
        EXPECT_NEAR(run.balls[0].state.position.x, distance, 0.01 * distance);
        EXPECT_NEAR(run.time, time, 0.01 * time);
    }
}

TEST(ResistedScene, AMediumGivesEachBallItsOwnDrag) {
    const double pi = std::numbers::pi;
    ResistedMotion motion{0.1, 0.25, 0.5, Medium{2, 0.125, 0.5, false}};
    Scene scene = one_ball(motion, 1);
    scene.balls.push_back(test::ball("b", {0, 9}, {1, 0}, 0.2));
    scene.balls[0].mass = 2;
    scene.balls[1].mass = 3;
    const auto run = simulate(scene);
    for (const Piece& piece : run.pieces) {
        if (piece.phase != Phase::resisted) continue;
        const Ball& ball = scene.balls[piece.ball];
        const double r = ball.radius;
        EXPECT_EQ(piece.resistance[0], 0.1);
        EXPECT_NEAR(piece.resistance[1], 0.25 + 6 * pi * 0.125 * r / ball.mass, 1e-15);
        EXPECT_NEAR(piece.resistance[2], 0.5 + 2 * 0.5 * pi * r * r / (2 * ball.mass), 1e-15);
    }
}

TEST(ResistedScene, AtFollowsThePieces) {
    Scene scene = one_ball({0.05, 0.05, 0.02, {}}, 2);
    test::add_box(scene, 4, 4);
    scene.balls[0].position = {1, 1.5};
    scene.balls[0].velocity = {2, 0.7};
    scene.balls.push_back(test::ball("b", {3, 2}, {-1, 0.5}, 0.3));
    const auto run = simulate(scene, {.audit = true});
    EXPECT_TRUE(run.audit->clean);
    ASSERT_GT(run.events.size(), 3U);
    for (const Event& event : run.events) {
        const auto at = run.at(event.ball, event.time);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->position.x, event.before[0].position.x, 1e-14);
        EXPECT_NEAR(at->position.y, event.before[0].position.y, 1e-14);
    }
}

TEST(ResistedScene, WithAConstantAloneItIsRolling) {
    Scene scene = one_ball({0.0981, 0, 0, {}}, 2);
    test::add_box(scene, 4, 4);
    scene.balls[0].position = {1, 1.5};
    scene.balls.push_back(test::ball("b", {3, 1.6}, {-1, 0.5}, 0.3));
    Scene rolling = scene;
    rolling.motion = RollingMotion{0.01};
    const auto one = simulate(scene);
    const auto other = simulate(rolling);
    ASSERT_EQ(one.events.size(), other.events.size());
    for (std::size_t i = 0; i < one.events.size(); ++i) {
        EXPECT_EQ(one.events[i].kind, other.events[i].kind);
        EXPECT_NEAR(one.events[i].time, other.events[i].time, 1e-11);
    }
}

TEST(ResistedScene, WithNothingItIsUniform) {
    Scene scene = one_ball({}, 2);
    test::add_box(scene, 4, 4);
    scene.balls[0].position = {1, 1.5};
    scene.balls.push_back(test::ball("b", {3, 1.6}, {-1, 0.5}, 0.3));
    scene.limits.time = 10;
    Scene uniform = scene;
    uniform.motion = UniformMotion{};
    const auto one = simulate(scene);
    const auto other = simulate(uniform);
    ASSERT_EQ(one.events.size(), other.events.size());
    EXPECT_EQ(one.balls, other.balls);
}

TEST(ResistedScene, LinearDragAloneComesNearToItsEnd) {
    Scene scene = one_ball({0, 0.5, 0, {}}, 2);
    scene.limits.time = 30;
    const auto run = simulate(scene);
    EXPECT_EQ(run.status, Status::time_limit);
    EXPECT_NEAR(run.balls[0].state.position.x, 4 * (1 - std::exp(-15)), 1e-14);
}

/// Nothing hangs and nothing is NaN, whatever the orders of magnitude.
TEST(ResistedScene, ExtremesEnd) {
    for (const double speed : {1e-300, 1e-160, 1e-20, 1.0, 1e10, 1e30}) {
        for (const double constant : {0.0, 1e-30, 1.0, 1e30}) {
            for (const double linear : {0.0, 1e-30, 1e30}) {
                for (const double quadratic : {0.0, 1e-30, 1e30}) {
                    Scene scene = one_ball({constant, linear, quadratic, {}}, speed);
                    test::add_box(scene, 4, 4);
                    scene.balls[0].position = {1, 1.5};
                    scene.balls[0].velocity = {speed, speed / 3};
                    scene.balls.push_back(test::ball("b", {3, 2}, {-speed, 0}, 0.25));
                    scene.limits.events = 1000;
                    const auto run = simulate(scene);
                    for (const FinalBall& ball : run.balls) {
                        const auto& [place, velocity, spin] = ball.state;
                        if (run.status == Status::numeric) continue;
                        ASSERT_TRUE(std::isfinite(place.x + velocity.x)) << speed;
                        ASSERT_TRUE(place.x > 0 && place.x < 4 && place.y > 0 && place.y < 4)
                            << speed << " " << constant << " " << linear << " " << quadratic;
                    }
                }
            }
        }
    }
}

TEST(ResistedScene, ThePiecesOfWiderTypesAgree) {
    Scene scene = one_ball({0.1, 0.05, 0.2, {}}, 3);
    test::add_box(scene, 2, 2);
    scene.balls[0].position = {0.5, 0.7};
    scene.balls.push_back(test::ball("b", {1.5, 1}, {-1, 0.5}, 0.1));
    const auto one = simulate(scene);
    const auto wide = simulate(scene, {.precision = Precision::extended, .audit = true});
    EXPECT_TRUE(wide.audit->clean);
    ASSERT_EQ(one.events.size(), wide.events.size());
    for (std::size_t i = 0; i < one.events.size(); ++i) {
        EXPECT_NEAR(one.events[i].time, wide.events[i].time, 1e-11);
    }
}

}  // namespace
}  // namespace osculo

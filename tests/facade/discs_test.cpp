#include <cmath>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

Scene disc_at_a_wall(double spin, double along) {
    Scene scene;
    test::add_box(scene, 4, 4);
    scene.balls = {test::ball("a", {2, 2}, {along, -1}, 0.25)};
    scene.balls[0].spin = {0, 0, spin};
    scene.balls[0].inertia = 0.5;
    scene.impacts.ball_cushion.law = CushionLaw::frictional;
    scene.impacts.ball_cushion.friction = 0.2;
    scene.limits.time = 2;
    return scene;
}

// Downwards onto the bottom wall: t = z x n with n = (0, -1) is +x, and the boundary slips along it
// at u = vx + r w. Friction takes min(mu (1 + e) vn, u / (1 + 1/k)) of vx, r k w as much.
TEST(Discs, SpinTurnsAPuckAtAWall) {
    const auto slipping = simulate(disc_at_a_wall(8, 0));  // u = 2, mu (1 + e) vn = 0.4 < 2 / 3
    const BallState& state = slipping.balls[0].state;
    EXPECT_NEAR(state.velocity.x, -0.4, 1e-15);
    EXPECT_NEAR(state.velocity.y, 1, 1e-15);
    EXPECT_NEAR(state.spin[2], 8 - 0.4 / (0.5 * 0.25), 1e-14);

    const auto sticking = simulate(disc_at_a_wall(2, 0.25));  // u = 0.75, 0.75 / 3 = 0.25 < 0.4
    EXPECT_NEAR(sticking.balls[0].state.velocity.x, 0, 1e-15);
    EXPECT_NEAR(sticking.balls[0].state.spin[2], 2 - 0.25 / (0.5 * 0.25), 1e-14);
    EXPECT_EQ(sticking.pieces[0].phase, Phase::uniform);
}

TEST(Discs, AllMotionsButClothHaveThem) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.02}),
                                    MotionLaw(ResistedMotion{0.1, 0.1, 0.1, {}})}) {
        Scene scene = disc_at_a_wall(5, 0.3);
        scene.motion = motion;
        scene.balls.push_back(test::ball("b", {1, 1.2}, {0.5, 0.1}, 0.25));
        scene.balls.push_back(test::ball("c", {3, 1.1}, {-0.9, 0.4}, 0.25));
        scene.impacts.ball_ball = {BallBallLaw::frictional, 0.9, {0.1, 0, 0}};
        scene.limits.time = 20;
        const auto run = simulate(scene, {.audit = true});
        EXPECT_TRUE(run.audit->clean);
        EXPECT_GT(run.events.size(), 5U);
        EXPECT_EQ(run.engine.name.substr(0, 18), "disc/disc_friction");
        for (const FinalBall& ball : run.balls) {
            EXPECT_EQ(ball.state.spin[0], 0);
            EXPECT_EQ(ball.state.spin[1], 0);
        }
        // What is evaluated from the pieces keeps its spin.
        const auto spin = run.at(0, 0.5 * run.events[0].time)->spin;
        EXPECT_EQ(spin, run.scene.balls[0].spin);
    }
}

/// Friction that is zero changes nothing.
TEST(Discs, WithoutFrictionTheyAreThoseOfTheFrictionlessEngine) {
    Scene scene = disc_at_a_wall(5, 0.3);
    scene.balls.push_back(test::ball("b", {1, 1.2}, {0.5, 0.1}, 0.25));
    scene.impacts.ball_cushion.friction = 0;
    scene.limits.time = 20;
    Scene plain = scene;
    plain.impacts.ball_cushion = {};
    const auto one = simulate(scene);
    const auto other = simulate(plain);
    ASSERT_EQ(one.events.size(), other.events.size());
    for (std::size_t i = 0; i < one.balls.size(); ++i) {
        EXPECT_EQ(one.balls[i].state.position, other.balls[i].state.position);
        EXPECT_EQ(one.balls[i].state.velocity, other.balls[i].state.velocity);
    }
}

TEST(Discs, ScenesMustBeThoseOfDiscs) {
    const auto message = [](const Scene& scene) -> std::string {
        try {
            static_cast<void>(simulate(scene));
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    Scene scene = disc_at_a_wall(5, 0.3);
    scene.balls[0].spin[1] = 2;
    EXPECT_EQ(message(scene),
              "balls[0].spin: must be [0, 0, z] where there is friction but no cloth, but it is "
              "[0, 2, 5]");
    scene = disc_at_a_wall(5, 0.3);
    scene.motion = ClothMotion{};
    EXPECT_EQ(message(scene),
              "impacts.ball_cushion.law: must not be frictional with cloth, where cushions have "
              "noses: han_2005, mathavan_2010 or stronge, but it is frictional");
}

}  // namespace
}  // namespace osculo

#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"

// What a cue can do to a ball.
namespace osculo::support {
namespace {

Scene struck(double speed, double side, double height, double elevation = 0) {
    Scene scene = cloth_scene();
    scene.balls = {pool_ball("cue", {0, 0})};
    Cue cue;
    cue.ball = "cue";
    cue.speed = speed;
    cue.azimuth = 0;
    cue.elevation = elevation;
    cue.offset = {side, height};
    scene.cue = cue;
    return scene;
}

// Draw: a ball struck low, stopped by a ball of its own mass, comes back.
TEST(Strikes, DrawReverses) {
    Scene scene = struck(4, 0, -0.5);
    scene.balls.push_back(pool_ball("object", {0.4, 0}));
    const auto run = settled(scene);
    OSCULO_EXPECT_SOUND(run);
    const double contact = 0.4 - 2 * kPoolRadius;
    EXPECT_LT(run.balls[0].state.position.x, contact - 0.2);
    EXPECT_GT(run.balls[1].state.position.x, 0.5);
    EXPECT_EQ(run.balls[0].state.position.y, 0);
}

// Follow: struck high, it goes on after the hit.
TEST(Strikes, FollowGoesOn) {
    Scene scene = struck(3, 0, 0.5);
    scene.balls.push_back(pool_ball("object", {0.4, 0}));
    const auto run = settled(scene);
    OSCULO_EXPECT_SOUND(run);
    EXPECT_GT(run.balls[0].state.position.x, 0.5);
    EXPECT_GT(run.balls[1].state.position.x, run.balls[0].state.position.x);
}

// Masse: struck from steeply above and off the centre line, the path curves and may come back.
TEST(Strikes, MasseReverses) {
    const auto run = settled(struck(4, 0.3, -0.4, 1.3));
    OSCULO_EXPECT_SOUND(run);
    ASSERT_GE(run.pieces.size(), 2U);
    const Piece& slide = run.pieces.front();
    EXPECT_EQ(slide.phase, Phase::sliding);
    // It comes to roll against the direction that it started in.
    const Piece& roll = run.pieces[1];
    EXPECT_EQ(roll.phase, Phase::rolling);
    EXPECT_LT(slide.velocity.x * roll.velocity.x + slide.velocity.y * roll.velocity.y, 0);
    // And to the side of the tip's offset.
    EXPECT_GT(std::abs(run.balls[0].state.position.y), 0.01);
    // Rolling speed after sliding, by the moment about the contact point, which friction on the
    // cloth cannot change: (1 + k) v = v0 + k r (wy, -wx), k = 2/5.
    const double vx = (slide.velocity.x + 0.4 * kPoolRadius * slide.spin[1]) / 1.4;
    const double vy = (slide.velocity.y - 0.4 * kPoolRadius * slide.spin[0]) / 1.4;
    EXPECT_NEAR(roll.velocity.x, vx, 1e-14);
    EXPECT_NEAR(roll.velocity.y, vy, 1e-14);
}

// From next to nothing to faster than any cue. At 1e-200 m/s squares underflow.
TEST(Strikes, SpeedsFromNothingToFifty) {
    for (const double speed : {1e-200, 1e-100, 1e-20, 1e-6, 0.01, 1.0, 50.0}) {
        Scene scene = struck(speed, 0.1, 0.2);
        scene.limits.time = 1e6;
        const auto free = settled(scene);
        OSCULO_EXPECT_SOUND(free);
        const Piece& slide = free.pieces.front();
        EXPECT_GT(slide.velocity.x, 0) << speed;
        EXPECT_GE(free.balls[0].state.position.x, 0) << speed;

        presets::add_table(scene, "pool-7ft");
        scene.closed = true;
        scene.cue->allow_obstructed = true;
        scene.balls[0].position = {0.4, 0.4};
        scene.balls.push_back(pool_ball("object", {0.7, 0.41}));
        const auto run = settled(scene);
        OSCULO_EXPECT_SOUND(run);
        EXPECT_LE(run.event_count, 2000U) << speed;
    }
}

}  // namespace
}  // namespace osculo::support

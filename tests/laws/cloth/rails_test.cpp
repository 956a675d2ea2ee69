#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"
#include "support/random.hpp"

// Shots along a table's long axis, and balls frozen to a rail.
namespace osculo::support {
namespace {

// A hundred shots up and down the middle of a carom table, without spin: the ball stays on the
// axis to the last bit and meets the two short cushions in turn.
TEST(Rails, StraightShotsAlongTheLongAxis) {
    Random random(1);
    for (int shot = 0; shot < 100; ++shot) {
        Scene scene = cloth_scene();
        presets::add_table(scene, "carom-10ft");
        const double x = 0.71;
        const double speed = random.uniform<double>(0.1, 8);
        const double y = random.uniform<double>(0.1, 2.7);
        const bool up = random.coin();
        scene.balls = {pool_ball("cue", {x, y}, {0, up ? speed : -speed})};
        if (random.coin()) scene.balls[0].spin = {-scene.balls[0].velocity.y / kPoolRadius, 0, 0};
        const auto run = settled(scene);
        OSCULO_EXPECT_SOUND(run);
        EXPECT_EQ(run.balls[0].state.position.x, x) << shot;
        bool expect_top = up;
        for (const Event& event : run.events) {
            if (event.kind == EventKind::transition) continue;
            ASSERT_EQ(event.kind, EventKind::ball_segment) << shot;
            EXPECT_EQ(run.ids(event)[1], expect_top ? "top" : "bottom") << shot;
            expect_top = !expect_top;
        }
        if (speed > 3) {
            EXPECT_GE(count(run, EventKind::ball_segment), 1) << shot;
        }
    }
}

/// A ball frozen to the middle of a rail along the x axis, with a little room for a gap.
Scene on_the_rail(double gap, Point velocity) {
    Scene scene = cloth_scene();
    scene.segments = {rail("rail", {-5, 0}, {5, 0})};
    scene.balls = {pool_ball("frozen", {0, kPoolRadius + gap}, velocity)};
    return scene;
}

constexpr double kGaps[] = {0, 1e-16, 1e-12, 1e-9, 1e-6};

// Into the rail it comes back by the cushion's law, straight.
TEST(Rails, FrozenBallShotIntoTheRail) {
    for (const double gap : kGaps) {
        for (const double speed : {1e-3, 0.5, 10.0}) {
            const auto run = settled(on_the_rail(gap, {0, -speed}));
            OSCULO_EXPECT_SOUND(run);
            ASSERT_GE(count(run, EventKind::ball_segment), 1) << gap << " " << speed;
            EXPECT_LE(run.event_count, 100U) << gap << " " << speed;
            EXPECT_GT(run.balls[0].state.position.y, kPoolRadius) << gap << " " << speed;
            EXPECT_EQ(run.balls[0].state.position.x, 0) << gap << " " << speed;
        }
    }
}

// Along the rail it never touches it.
TEST(Rails, FrozenBallShotAlongTheRail) {
    for (const double gap : kGaps) {
        for (const double speed : {1e-3, 0.5, 5.0}) {
            const auto run = settled(on_the_rail(gap, {speed, 0}));
            OSCULO_EXPECT_SOUND(run);
            EXPECT_EQ(count(run, EventKind::ball_segment), 0) << gap << " " << speed;
            EXPECT_EQ(run.balls[0].state.position.y, kPoolRadius + gap);
        }
    }
}

TEST(Rails, FrozenBallShotAwayFromTheRail) {
    for (const double gap : kGaps) {
        const auto run = settled(on_the_rail(gap, {0.3, 0.5}));
        OSCULO_EXPECT_SOUND(run);
        EXPECT_EQ(count(run, EventKind::ball_segment), 0) << gap;
    }
}

// Pressed against the rail by its draw: it hops lower and lower until the draw is spent.
TEST(Rails, FrozenBallThatSpinsIntoTheRail) {
    for (const double gap : kGaps) {
        Scene scene = on_the_rail(gap, {0.5, 0});
        scene.balls[0].spin = {40, 0, 0};  // would roll towards -y
        const auto run = settled(scene);
        OSCULO_EXPECT_SOUND(run);
        EXPECT_LE(run.event_count, 20'000U) << gap;
        EXPECT_GE(run.balls[0].state.position.y, kPoolRadius * (1 - 1e-12)) << gap;
    }
}

// An object ball frozen to the rail is hit: head on into the rail, at an angle, along it.
TEST(Rails, ObjectBallFrozenToTheRailIsHit) {
    for (const double gap : kGaps) {
        for (const double angle : {90.0, 60.0, 30.0, 10.0, 1.0, 0.0}) {
            for (const double speed : {0.5, 8.0}) {
                const double radians = angle * 3.141592653589793 / 180;
                Scene scene = on_the_rail(gap, {});
                const double distance = 2 * kPoolRadius + 0.3;
                const Point from{-distance * std::cos(radians),
                                 scene.balls[0].position.y + distance * std::sin(radians)};
                scene.balls.push_back(pool_ball(
                    "cue", from, {speed * std::cos(radians), -speed * std::sin(radians)}));
                const auto run = settled(scene);
                OSCULO_EXPECT_SOUND(run);
                EXPECT_LE(run.event_count, 2000U) << gap << " " << angle << " " << speed;
                EXPECT_GE(count(run, EventKind::ball_ball), 1);
                for (const FinalBall& ball : run.balls) {
                    EXPECT_GE(ball.state.position.y, kPoolRadius * (1 - 1e-12));
                }
            }
        }
    }
}

}  // namespace
}  // namespace osculo::support

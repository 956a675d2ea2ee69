#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"

// Balls that roll the same way, one behind the other: their accelerations are equal, so the quartic
// of their contact has no quartic and no cubic term. Peers lose or invent these contacts.
namespace osculo::support {
namespace {

constexpr double kReach = 2 * kPoolRadius;

/// [behind] rolls at v1, [gap] behind the one that rolls at v2, along the direction of that angle.
Scene chase(double v1, double v2, double gap, double angle) {
    const Point along{std::cos(angle), std::sin(angle)};
    Scene scene = cloth_scene();
    const double distance = kReach + gap;
    scene.balls = {rolling_ball("behind", {0, 0}, {v1 * along.x, v1 * along.y}),
                   rolling_ball("front", {distance * along.x, distance * along.y},
                                {v2 * along.x, v2 * along.y})};
    return scene;
}

constexpr double kAngles[] = {0, 1.5707963267948966, 0.3, 2.0, -2.5};

// At equal speeds their distance never changes, not even by rounding worth the name.
TEST(Chasing, AtEqualSpeedNeverMeets) {
    for (const double angle : kAngles) {
        for (const double gap : {0.0, 1e-12, 1e-3, 0.5}) {
            const auto run = settled(chase(1, 1, gap, angle));
            OSCULO_EXPECT_SOUND(run);
            EXPECT_EQ(count(run, EventKind::ball_ball), 0) << angle << " " << gap;
            const double way = 1 / (2 * kDeceleration);
            EXPECT_NEAR(std::hypot(run.balls[0].state.position.x, run.balls[0].state.position.y),
                        way, 1e-13);
        }
    }
}

// While both roll they close up at a constant rate, down to the smallest.
TEST(Chasing, FasterMeetsAfterGapOverDifference) {
    for (const double angle : kAngles) {
        for (const double difference : {1.0, 0.1, 1e-3, 1e-6}) {
            const double gap = difference * 0.8;  // at 0.8 s
            const auto run = settled(chase(1 + difference, 1, gap, angle));
            OSCULO_EXPECT_SOUND(run);
            ASSERT_GE(count(run, EventKind::ball_ball), 1) << angle << " " << difference;
            // The states have the rounding of positions and speeds of about 1.
            const double uncertain = 4e-16 * 2 / difference;
            EXPECT_NEAR(run.events.front().time, gap / difference, 1e-15 + uncertain);
            EXPECT_EQ(run.events.front().kind, EventKind::ball_ball);
        }
    }
}

// The one in front may stop first: v1 t - a t^2 / 2 = gap + v2^2 / (2 a).
TEST(Chasing, MeetsTheOneThatHasStopped) {
    for (const double angle : kAngles) {
        const double v1 = 1, v2 = 0.2, gap = 2;
        const double a = kDeceleration;
        const double way = gap + v2 * v2 / (2 * a);
        const double expected = 2 * way / (v1 + std::sqrt(v1 * v1 - 2 * a * way));
        ASSERT_GT(expected, v2 / a);
        const auto run = settled(chase(v1, v2, gap, angle));
        OSCULO_EXPECT_SOUND(run);
        ASSERT_GE(run.events.size(), 2U);
        EXPECT_EQ(run.events[0].kind, EventKind::transition);
        EXPECT_EQ(run.events[1].kind, EventKind::ball_ball);
        EXPECT_NEAR(run.events[1].time, expected, 1e-13);
    }
}

// A slower one behind is left behind.
TEST(Chasing, SlowerNeverMeets) {
    for (const double angle : kAngles) {
        const auto run = settled(chase(1, 1.0 + 1e-9, 0, angle));
        OSCULO_EXPECT_SOUND(run);
        EXPECT_EQ(count(run, EventKind::ball_ball), 0) << angle;
    }
}

// Coming to rest where it touches: just short of it, just there, just beyond.
TEST(Chasing, ComingToRestTouchingIsNoStorm) {
    const double way = 0.25 / (2 * kDeceleration);
    for (const double angle : kAngles) {
        for (const double beyond : {-1e-3, -1e-9, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-9, 1e-3}) {
            const Scene scene = chase(0.5, 0, way - beyond, angle);
            const auto run = settled(scene);
            OSCULO_EXPECT_SOUND(run);
            EXPECT_LE(run.event_count, 30U) << angle << " " << beyond;
            if (beyond <= -1e-12) {
                EXPECT_EQ(count(run, EventKind::ball_ball), 0);
            }
            if (beyond >= 1e-12) {
                EXPECT_GE(count(run, EventKind::ball_ball), 1);
            }
            // The one that was at rest gets at most all of the rest of the energy, and what the
            // law of pressed balls may give it (osculo/impact/pressing.hpp): at most the speed that
            // sliding friction gains in the contact time.
            const double gained = 0.2 * 9.81 * scene.impacts.contact_time;
            const double pressed = gained * gained / (2 * kDeceleration);
            const Point p = run.balls[1].state.position;
            const double moved = std::hypot(p.x, p.y) - (kReach + way - beyond);
            EXPECT_LE(moved, 1.02 * std::max(beyond, 0.0) + pressed) << angle << " " << beyond;
        }
    }
}

}  // namespace
}  // namespace osculo::support

#include <cmath>

#include <gtest/gtest.h>

#include "support/extreme_scenes.hpp"

// Far, late, fast, slow, large and small, all at once, in every precision.
namespace osculo::support {
namespace {

const double kRoot3 = std::sqrt(3.0);

void expect_near(Point got, Point expected, double error, const char* what) {
    EXPECT_NEAR(got.x, expected.x, error) << what;
    EXPECT_NEAR(got.y, expected.y, error) << what;
}

// 931322 m there and back between walls 6 m apart: everything is exact in double.
TEST(Scales, BouncesFor1e15SecondsToTheLastBit) {
    Scene scene;
    scene.segments = {wall_at(-1, "left"), wall_at(7, "right")};
    scene.balls = {disk("ball", {0, 0}, {0x1p-30, 0})};
    scene.limits = {1e15, 10'000'000};
    const double way = 1e15 * 0x1p-30;
    const double passages = std::floor(way / 6);
    ASSERT_EQ(std::fmod(passages, 2.0), 0);  // so that it is on its way to the right
    const auto run = simulate(scene, {.record = Record::none});
    EXPECT_EQ(run.status, Status::time_limit);
    EXPECT_EQ(static_cast<double>(run.event_count), passages);
    EXPECT_EQ(run.balls[0].state.position.x, std::fmod(way, 6.0));
    EXPECT_EQ(run.balls[0].state.velocity.x, 0x1p-30);
}

// Where nothing is exact it stays what 100 digits say, to the rounding of the way: 1e6 m of 53
// bits.
TEST(Scales, BouncesFor1e15SecondsAsIn100Digits) {
    Scene scene;
    scene.segments = {wall_at(-1.1, "left"), wall_at(7.3, "right")};
    scene.balls = {disk("ball", {0.1, 0}, {1e-11 / 3, 0})};
    scene.limits = {1e15, 100'000};
    const auto exact = simulate(scene, {.precision = Precision::digits100});
    for (const Way& way : every_way()) {
        const auto run = played(scene, way);
        OSCULO_EXPECT_ENDED(run, time_limit);
        EXPECT_EQ(run.event_count, exact.event_count);
        EXPECT_NEAR(run.balls[0].state.position.x, exact.balls[0].state.position.x, 1e-15 * 1e4);
        EXPECT_EQ(run.balls[0].state.velocity.x, exact.balls[0].state.velocity.x);
    }
}

// Off centre, after 1e9 m and 1e15 s: double knows the way to 1e-16 of itself.
TEST(Scales, MeetsAfter1e9MetresAnd1e15Seconds) {
    constexpr double kSpeed = 0x1p-20;
    for (const Way& way : every_way()) {
        Scene scene;
        scene.balls = {disk("comes", {-1e9, 1}, {kSpeed, 0}), disk("waits", {0, 0})};
        scene.limits.time = 1.1e15;
        const auto run = played(scene, way);
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.event_count, 1U);
        const double error = kSpeed * (way.precision == Precision::double_precision ? 1e-7
                                       : way.precision == Precision::extended       ? 1e-10
                                                                                    : 1e-15);
        expect_near(run.balls[0].state.velocity, {kSpeed / 4, kSpeed * kRoot3 / 4}, error, "comes");
        expect_near(run.balls[1].state.velocity, {0.75 * kSpeed, -kSpeed * kRoot3 / 4}, error,
                    "waits");
    }
}

// 1 um meets 1000 km half of its reach beside the middle.
TEST(Scales, RadiusRatio1e12) {
    for (const Way& way : every_way()) {
        Scene scene;
        scene.balls = {disk("mote", {-5, 0.5e6}, {1, 0}, 1, 1e-6),
                       disk("globe", {1e6, 0}, {}, 1e12, 1e6)};
        scene.limits.time = 2e6;
        const auto run = played(scene, way);
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.event_count, 1U);
        expect_near(run.balls[0].state.velocity, {-0.5, kRoot3 / 2}, 3e-12, "mote");
        expect_near(run.balls[1].state.velocity, {1.5e-12, -kRoot3 / 2 * 1e-12}, 1e-23, "globe");
    }
}

// Masses 1, q, q^2, ..: the push grows by 2 / (1 + q) each time, and each ball keeps (1 - q) / (1 +
// q) of its own.
TEST(Scales, MassesOverFifteenPowersOfTen) {
    for (const Way& way : every_way()) {
        for (const double q : {0.1, 10.0}) {
            Scene scene;
            double mass = 1;
            for (int k = 0; k < 16; ++k, mass *= q) {
                scene.balls.push_back(
                    disk(std::to_string(k), {3.0 * k, 0}, {k == 0 ? 1. : 0., 0}, mass));
            }
            scene.limits.time = q < 1 ? 40 : 1e13;
            const auto run = played(scene, way);
            OSCULO_EXPECT_ENDED(run, time_limit);
            EXPECT_EQ(run.event_count, 15U);
            double push = 1;
            for (std::size_t k = 0; k < 16; ++k, push *= 2 / (1 + q)) {
                const double expected = k < 15 ? push * (1 - q) / (1 + q) : push;
                EXPECT_NEAR(run.balls[k].state.velocity.x / expected, 1, 2e-14) << q << " " << k;
            }
        }
    }
}

TEST(Scales, SpeedsFrom1em150To1e150InOneScene) {
    for (const Way& way : every_way()) {
        Scene scene;
        scene.balls = {disk("fast", {-5, 101}, {1e150, 0}), disk("struck", {0, 100}),
                       disk("slow", {0, 0}, {1e-150, 0}), disk("touched", {2, 0})};
        scene.limits.time = 1e-148;
        const auto run = played(scene, way);
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.event_count, 2U);
        expect_near(run.balls[0].state.velocity, {0.25e150, kRoot3 / 4 * 1e150}, 1e135, "fast");
        expect_near(run.balls[1].state.velocity, {0.75e150, -kRoot3 / 4 * 1e150}, 1e135, "struck");
        expect_near(run.balls[2].state.velocity, {0, 0}, 0, "slow");
        expect_near(run.balls[3].state.velocity, {1e-150, 0}, 1e-165, "touched");
    }
}

/// Nine disks at multiples of 2^-20 m in a box whose corner is at [corner].
Scene nine_disks(Point corner) {
    Scene scene;
    const double x = corner.x, y = corner.y;
    scene.segments = {{"bottom", {x, y}, {x + 8, y}, Side::left},
                      {"right", {x + 8, y}, {x + 8, y + 8}, Side::left},
                      {"top", {x + 8, y + 8}, {x, y + 8}, Side::left},
                      {"left", {x, y + 8}, {x, y}, Side::left}};
    for (int k = 0; k < 9; ++k) {
        const double jitter = ((k * 7919) % 1024 - 512) * 0x1p-12;
        scene.balls.push_back(
            disk(std::to_string(k), {x + 1.25 + 2.5 * (k % 3) + jitter, y + 1.5 + 2.5 * (k / 3)},
                 {((k * 104729) % 2048 - 1024) * 0x1p-10, ((k * 1299709) % 2048 - 1024) * 0x1p-10},
                 1, 0.5));
    }
    scene.limits = {1e9, 40};
    return scene;
}

TEST(Scales, At1e9MetresFromTheOriginAsThere) {
    const auto exact = simulate(nine_disks({0, 0}), {.precision = Precision::digits100});
    for (const Way& way : every_way()) {
        const auto run = played(nine_disks({1e9, -1e9}), way);
        OSCULO_EXPECT_ENDED(run, event_limit);
        for (std::size_t k = 0; k < 9; ++k) {
            expect_near(run.balls[k].state.velocity, exact.balls[k].state.velocity, 1e-9, "disk");
        }
        for (std::size_t k = 0; k < 40; ++k) {
            EXPECT_EQ(run.events[k].kind, exact.events[k].kind) << k;
            EXPECT_EQ(run.events[k].ball, exact.events[k].ball) << k;
            EXPECT_EQ(run.events[k].other, exact.events[k].other) << k;
        }
    }
}

// What presses a ball of 1e-12 kg to one of 1e12 kg gives them more momentum than they met with,
// which is what its rounding is measured by.
TEST(Scales, PressedAtAMassRatioOf1e24) {
    Scene scene;
    scene.motion = RollingMotion{0.2};
    scene.balls = {
        disk("light", {-0.15748031496062992, 0.8503937007874016}, {0, 0}, 1e-12, 0.1),
        disk("heavy", {-0.057480314960629886, 1.0235987815442893}, {-1e-9, 1e-25}, 1e12, 0.1)};
    scene.limits = {10, 300};
    OSCULO_EXPECT_ENDED(played(scene), at_rest);
}

// Drag of the heavy ball is no measure for the light one: it presses them with what it is.
TEST(Scales, DragIsAuditedAtTheSpeedsOfTheImpact) {
    Scene scene;
    scene.motion = ResistedMotion{0.01, 0.01, 0.01, {}};
    scene.impacts.ball_ball.restitution = 0.5;
    scene.balls = {disk("fast", {0, 0}, {1, 0}), disk("struck", {3, 0}),
                   disk("light", {0, 5}, {1e-3, 0}, 1e-12), disk("slow", {3, 5}, {0, 0}, 1e-12)};
    scene.limits.time = 10;
    const auto run = played(scene);
    OSCULO_EXPECT_ENDED(run, time_limit);
    ASSERT_GE(run.event_count, 1U);
    // The loss of the first pair is 3/8 of the energy; nothing else may hide it.
    EXPECT_NEAR(run.audit->largest_energy_gain, -0.375, 1e-6);
}

// A ball of 1e12 kg that one of 1e-12 kg sets going rests after 1e-20 s, of which the clock sees
// 15 digits by then.
TEST(Scales, APushOf1e21MetresPerSecond) {
    for (int k = 0; k < 20; ++k) {
        Scene scene;
        scene.motion = ResistedMotion{0.2, 0.01, 0, {}};
        scene.balls = {disk("light", {0, 0}, {0, 1000}, 1e-12),
                       disk("heavy", {0.3, 5 + 0.1 * k}, {0, 0}, 1e12)};
        scene.limits.time = 1;
        const auto run = played(scene);
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.event_count, 2U);
        EXPECT_EQ(run.events[1].kind, EventKind::transition);
        EXPECT_LT(run.events[1].time - run.events[0].time, 1e-17);
    }
}

// A ball of 1e-12 kg has come to a stop between two points that it fits through but for rounding;
// one of 1e12 kg runs into it. The impulses that stop that exceed what doubles can tell of the
// light one's by far: the run says so, where it would go through it.
TEST(Scales, WedgedAndRunIntoByAMassRatioOf1e24) {
    Scene scene;
    const double x = -0.05748031496062991;
    scene.balls = {disk("light", {-0.15748031496062992, 0.8503937007874016},
                        {0.25000000000000006, 0.4330127018922193}, 1e-12, 0.1),
                   disk("heavy", {-0.2574813149606299, 0.8503937007874016},
                        {0.43301270189221935, 0.24999999999999997}, 1e12, 1e-6)};
    scene.segments = {{"gap", {x, 0.9503937007874016}, {x, 0.7503937007874016}, Side::left}};
    scene.impacts.ball_cushion.restitution = 0;
    scene.limits = {10, 300};
    const auto run = simulate(scene, {.record = Record::events});
    EXPECT_EQ(run.status, Status::numeric);
    EXPECT_EQ(run.events.size(), run.event_count);
    EXPECT_GT(run.time, 0.1);
    for (const FinalBall& b : run.balls) EXPECT_TRUE(std::isfinite(b.state.velocity.x));
}

// Galperin's billiard in one instant, by the default law: pi sqrt(M) / 2 blows of a heavy ball on a
// light one that touches a wall. It is turned round, and what it has is kept.
TEST(Scales, HeavyOnALightBallAtAWall) {
    for (const Precision precision : kEveryPrecision) {
        for (const double mass : {1e4, 1e7, 1e8, 1e12, 1e15, 1e20}) {
            Scene scene;
            scene.balls = {disk("heavy", {-4, 0}, {1, 0}, mass), disk("light", {0, 0})};
            scene.segments = {wall_at(1)};
            scene.limits.time = 3;
            const auto run = played(scene, Way{precision, Simultaneous::symmetric});
            OSCULO_EXPECT_ENDED(run, time_limit);
            ASSERT_EQ(run.events.size(), 2U);
            EXPECT_EQ(run.events[0].cluster, run.events[1].cluster);
            EXPECT_FALSE(run.events[0].well_posed);
            const double heavy = run.balls[0].state.velocity.x;
            const double light = run.balls[1].state.velocity.x;
            EXPECT_LT(heavy, 0);
            EXPECT_NEAR(mass * (heavy * heavy) + light * light, mass, 1e-13 * mass) << mass;
            // The light one does not catch up: an angle below theta = atan(1 / sqrt(M)) is left.
            EXPECT_LE(std::abs(light), -heavy + 1e-9) << mass;
            EXPECT_GE(light, heavy - 1e-9);
        }
    }
}

// Where each blow is handed on to a fourth ball, there is no such way round millions of blows: no
// answer is given for one.
TEST(Scales, MillionsOfBlowsInOneInstantAreRefused) {
    for (const Precision precision : kEveryPrecision) {
        Scene scene;
        scene.balls = {disk("0", {-4, 0}, {1, 0}, 1e6), disk("1", {0, 0}, {}, 1e-6),
                       disk("2", {2, 0}, {}, 1e6), disk("3", {4, 0}, {}, 1e6)};
        scene.limits.time = 3;
        const auto run = played(scene, Way{precision, Simultaneous::symmetric});
        OSCULO_EXPECT_ENDED(run, zeno);
        EXPECT_EQ(run.time, 2);
    }
}

}  // namespace
}  // namespace osculo::support

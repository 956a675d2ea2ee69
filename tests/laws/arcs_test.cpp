#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

// Circular cushions: arenas, cups, posts, and what fits through their openings.
namespace osculo::support {
namespace {

using Scene = TableScene<double>;
using Vec = math::Vec<double>;

Vec at_angle(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

TEST(Arena, ABallGoesRoundForAHundredThousandBounces) {
    // Every chord is as long as the first, every bounce turns by the same angle.
    Random random(1);
    for (int trial = 0; trial < 4; ++trial) {
        Builder<Scene> builder;
        const Vec start(random.uniform<double>(-3, 3), random.uniform<double>(-3, 3));
        const Vec velocity = random.direction<double>();
        builder.circle({0, 0}, 5).ball(start, velocity, 0.5);
        const auto played = play<Scene>(builder.scene, 1e9, 100'000);
        ASSERT_EQ(played.events, 100'000u);
        const engine::RunAudit audit = played.audit();
        EXPECT_TRUE(audit.clean) << describe(audit);
        EXPECT_GT(audit.worst_gap, -2e-14);
        const double moment = math::cross<double>(start, velocity);
        EXPECT_NEAR(math::cross<double>(played.position(0), played.velocity(0)), moment, 1e-10);
        EXPECT_NEAR(math::norm<double>(played.velocity(0)), 1, 1e-12);
        const double chord = 2 * std::sqrt(4.5 * 4.5 - moment * moment);
        const double first = played.record.events[0].when.hi;
        EXPECT_NEAR((played.end.hi - first) / 99'999, chord, 1e-12);
    }
}

TEST(Arena, ABallAlongTheWallKeepsToIt) {
    // Nearly tangential: chords of a hundred-thousandth of the radius.
    for (const double angle : {1e-1, 1e-3, 1e-5}) {
        Builder<Scene> builder;
        builder.circle({0, 0}, 5).ball({4.5, 0}, {std::sin(angle), std::cos(angle)}, 0.5);
        const auto played = play<Scene>(builder.scene, 1e9, 10'000);
        const engine::RunAudit audit = played.audit();
        EXPECT_TRUE(audit.clean) << describe(audit);
        EXPECT_NEAR(played.end.hi, 2 * 4.5 * std::sin(angle) * 9999, 1e-6);
    }
}

TEST(Arena, BallsInsideAndOutsideOfACircleDoNotMeet) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Random random(seed);
        Builder<Scene> builder;
        builder.circle({0, 0}, 3).box(-6, -6, 6, 6);
        for (int k = 0; k < 4; ++k) {
            const double angle = 1.57 * k + random.uniform<double>(0, 0.4);
            builder.ball(1.5 * at_angle(angle), random.direction<double>(), 0.5);
            builder.ball(4.5 * at_angle(angle), random.direction<double>(), 0.5);
        }
        const auto played = play<Scene>(builder.scene, 1e9, 1000);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << "seed " << seed << " " << describe(audit);
        for (std::size_t i = 0; i < 8; ++i) {
            const double distance = math::norm<double>(played.position(i));
            ASSERT_TRUE(i % 2 ? distance > 3.5 - 1e-12 : distance < 2.5 + 1e-12) << seed;
        }
    }
}

TEST(Arc, IsHitFromOutsideOnlyWithinItsAngles) {
    // A quarter circle in the upper right; shots at its centre from all around.
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * 3.141592653589793 / 180;
        Builder<Scene> builder;
        builder.arc({0, 0}, 2, {1, 0}, {0, 1}, false)
            .ball(6 * at_angle(angle), -at_angle(angle), 0.5);
        const auto played = play<Scene>(builder.scene, 100, 10);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << degrees << " " << describe(audit);
        // From outside at 2.5; from the open side through the centre to the inside at 1.5.
        const bool from_outside = degrees <= 90;
        const bool to_the_inside = degrees >= 200 && degrees <= 250;
        ASSERT_TRUE(played.events > 0 || !(from_outside || to_the_inside)) << degrees;
        const double first =
            played.events > 0 ? played.record.events[0].when.hi : math::never<double>();
        if (from_outside) {
            EXPECT_NEAR(first, 3.5, 1e-12) << degrees;
        }
        if (to_the_inside) {
            EXPECT_NEAR(first, 7.5, 1e-12) << degrees;
            EXPECT_NEAR(math::norm<double>(played.velocity(0) - at_angle(angle)), 0, 1e-12);
        }
    }
}

TEST(Arc, ABallGoesIntoACupAndOutAgain) {
    // A half circle that is open to the right; balls shot straight in come straight out after one
    // bounce in the middle, or after two mirrored ones.
    for (const double radius : {0.1, 0.5, 1.0, 1.9}) {
        for (const double height : {0.0, 1e-12, 0.05}) {
            Builder<Scene> builder;
            builder.arc({0, 0}, 2, {0, 1}, {0, -1}, false).ball({9, height}, {-1, 0}, radius);
            const auto played = play<Scene>(builder.scene, 100, 100);
            const engine::RunAudit audit = played.audit();
            ASSERT_TRUE(audit.clean) << radius << " " << describe(audit);
            ASSERT_GE(played.events, 1u);
            EXPECT_GT(played.position(0).x(), 2) << radius << " " << height;
        }
    }
}

TEST(Arc, WhatIsWiderThanTheOpeningStaysOutside) {
    // Ends at +-45 degrees of a circle of radius 2 that is open to the right: 2 sqrt(2) apart.
    const double half = std::sqrt(0.5);
    const auto shoot = [&](double radius) {
        Builder<Scene> builder;
        builder.arc({0, 0}, 2, {half, half}, {half, -half}, true).ball({9, 0}, {-1, 0}, radius);
        return play<Scene>(builder.scene, 12, 100'000);
    };
    const double opening = std::sqrt(2.0);
    // The narrower the fit, the more bounces between the two ends turn the ball round.
    for (const double radius : {opening + 1e-5, opening + 1e-3, 1.9, 5.0}) {
        const auto played = shoot(radius);
        EXPECT_GT(played.velocity(0).x(), 0.5) << radius;
        EXPECT_GT(played.position(0).x(), 2) << radius;
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    }
    for (const double radius : {opening - 1e-9, opening - 1e-3, 1.0}) {
        const auto played = shoot(radius);
        EXPECT_EQ(played.events, 1u) << radius;  // the far side
        EXPECT_NEAR(played.record.events[0].when.hi, 9 + 2 - radius, 1e-12);
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    }
}

TEST(Arc, ManyBallsInAndAroundBrokenCircles) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        Random random(seed);
        Builder<Scene> builder;
        builder.box(-4, -4, 4, 4).restitution(1, seed % 3 == 0 ? 0.9 : 1);
        const double start = random.uniform<double>(0, 6.28);
        const double sweep = random.uniform<double>(0.2, 6.2);
        builder.arc({0, 0}, 2, at_angle(start), at_angle(start + sweep), sweep > 3.14159265358979);
        for (int k = 0; k < 6; ++k) {
            const double angle = k * 1.05;
            builder.ball((k % 2 ? 1.2 : 3.1) * at_angle(angle),
                         random.uniform<double>(0.2, 3) * random.direction<double>(),
                         random.uniform<double>(0.05, 0.5));
        }
        const auto played = play<Scene>(builder.scene, 1e9, 1000);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << "seed " << seed << " " << describe(audit);
    }
}

}  // namespace
}  // namespace osculo::support

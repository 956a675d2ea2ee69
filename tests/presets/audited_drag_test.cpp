#include <cmath>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "support/random.hpp"

// Random breaks and shots with drag, frictionless and of discs that rub: nothing overlaps, nothing
// is made from nothing, and every piece is what its law says.
namespace osculo {
namespace {

ResistedMotion random_drag(support::Random& random) {
    ResistedMotion motion{random.uniform<double>(0.05, 0.5), 0, 0, {}};
    if (random.coin()) motion.linear = random.uniform<double>(0, 1);
    if (random.coin()) motion.quadratic = std::pow(10.0, random.uniform<double>(-3, 1));
    if (random.coin()) motion.medium = Medium{1.2, 1.8e-5, 0.47, random.coin()};
    return motion;
}

/// Balls of various sizes on the 7 ft table, or a rack that is broken.
Scene random_scene(support::Random& random, bool rack) {
    Scene scene;
    presets::add_table(scene, "pool-7ft");
    scene.motion = random_drag(random);
    scene.impacts = {};
    scene.impacts.ball_ball.restitution = random.uniform<double>(0.8, 1);
    scene.impacts.ball_cushion.restitution = random.uniform<double>(0.7, 1);
    scene.limits.time = 60;
    if (rack) {
        scene.balls.push_back({"cue", 0.17, 0.028575, {0.49, 0.4}, {}, {}});
        presets::add_rack(scene, "eight-ball", {.gap = random.coin() ? 0 : 1e-4});
        scene.balls[0].velocity = {random.uniform<double>(-0.2, 0.2), 6};
        for (Ball& ball : scene.balls) ball.spin = {};
        return scene;
    }
    const int count = random.between(2, 8);
    for (int k = 0; k < count;) {
        const double radius = random.uniform<double>(0.015, 0.0286);
        const Point place{random.uniform<double>(0.05, 0.94), random.uniform<double>(0.05, 1.93)};
        bool free = true;
        for (const Ball& other : scene.balls) {
            free = free && std::hypot(other.position.x - place.x, other.position.y - place.y) >
                               other.radius + radius;
        }
        if (!free) continue;
        const double mass = 0.17 * std::pow(radius / 0.0286, random.coin() ? 3 : 2);
        scene.balls.push_back({std::to_string(k++),
                               mass,
                               radius,
                               place,
                               {random.uniform<double>(-3, 3), random.uniform<double>(-3, 3)},
                               {}});
    }
    return scene;
}

void expect_clean(const Scene& scene, int seed, std::uint64_t& events) {
    const Run run = simulate(scene, {.audit = true});
    ASSERT_TRUE(run.audit);
    const Audit& audit = *run.audit;
    EXPECT_TRUE(audit.clean) << "seed " << seed << ", gap " << audit.worst_gap << ", energy "
                             << audit.largest_energy_gain << ", jump " << audit.largest_jump
                             << ", unexplained " << audit.unexplained;
    EXPECT_GE(audit.worst_gap, -1e-12) << "seed " << seed;
    EXPECT_EQ(audit.unexplained, 0U) << "seed " << seed;
    EXPECT_LE(audit.energy_final, audit.energy_initial) << "seed " << seed;
    EXPECT_EQ(run.status, Status::at_rest) << "seed " << seed << ": " << to_string(run.status);
    events += run.event_count;
}

TEST(AuditedDrag, RandomBreaksAreClean) {
    std::uint64_t events = 0;
    for (int seed = 0; seed < 40; ++seed) {
        support::Random random(static_cast<std::uint64_t>(seed) + 500);
        expect_clean(random_scene(random, true), seed, events);
    }
    EXPECT_GT(events, 1'000U);
}

TEST(AuditedDrag, RandomShotsAreClean) {
    std::uint64_t events = 0;
    for (int seed = 0; seed < 200; ++seed) {
        support::Random random(static_cast<std::uint64_t>(seed) + 1000);
        expect_clean(random_scene(random, false), seed, events);
    }
    EXPECT_GT(events, 2'000U);
}

TEST(AuditedDrag, RandomDiscsAreClean) {
    std::uint64_t events = 0;
    for (int seed = 0; seed < 150; ++seed) {
        support::Random random(static_cast<std::uint64_t>(seed) + 2000);
        Scene scene = random_scene(random, seed % 5 == 0);
        if (seed % 3 == 0) scene.motion = RollingMotion{random.uniform<double>(0.01, 0.1)};
        scene.impacts.ball_ball.law = BallBallLaw::frictional;
        scene.impacts.ball_ball.friction = {random.uniform<double>(0, 0.5), 0, 0};
        if (random.coin()) {
            scene.impacts.ball_cushion.law = CushionLaw::frictional;
            scene.impacts.ball_cushion.friction = random.uniform<double>(0, 0.5);
        }
        for (Ball& ball : scene.balls) {
            ball.inertia = random.coin() ? 0.5 : 0.4;
            ball.spin = {0, 0, random.uniform<double>(-100, 100)};
        }
        expect_clean(scene, seed, events);
    }
    EXPECT_GT(events, 2'000U);
}

}  // namespace
}  // namespace osculo

#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

/// Scenes of balls on a cloth, through the public interface.
namespace osculo::support {

constexpr double kPoolRadius = 0.028575;
constexpr double kPoolMass = 0.170097;
constexpr double kDeceleration = 0.01 * 9.81;  // of a rolling ball [m/s^2]

/// Pool balls and cushions, without a table.
[[nodiscard]] inline Scene cloth_scene() {
    Scene scene;
    scene.motion = ClothMotion{0.2, 0.01, 4.0 / 9 * kPoolRadius};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.95, {0.009951, 0.108, 1.088}};
    scene.impacts.ball_cushion.law = CushionLaw::han_2005;
    scene.impacts.ball_cushion.restitution = 0.85;
    scene.impacts.ball_cushion.friction = 0.2;
    scene.impacts.ball_cushion.height = 1.28 * kPoolRadius;
    scene.limits.time = 600;
    return scene;
}

[[nodiscard]] inline Ball pool_ball(std::string id, Point position, Point velocity = {}) {
    Ball ball;
    ball.id = std::move(id);
    ball.mass = kPoolMass;
    ball.radius = kPoolRadius;
    ball.position = position;
    ball.velocity = velocity;
    return ball;
}

/// The same with the spin of a ball that rolls.
[[nodiscard]] inline Ball rolling_ball(std::string id, Point position, Point velocity) {
    Ball ball = pool_ball(std::move(id), position, velocity);
    ball.spin = {-velocity.y / kPoolRadius, velocity.x / kPoolRadius, 0};
    return ball;
}

/// A cushion with the bed to the left of from -> to.
[[nodiscard]] inline Segment rail(std::string id, Point from, Point to) {
    return {std::move(id), from, to, Side::left};
}

[[nodiscard]] inline int count(const Run& run, EventKind kind) {
    int n = 0;
    for (const Event& event : run.events) n += event.kind == kind;
    return n;
}

/// Runs with everything checked: at rest, nothing overlaps by more than 1e-12 radii, nothing gains
/// energy.
[[nodiscard]] inline Run settled(const Scene& scene) {
    return simulate(scene, {.audit = true});
}

}  // namespace osculo::support

/// What every run on a cloth must be. [run]: from settled().
#define OSCULO_EXPECT_SOUND(run)                                           \
    do {                                                                   \
        EXPECT_EQ((run).status, ::osculo::Status::at_rest);                \
        ASSERT_TRUE((run).audit.has_value());                              \
        EXPECT_TRUE((run).audit->clean);                                   \
        EXPECT_GE((run).audit->worst_gap, -1e-12);                         \
        EXPECT_LE((run).audit->energy_final, (run).audit->energy_initial); \
    } while (false)

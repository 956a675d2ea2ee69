#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"

/// Scenes with a hole that pulls, and what holds of them whatever its law.
namespace osculo::test {

inline constexpr double kBallRadius = 0.028575;

/// The hole, at the origin, with a jaw on each side of its mouth; one ball comes with that
/// velocity, another one is on the rim.
inline Scene hole_scene(MotionLaw motion, const Rim& hole, Point velocity) {
    Scene scene;
    scene.motion = std::move(motion);
    scene.rims = {hole, {"far", {1, 0}, 0.06, RimLaw::capture}};
    scene.segments = {{"left", {-0.3, -0.08}, {0.02, -0.08}},
                      {"right", {-0.3, 0.08}, {0.02, 0.08}}};
    scene.arcs = {{"back", {0, 0}, 0.2, -1, 1}};
    scene.balls = {{"a", 0.17, kBallRadius, {-0.25, 0.01}, velocity},
                   {"b", 0.17, kBallRadius, {-hole.radius, 0}, {0, 0}}};
    scene.impacts.ball_ball.restitution = 0.95;
    scene.impacts.ball_cushion.restitution = 0.8;
    scene.limits.time = 20;
    return scene;
}

inline const Event* first_of(const osculo::Run& run, EventKind kind,
                             std::optional<Phase> from = {}) {
    for (const Event& event : run.events) {
        if (event.kind == kind && (!from || event.from == *from)) return &event;
    }
    return nullptr;
}

inline double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The pieces of each ball follow each other without a gap.
inline void expect_continuous(const osculo::Run& run) {
    std::vector<const Piece*> last(run.balls.size(), nullptr);
    for (const Piece& piece : run.pieces) {
        if (const Piece* before = last[piece.ball]) {
            EXPECT_EQ(before->to, piece.from);
            const BallState end = run.along(*before, {before->to - before->from}).front();
            EXPECT_LE(distance(end.position, piece.position), 1e-15);
        }
        last[piece.ball] = &piece;
    }
}

/// The same events whatever the precision, at the same times.
inline void expect_agreement_of_precisions(const Scene& scene) {
    const auto run = simulate(scene);
    for (const Precision precision : {Precision::extended, Precision::quad, Precision::digits50}) {
        const auto wider = simulate(scene, {.precision = precision});
        ASSERT_EQ(wider.events.size(), run.events.size()) << to_string(precision);
        for (std::size_t i = 0; i < run.events.size(); ++i) {
            EXPECT_EQ(wider.events[i].kind, run.events[i].kind);
            EXPECT_NEAR(wider.events[i].time, run.events[i].time, 1e-9);
        }
    }
}

/// What makes a scene one to be refused, and the path of what is wrong then.
struct Spoiling {
    std::string path;
    std::function<void(Scene&)> spoil;
};

/// Of the hole_scene() of any law.
inline std::vector<Spoiling> spoilings(RimLaw law) {
    return {
        {"rims[0].law", [](Scene& s) { s.motion = ClothMotion{}; }},
        {"rims[0].law", [](Scene& s) { s.motion = ResistedMotion{}; }},
        {"rims[0].law", [](Scene& s) { s.impacts.ball_ball.law = BallBallLaw::frictional; }},
        {"gravity", [](Scene& s) { s.gravity = 0; }},
        {"balls[0].radius", [](Scene& s) { s.rims[0].radius = s.balls[1].radius; }},
        {"rims[1].center",
         [law](Scene& s) {
             s.rims[1] = {"near", {0.1, 0}, 0.06, law};
         }},
        {"balls[1].position",
         [](Scene& s) {
             s.balls[1].position = {-0.02, 0};
         }},
    };
}

inline void expect_refusals(const Scene& good, const std::vector<Spoiling>& all) {
    EXPECT_NO_THROW(validate(good));
    for (const Spoiling& one : all) {
        Scene scene = good;
        one.spoil(scene);
        try {
            validate(scene);
            ADD_FAILURE() << "accepted: " << one.path;
        } catch (const SceneError& error) {
            EXPECT_EQ(error.path(), one.path) << error.what();
        }
    }
}

}  // namespace osculo::test

#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/batches.hpp"

/// Runs to be stopped, kept and played on.
namespace osculo::test {

/// A hole that pulls, with a jaw on each side of its mouth, and balls that meet in it and beside
/// it.
inline Scene pulling_scene(MotionLaw motion, RimLaw law = RimLaw::paper) {
    constexpr double kRadius = 0.028575;
    Scene scene;
    scene.motion = motion;
    scene.rims = {{"hole", {0, 0}, 0.06, law}, {"far", {1, 0}, 0.06, RimLaw::capture}};
    scene.segments = {{"left", {-0.3, -0.08}, {0.02, -0.08}},
                      {"right", {-0.3, 0.08}, {0.02, 0.08}}};
    scene.arcs = {{"back", {0, 0}, 0.2, -1, 1}};
    scene.balls = {ball("a", {-0.25, 0.01}, {0.7, 0.02}, kRadius),
                   ball("b", {-0.06, 0}, {0, 0}, kRadius), ball("c", {-0.5, 0.04}, {1, 0}, kRadius),
                   ball("d", {-0.8, 0}, {0.9, 0.01}, kRadius)};
    scene.impacts.ball_ball.restitution = 0.95;
    scene.impacts.ball_cushion.restitution = 0.8;
    scene.limits.time = 1;
    return scene;
}

/// Scenes of every motion law, cushion law, simultaneous law and kind of engine.
inline std::vector<std::pair<Scene, Precision>> simulations() {
    constexpr std::array kWide{Precision::extended, Precision::quad, Precision::digits50,
                               Precision::digits100};
    std::vector<std::pair<Scene, Precision>> all;
    Scene pool = pool_scene(7);
    pool.cue = Cue{.speed = 4, .azimuth = 1.55, .elevation = 0.2};
    pool.limits = {60, 10000};
    for (const CushionLaw law : {CushionLaw::restitution, CushionLaw::han_2005,
                                 CushionLaw::mathavan_2010, CushionLaw::stronge}) {
        pool.impacts.ball_cushion.law = law;
        all.emplace_back(pool, Precision::double_precision);
    }
    pool.impacts.ball_cushion.law = CushionLaw::han_2005;
    for (const Precision precision : kWide) all.emplace_back(pool, precision);
    pool.cue.reset();
    pool.impacts.ball_ball = {BallBallLaw::restitution, 0.98, {}};
    pool.impacts.ball_cushion = {CushionLaw::restitution, 0.95};
    pool.balls[0].velocity = {0.4, 3};
    pool.motion = RollingMotion{0.02};
    all.emplace_back(pool, Precision::double_precision);
    pool.impacts.simultaneous = Simultaneous::sequential;
    all.emplace_back(pool, Precision::double_precision);
    pool.impacts.simultaneous = Simultaneous::symmetric;
    pool.motion = ResistedMotion{0.1, 0.05, 0.1, {}};
    all.emplace_back(pool, Precision::double_precision);
    all.emplace_back(pool, Precision::extended);
    all.emplace_back(pool, Precision::digits50);
    pool.impacts.ball_ball = {BallBallLaw::frictional, 0.9, {0.1, 0, 0}};
    pool.balls[0].spin = {0, 0, 30};
    all.emplace_back(pool, Precision::double_precision);  // discs
    pool.impacts.ball_ball = {BallBallLaw::restitution, 0.98, {}};
    pool.motion = UniformMotion{};
    pool.limits = {8, 10000};
    all.emplace_back(pool, Precision::double_precision);  // all pairs
    for (const Precision precision : kWide) all.emplace_back(pool, precision);
    all.emplace_back(pulling_scene(UniformMotion{}), Precision::double_precision);
    all.emplace_back(pulling_scene(RollingMotion{0.01}), Precision::double_precision);
    all.emplace_back(pulling_scene(RollingMotion{0.01}), Precision::quad);
    for (const Precision precision : {Precision::double_precision, Precision::quad}) {
        all.emplace_back(pulling_scene(RollingMotion{0.01}, RimLaw::tipping), precision);
    }
    Scene gas;
    add_box(gas, 8, 8);
    for (int i = 0; i < 25; ++i) {
        gas.balls.push_back(ball("g" + std::to_string(i), {1 + 1.5 * (i % 5), 1 + 1.5 * (i / 5)},
                                 {std::sin(i), std::cos(3 * i)}, 0.3));
    }
    gas.limits = {20, 300};
    all.emplace_back(gas, Precision::double_precision);  // a cell grid
    gas.rims = {{"hole", {4.75, 4.75}, 0.5}};
    gas.impacts.simultaneous = Simultaneous::sequential;
    all.emplace_back(gas, Precision::double_precision);  // which balls leave
    return all;
}

inline void expect_same(const osculo::Run& a, const osculo::Run& b) {
    EXPECT_EQ(a.scene, b.scene);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.event_count, b.event_count);
    EXPECT_EQ(a.settled_count, b.settled_count);
    EXPECT_EQ(a.engine, b.engine);
    EXPECT_EQ(a.points, b.points);
    EXPECT_TRUE(a.events == b.events);
    EXPECT_TRUE(a.pieces == b.pieces);
    EXPECT_TRUE(a.balls == b.balls);
    EXPECT_TRUE(a.audit == b.audit);
}

}  // namespace osculo::test

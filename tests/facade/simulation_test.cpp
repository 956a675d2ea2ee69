#include "osculo/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/batches.hpp"

namespace osculo {
namespace {

/// Scenes of every motion law, cushion law and kind of engine.
std::vector<std::pair<Scene, Precision>> scenes() {
    std::vector<std::pair<Scene, Precision>> all;
    Scene pool = test::pool_scene(7);
    pool.cue = Cue{.speed = 4, .azimuth = 1.55, .elevation = 0.2};
    pool.limits = {60, 10000};
    for (const CushionLaw law : {CushionLaw::restitution, CushionLaw::han_2005,
                                 CushionLaw::mathavan_2010, CushionLaw::stronge}) {
        pool.impacts.ball_cushion.law = law;
        all.emplace_back(pool, Precision::double_precision);
    }
    pool.impacts.ball_cushion.law = CushionLaw::han_2005;
    for (const Precision precision :
         {Precision::extended, Precision::quad, Precision::digits50, Precision::digits100}) {
        all.emplace_back(pool, precision);
    }
    pool.cue.reset();
    pool.impacts.ball_ball = {BallBallLaw::restitution, 0.98, {}};
    pool.impacts.ball_cushion = {CushionLaw::restitution, 0.95};
    pool.balls[0].velocity = {0.4, 3};
    pool.motion = RollingMotion{0.02};
    all.emplace_back(pool, Precision::double_precision);
    pool.motion = UniformMotion{};
    pool.limits = {8, 10000};
    all.emplace_back(pool, Precision::double_precision);  // all pairs
    Scene gas;
    test::add_box(gas, 8, 8);
    for (int i = 0; i < 25; ++i) {
        gas.balls.push_back(test::ball("g" + std::to_string(i),
                                       {1 + 1.5 * (i % 5), 1 + 1.5 * (i / 5)},
                                       {std::sin(i), std::cos(3 * i)}, 0.3));
    }
    gas.limits = {20, 300};
    all.emplace_back(gas, Precision::double_precision);  // a cell grid
    return all;
}

void expect_same(const osculo::Run& a, const osculo::Run& b) {
    EXPECT_EQ(a.scene, b.scene);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.event_count, b.event_count);
    EXPECT_EQ(a.engine, b.engine);
    EXPECT_EQ(a.points, b.points);
    EXPECT_TRUE(a.events == b.events);
    EXPECT_TRUE(a.pieces == b.pieces);
    EXPECT_TRUE(a.balls == b.balls);
    EXPECT_TRUE(a.audit == b.audit);
}

TEST(Simulation, InPartsIsTheRunInOne) {
    for (const auto& [scene, precision] : scenes()) {
        const Options options{.precision = precision};
        SCOPED_TRACE(choose_engine(scene, options).name);
        const osculo::Run whole = simulate(scene, options);
        ASSERT_GT(whole.event_count, 10U);
        Simulation simulation(scene, options);
        std::vector<Simulation> copies;
        for (int part = 1; part < 8; ++part) {
            Limits limits = scene.limits;
            if (part % 2 == 0) {
                limits.events = whole.event_count * static_cast<std::uint64_t>(part) / 8;
            } else {
                limits.time = whole.time * part / 8;
            }
            const Status status = simulation.play(limits);
            EXPECT_EQ(status, part % 2 == 0 ? Status::event_limit : Status::time_limit);
            EXPECT_EQ(simulation.status(), status);
            copies.push_back(simulation);
        }
        EXPECT_EQ(simulation.play(), whole.status);
        expect_same(simulation.result(), whole);
        // Where it was left, each by itself.
        for (Simulation& copy : copies) {
            copy.play();
            expect_same(copy.result(), whole);
            EXPECT_EQ(copy.event_count(), whole.event_count);
        }
        copies[0] = copies[1];
        expect_same(copies[0].result(), whole);
    }
}

TEST(Simulation, StoppedIsARunWithThatLimit) {
    for (const auto& [scene, precision] : scenes()) {
        if (precision != Precision::double_precision) continue;
        const Options options{.precision = precision, .audit = true};
        SCOPED_TRACE(choose_engine(scene, options).name);
        const osculo::Run whole = simulate(scene, options);
        Simulation simulation(scene, options);
        EXPECT_TRUE(simulation.result().events.empty());
        int stops = 0;
        for (const Limits& limits :
             {Limits{whole.time * 0.1, 10000}, Limits{whole.time * 0.2, 10000},
              Limits{60, whole.event_count * 3 / 4}, Limits{60, whole.event_count - 1}}) {
            if (simulation.event_count() > limits.events) continue;  // it is there already
            ++stops;
            Scene limited = scene;
            limited.limits.time = std::min(limits.time, scene.limits.time);
            limited.limits.events = std::min(limits.events, scene.limits.events);
            simulation.play(limits);
            const osculo::Run stopped = simulation.result();
            expect_same(stopped, simulate(limited, options));
            EXPECT_TRUE(stopped.audit->clean);
            expect_same(simulation.result(), stopped);  // which disturbs nothing
        }
        EXPECT_GE(stops, 3);
        // Back, or nowhere: nothing happens.
        const std::uint64_t events = simulation.event_count();
        simulation.play({whole.time * 0.1, 10000});
        simulation.play({60, 1});
        simulation.play({0, 0});
        EXPECT_EQ(simulation.event_count(), events);
        simulation.play();
        expect_same(simulation.result(), whole);
        EXPECT_EQ(simulation.play({1e9, 1000000}), whole.status);  // not beyond the scene's limits
        expect_same(simulation.result(), whole);
    }
}

TEST(Simulation, OfABadSceneIsRefused) {
    Scene scene = test::pool_scene(2);
    scene.balls[1].mass = -1;
    EXPECT_THROW(Simulation{scene}, SceneError);
}

// A ball that loses nine tenths of its normal speed at each bounce along the inside of a circle.
TEST(Simulation, CountsEventsAtOneInstantAcrossStops) {
    Scene scene;
    scene.arcs = {{"circle", {0, 0}, 10}};
    scene.balls = {test::ball("a", {5, 0}, {0.3, 1}, 1)};
    scene.impacts.ball_cushion.restitution = 0.1;
    scene.limits.time = 1000;
    const osculo::Run whole = simulate(scene);
    EXPECT_EQ(whole.status, Status::zeno);
    Simulation simulation(scene);
    for (std::uint64_t events = 1; simulation.play({1000, events}) == Status::event_limit;)
        ++events;
    osculo::Run result = simulation.result();
    result.scene.limits = scene.limits;
    expect_same(result, whole);
}

}  // namespace
}  // namespace osculo

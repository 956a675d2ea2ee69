#include "osculo/simulation.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/batches.hpp"
#include "support/simulations.hpp"

namespace osculo {
namespace {

using test::expect_same;
using test::simulations;

TEST(Simulation, InPartsIsTheRunInOne) {
    for (const auto& [scene, precision] : simulations()) {
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
    for (const auto& [scene, precision] : simulations()) {
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
        if (whole.status != Status::time_limit) continue;
        Scene longer = scene;
        longer.limits.time *= 1.5;
        simulation.set_limits(longer.limits);
        simulation.play();
        expect_same(simulation.result(), simulate(longer, options));
    }
}

TEST(Simulation, OfABadSceneIsRefused) {
    Scene scene = test::pool_scene(2);
    Simulation simulation(scene);
    EXPECT_THROW(simulation.set_limits({-1, 10}), SceneError);
    EXPECT_EQ(simulation.limits(), scene.limits);
    EXPECT_EQ(simulation.scene(), scene);
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

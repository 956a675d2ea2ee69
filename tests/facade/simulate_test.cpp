#include "osculo/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace osculo {
namespace {

/// Balls on a lattice with random velocities in a box with a post and a hole.
Scene random_scene(unsigned seed, int columns = 4) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Scene scene;
    test::add_box(scene, columns + 1.0, columns + 1.0);
    for (int i = 0; i < columns * columns; ++i) {
        const Point place{1.0 + i % columns + 0.2 * uniform(), 1.0 + i / columns + 0.2 * uniform()};
        scene.balls.push_back(test::ball(std::string("ball-").append(std::to_string(i)), place,
                                         {uniform() - 0.5, uniform() - 0.5},
                                         0.2 + 0.1 * uniform()));
        scene.balls.back().mass = 0.5 + uniform();
    }
    scene.limits.time = 15;
    return scene;
}

Scene table_scene(unsigned seed) {
    Scene scene = random_scene(seed);
    scene.arcs = {{"post", {2.6, 2.6}, 0.05}, {"nose", {5, 2.5}, 0.3, 1.6, 4.6}};
    scene.rims = {{"hole", {0, 0}, 0.4}};
    return scene;
}

void expect_same(const Run& a, const Run& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.event_count, b.event_count);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.balls, b.balls);
}

TEST(Simulate, IsAuditedCleanOnRandomTables) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const auto run = simulate(table_scene(seed), {.audit = true});
        ASSERT_TRUE(run.audit);
        EXPECT_TRUE(run.audit->clean) << "seed " << seed << ", gap " << run.audit->worst_gap;
        EXPECT_GT(run.events.size(), 30U);
        EXPECT_GT(run.audit->worst_gap, -1e-13);
        EXPECT_LT(run.audit->worst_gap, 1e-13);  // something touched
        EXPECT_EQ(run.audit->worst_gap_ids.size(), 2U);
    }
}

TEST(Simulate, RecordsWhatIsAskedFor) {
    const Scene scene = random_scene(1);
    const auto none = simulate(scene, {.record = Record::none});
    const auto events = simulate(scene, {.record = Record::events});
    const auto pieces = simulate(scene, {.record = Record::pieces});
    const auto audited = simulate(scene, {.record = Record::none, .audit = true});
    EXPECT_TRUE(none.events.empty() && none.pieces.empty());
    EXPECT_TRUE(!events.events.empty() && events.pieces.empty());
    EXPECT_FALSE(pieces.pieces.empty());
    EXPECT_TRUE(audited.events.empty() && audited.pieces.empty() && audited.audit);
    EXPECT_EQ(events.events, pieces.events);
    EXPECT_EQ(events.events.size(), events.event_count);
    expect_same(none, events);
    expect_same(none, pieces);
    expect_same(none, audited);
}

// Narrow and wide engines, bit for bit: an obstacle far away asks for the wider one.
TEST(Simulate, NarrowAndWideEnginesAgree) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        Scene scene = random_scene(seed, 3);
        scene.impacts.simultaneous = Simultaneous::sequential;
        const auto walls = simulate(scene);
        EXPECT_EQ(walls.engine.name,
                  "uniform/restitution/sequential/segments+points/double/pieces/all-pairs");
        scene.rims.push_back({"far", {1000, 1000}, 1});
        const auto table = simulate(scene);
        EXPECT_EQ(table.engine.name,
                  "uniform/restitution/sequential/rims+segments+arcs+points/double/pieces/"
                  "all-pairs");
        expect_same(walls, table);
        EXPECT_EQ(walls.events, table.events);
        // Where nothing meets two things at once, neither does the law for that change a bit.
        scene.impacts.simultaneous = Simultaneous::symmetric;
        const auto symmetric = simulate(scene);
        EXPECT_EQ(symmetric.engine.name,
                  "uniform/restitution/symmetric/rims+segments+arcs+points/double/pieces/"
                  "all-pairs");
        expect_same(symmetric, table);
        EXPECT_EQ(symmetric.events, table.events);
        // Balls that never move switch to the grid.
        for (int i = 0; i < 64; ++i) {
            scene.balls.push_back(
                test::ball(std::string("idle-").append(std::to_string(i)), {-100.0 - 2 * i, -100}));
        }
        const auto grid = simulate(scene);
        EXPECT_EQ(grid.engine.name,
                  "uniform/restitution/symmetric/rims+segments+arcs+points/double/pieces/"
                  "cell-grid");
        EXPECT_EQ(grid.events, table.events);
    }
}

TEST(Simulate, OpenSceneLeavesOutObstacles) {
    Scene scene;
    scene.balls = {test::ball("a", {0, 0}, {1, 0}), test::ball("b", {3, 0})};
    scene.impacts.simultaneous = Simultaneous::sequential;
    const EngineInfo info = choose_engine(scene);
    EXPECT_EQ(info.name, "uniform/restitution/sequential/open/double/pieces/all-pairs");
    EXPECT_GE(info.left_out.size(), 4U);
}

// Scenes resolve what touches together unless they say otherwise.
TEST(Simulate, SymmetricImpactsAreTheDefault) {
    Scene scene;
    scene.balls = {test::ball("cue", {-3, 0}, {1, 0}), test::ball("up", {0, 1}),
                   test::ball("down", {0, -1})};
    for (Ball& ball : scene.balls) ball.radius = 1;
    scene.limits.time = 3;
    const auto run = simulate(scene, {.audit = true});
    EXPECT_TRUE(run.audit->clean);
    EXPECT_NEAR(run.balls[0].state.velocity.x, -0.2, 1e-14);  // NUMERICS 4.2, T5
    EXPECT_NEAR(run.balls[0].state.velocity.y, 0, 1e-14);
    EXPECT_NEAR(run.balls[1].state.velocity.y, std::sqrt(3) / 5, 1e-14);
    ASSERT_EQ(run.events.size(), 2U);
    for (const Event& event : run.events) {
        EXPECT_EQ(event.cluster, 1U);
        EXPECT_FALSE(event.well_posed);
    }
    for (const Precision precision :
         {Precision::extended, Precision::quad, Precision::digits50, Precision::digits100}) {
        const auto wider = simulate(scene, {.precision = precision});
        EXPECT_NEAR(wider.balls[0].state.velocity.x, -0.2, 1e-15);
    }
    scene.impacts.simultaneous = Simultaneous::sequential;
    const auto sequential = simulate(scene);
    EXPECT_NEAR(sequential.balls[0].state.velocity.x, -0.125, 1e-14);
    EXPECT_EQ(sequential.events.front().cluster, 0U);
}

TEST(Simulate, WhatIsSlowerThanTheRestSpeedDoesNotBounce) {
    Scene scene;
    for (int k = 0; k < 15; ++k) {
        scene.balls.push_back(test::ball(std::string("b").append(std::to_string(k + 10)),
                                         {2.001 * k, 0}, {k == 0 ? 1.0 : 0.0, 0}));
        scene.balls.back().radius = 1;
    }
    scene.impacts.ball_ball.restitution = 0.5;
    const auto run = simulate(scene, {.audit = true});
    EXPECT_TRUE(run.audit->clean);
    EXPECT_GT(run.settled_count, 10U);
    EXPECT_LT(run.settled_count, run.event_count);
    EXPECT_LT(run.event_count, 4000U);
    // The same as what is derived from the fastest ball.
    scene.impacts.rest_speed = Impacts::kRestShare;
    EXPECT_EQ(simulate(scene).events, run.events);
    scene.impacts.rest_speed = 0;
    const auto bouncing = simulate(scene);
    EXPECT_EQ(bouncing.settled_count, 0U);
    EXPECT_GT(bouncing.event_count, run.event_count);
}

// Reversing the order in which a file lists things changes nothing but the order.
TEST(Simulate, OrderOfTheSceneDoesNotMatter) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        Scene scene = table_scene(seed);
        for (Ball& ball : scene.balls) {  // ties: a symmetric start
            ball.position = {std::round(ball.position.x), std::round(ball.position.y)};
            ball.velocity = {ball.velocity.x > 0 ? 0.5 : -0.5, ball.velocity.y > 0 ? 0.5 : -0.5};
            ball.radius = 0.25;
            ball.mass = 1;
        }
        scene.limits.time = 6;
        Scene reversed = scene;
        std::reverse(reversed.balls.begin(), reversed.balls.end());
        std::reverse(reversed.segments.begin(), reversed.segments.end());
        std::reverse(reversed.arcs.begin(), reversed.arcs.end());
        const auto run = simulate(scene);
        auto other = simulate(reversed);
        std::reverse(other.balls.begin(), other.balls.end());
        expect_same(run, other);
        ASSERT_EQ(run.events.size(), other.events.size());
        for (std::size_t k = 0; k < run.events.size(); ++k) {
            EXPECT_EQ(run.ids(run.events[k]), other.ids(other.events[k]));
            EXPECT_EQ(run.events[k].time, other.events[k].time);
        }
    }
}

TEST(Simulate, RefusesAPrecisionInWhichACushionHasNoEngine) {
    Scene scene = random_scene(1);
    scene.motion = ClothMotion{};
    const Options options{.precision = Precision::quad};
    EXPECT_NO_THROW(static_cast<void>(choose_engine(scene, options)));
    scene.impacts.ball_cushion = {CushionLaw::stronge, 0.85, 0.2, 0.3};
    EXPECT_NO_THROW(static_cast<void>(choose_engine(scene)));
    EXPECT_THROW(static_cast<void>(choose_engine(scene, options)), SceneError);
    EXPECT_THROW(static_cast<void>(simulate(scene, options)), SceneError);
}

// Each precision agrees with 100 digits to what its own digits allow on a short run.
TEST(Simulate, PrecisionsConverge) {
    Scene scene = table_scene(7);
    scene.limits.events = 30;
    scene.limits.time = 1000;
    const auto truth = simulate(scene, {.precision = Precision::digits100});
    for (const Precision precision :
         {Precision::double_precision, Precision::extended, Precision::quad, Precision::digits50}) {
        const auto run = simulate(scene, {.precision = precision});
        ASSERT_EQ(run.events.size(), truth.events.size()) << to_string(precision);
        for (std::size_t k = 0; k < run.events.size(); ++k) {
            EXPECT_EQ(run.ids(run.events[k]), truth.ids(truth.events[k]));
        }
        const double tolerance = precision == Precision::double_precision ? 1e-9 : 1e-14;
        EXPECT_NEAR(run.time, truth.time, tolerance) << to_string(precision);
        for (std::size_t i = 0; i < run.balls.size(); ++i) {
            EXPECT_NEAR(run.balls[i].state.position.x, truth.balls[i].state.position.x, tolerance);
            EXPECT_NEAR(run.balls[i].state.position.y, truth.balls[i].state.position.y, tolerance);
        }
    }
}

TEST(Simulate, EmptyAndRestingScenesEndAtOnce) {
    auto run = simulate(Scene{});
    EXPECT_EQ(run.status, Status::at_rest);
    EXPECT_EQ(run.time, 0);
    Scene scene;
    scene.balls = {test::ball("a", {0, 0}), test::ball("b", {1, 0})};  // touching
    run = simulate(scene, {.audit = true});
    EXPECT_EQ(run.status, Status::at_rest);
    EXPECT_EQ(run.event_count, 0U);
    EXPECT_TRUE(run.audit->clean);
    EXPECT_EQ(run.balls[0].fate, BallFate::rest);
}

TEST(Simulate, LimitsEndTheRun) {
    Scene scene = random_scene(3);
    scene.limits.events = 10;
    auto run = simulate(scene);
    EXPECT_EQ(run.status, Status::event_limit);
    EXPECT_EQ(run.event_count, 10U);
    EXPECT_EQ(run.time, run.events.back().time);
    scene.limits = {2.5, 1000000};
    run = simulate(scene);
    EXPECT_EQ(run.status, Status::time_limit);
    EXPECT_EQ(run.time, 2.5);
}

TEST(Simulate, RefusesABrokenScene) {
    Scene scene = random_scene(3);
    scene.balls[2].mass = -1;
    EXPECT_THROW((void)simulate(scene), SceneError);
}

TEST(Precision, NamesRoundTrip) {
    for (const char* name : {"double", "extended", "quad", "50", "100"}) {
        ASSERT_TRUE(precision_from_string(name));
        EXPECT_EQ(to_string(*precision_from_string(name)), name);
    }
    EXPECT_FALSE(precision_from_string("single"));
}

// Found by a fuzzer: a cluster of two contacts went over the limit, and nothing ended the run.
TEST(Simulate, AClusterAtTheLimitOfEventsEndsTheRun) {
    // The middle ball is hit from both sides at one instant, then the outer ones come back.
    Scene scene;
    test::add_box(scene, 10, 4);
    scene.balls = {test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 2}),
                   test::ball("c", {8, 2}, {-1, 0})};
    scene.limits.time = 1000;
    scene.limits.events = 1;
    const auto run = simulate(scene);
    EXPECT_EQ(run.status, Status::event_limit);
    EXPECT_EQ(run.event_count, 2U);
    EXPECT_EQ(run.events[0].cluster, run.events[1].cluster);
    EXPECT_NE(run.events[0].cluster, 0U);
}

}  // namespace
}  // namespace osculo

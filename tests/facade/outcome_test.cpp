#include "osculo/outcome.hpp"

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

/// Balls on the middle line of a box of 10 m x 4 m without friction.
Scene line(std::vector<Ball> balls) {
    Scene scene;
    test::add_box(scene, 10, 4);
    scene.balls = std::move(balls);
    scene.limits.time = 30;
    return scene;
}

Outcome play(const Scene& scene) {
    return outcome_of(simulate(scene)).value();
}

using Hits = std::vector<Outcome::Hit>;
using Falls = std::vector<Outcome::Fall>;

// a stops at b, which goes to the wall 4.5 m away, comes back and meets a again: a kiss; a goes to
// the other wall.
TEST(Outcome, OfADoubleKiss) {
    Scene scene = line({test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 2})});
    scene.limits.time = 14;  // hit at 2, wall at 6.5, kiss at 11, wall at 14.5 (3.5 m away)
    Outcome outcome = play(scene);
    EXPECT_EQ(outcome.cue_ball, 0U);
    EXPECT_EQ(outcome.hits, (Hits{{1, 2, 0}}));
    EXPECT_EQ(outcome.kisses, 1U);
    EXPECT_EQ(outcome.driven_to_cushion, 1U);
    EXPECT_EQ(outcome.cushions_before_hit, 0U);
    EXPECT_EQ(outcome.cushions_after_hit, 0U);
    EXPECT_EQ(outcome.balls[0], (Outcome::Tally{2, 0, {1, 2}}));
    EXPECT_EQ(outcome.balls[1], (Outcome::Tally{2, 1, {5, 2}}));
    EXPECT_EQ(outcome.rest_time, std::nullopt);
    EXPECT_TRUE(outcome.falls.empty());

    scene.limits.time = 14.6;
    EXPECT_EQ(play(scene).cushions_after_hit, 1U);
}

TEST(Outcome, CountsTheCushionsBeforeEachHit) {
    // b is hit off the left wall at 1.5 + 4, c by b: a kiss of two object balls.
    Scene scene = line(
        {test::ball("a", {2, 2}, {-1, 0}), test::ball("b", {5.5, 2}), test::ball("c", {8, 2})});
    scene.limits.time = 8;
    const Outcome outcome = play(scene);
    EXPECT_EQ(outcome.hits, (Hits{{1, 5.5, 1}}));
    EXPECT_EQ(outcome.cushions_before_hit, 1U);
    EXPECT_EQ(outcome.cushions_after_hit, 0U);
    EXPECT_EQ(outcome.kisses, 1U);
    EXPECT_EQ(outcome.balls[1].balls, 2U);
    EXPECT_EQ(outcome.driven_to_cushion, 0U);
}

TEST(Outcome, KnowsWhatFellWhere) {
    Scene scene = line({test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 2})});
    scene.rims = {{"other", {1, 1}, 0.25}, {"hole", {9, 2}, 0.5}};
    const Outcome outcome = play(scene);
    EXPECT_EQ(outcome.falls, (Falls{{1, 1, 5.5}}));
    EXPECT_EQ(outcome.balls[1].position, (Point{8.5, 2}));
    EXPECT_EQ(outcome.rest_time, 5.5);  // a has stopped, b is gone
}

TEST(Outcome, NeedsOneBallThatBegins) {
    Scene scene = line({test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 2}, {-1, 0})});
    scene.limits.time = 1.5;
    const Outcome outcome = play(scene);
    EXPECT_EQ(outcome.cue_ball, std::nullopt);
    EXPECT_TRUE(outcome.hits.empty());
    EXPECT_EQ(outcome.kisses, 1U);
    scene.balls[0].velocity = scene.balls[1].velocity = {};
    EXPECT_EQ(play(scene).cue_ball, std::nullopt);
}

TEST(Outcome, ACueSaysWhichBallBegins) {
    Scene scene = line({test::ball("a", {2, 2}), test::ball("b", {5, 2})});
    scene.motion = ClothMotion{0.2, 0.01, 0.01};
    scene.cue = Cue{.ball = "b", .speed = 2, .azimuth = 3.141592653589793};
    scene.limits.time = 100;
    const osculo::Run run = simulate(scene);
    const Outcome outcome = outcome_of(run).value();
    EXPECT_EQ(outcome.cue_ball, 1U);
    ASSERT_FALSE(outcome.hits.empty());
    EXPECT_EQ(outcome.hits[0].ball, 0U);
    EXPECT_EQ(outcome.hits[0].cushions, 0U);
    EXPECT_EQ(run.status, Status::at_rest);
    EXPECT_EQ(outcome.rest_time, run.events.back().time);
}

// A ball pressed into a cushion by its follow meets it again and again: one contact.
TEST(Outcome, CountsContactsThatLastAsOne) {
    osculo::Run run;
    run.scene = line({test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 2})});
    run.balls.resize(2);
    const auto add = [&](double time, EventKind kind, std::uint32_t ball, std::uint32_t other) {
        Event event;
        event.time = time;
        event.kind = kind;
        event.ball = ball;
        event.other = other;
        run.events.push_back(event);
        ++run.event_count;
    };
    add(1, EventKind::ball_ball, 0, 1);
    add(1.005, EventKind::ball_ball, 1, 0);  // the same two, whichever comes first
    add(1.014, EventKind::ball_ball, 0, 1);  // within a hundredth of the last, not of the first
    add(1.1, EventKind::ball_ball, 0, 1);    // again: a kiss
    add(2, EventKind::ball_segment, 0, 3);
    add(2.0001, EventKind::ball_segment, 0, 3);
    add(2.0001, EventKind::ball_segment, 1, 3);
    add(2.0002, EventKind::ball_segment, 0, 2);  // another cushion
    add(2.0003, EventKind::ball_point, 0, 2);    // an end point counts for itself
    add(2.5, EventKind::ball_segment, 0, 3);
    const Outcome outcome = outcome_of(run).value();
    EXPECT_EQ(outcome.hits.size(), 1U);
    EXPECT_EQ(outcome.kisses, 1U);
    EXPECT_EQ(outcome.cushions_after_hit, 4U);
    EXPECT_EQ(outcome.driven_to_cushion, 1U);
    EXPECT_EQ(outcome.balls[0].balls, 2U);
    EXPECT_EQ(outcome.balls[0].cushions, 4U);
}

TEST(Outcome, NeedsRecordedEvents) {
    const Scene scene = line({test::ball("a", {2, 2}, {1, 0})});
    EXPECT_FALSE(outcome_of(simulate(scene, {.record = Record::none})).has_value());
    EXPECT_TRUE(outcome_of(simulate(scene, {.record = Record::events})).has_value());
    const Scene still = line({test::ball("a", {2, 2})});
    EXPECT_TRUE(outcome_of(simulate(still, {.record = Record::none})).has_value());
}

}  // namespace
}  // namespace osculo

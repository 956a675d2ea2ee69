#include <cmath>

#include <gtest/gtest.h>

#include "support/extreme_scenes.hpp"

// Instants that coincide, nearly coincide, or fall on the end of a ball's piece.
namespace osculo::support {
namespace {

const double kRoot3 = std::sqrt(3.0);

/// One ball meets two that touch, [later] of which is so much farther away. The instants, 2.02 s,
/// and the places have ulps of 2^-51.
Scene on_two(std::size_t later, double by, const std::string& first_id = "1",
             const std::string& second_id = "2") {
    Scene scene;
    scene.balls = {disk("0", {-3.75, 0}, {1, 0}), disk(first_id, {0, 1}), disk(second_id, {0, -1})};
    scene.balls[later].position.x = by;
    scene.limits.time = 10;
    return scene;
}

/// Ball [first] gets the most: (3/4, +-sqrt(3)/4); the other (3/8, -+sqrt(3)/8) (NUMERICS T5).
void expect_met_first(const Run& run, std::size_t first, double digits) {
    OSCULO_EXPECT_ENDED(run, time_limit);
    ASSERT_EQ(run.event_count, 2U);
    EXPECT_EQ(run.events[0].other, first);
    const double side = first == 1 ? 1 : -1;
    const Point expected[] = {{-0.125, -side * kRoot3 / 8},
                              {first == 1 ? 0.75 : 0.375, kRoot3 / (first == 1 ? 4 : 8)},
                              {first == 1 ? 0.375 : 0.75, -kRoot3 / (first == 1 ? 8 : 4)}};
    for (std::size_t k = 0; k < 3; ++k) {
        const Point v = run.balls[k].state.velocity;
        EXPECT_NEAR(v.x, expected[k].x, digits) << k;
        EXPECT_NEAR(v.y, expected[k].y, digits) << k;
    }
}

TEST(Instants, AnUlpApartInBothOrders) {
    for (const Precision precision : kEveryPrecision) {
        SCOPED_TRACE(to_string(precision));
        for (const int exponent : {-51, -40, -20}) {
            const double by = std::ldexp(1.0, exponent);
            expect_met_first(played(on_two(2, by), precision), 1, 1e-15 + 2 * by);
            expect_met_first(played(on_two(1, by), precision), 2, 1e-15 + 2 * by);
        }
    }
}

// What double cannot tell apart is one instant for it, and then the ids decide, whatever the order
// of the list; more digits still see it.
TEST(Instants, CloserThanTheResolutionTheIdsDecide) {
    const double by = 0x1p-70;
    for (const std::size_t later : {std::size_t{1}, std::size_t{2}}) {
        expect_met_first(played(on_two(later, by)), 1, 1e-15);
        expect_met_first(played(on_two(later, by, "2", "1")), 2, 1e-15);
        for (const Precision precision : {Precision::quad, Precision::digits50}) {
            const std::size_t first = later == 1 ? 2 : 1;
            expect_met_first(played(on_two(later, by), precision), first, 1e-15);
        }
    }
}

// By the default law what an ulp parts is one instant, with the outcome of the symmetric scene:
// -1/5 and 2 sqrt(3) / 5 at 30 degrees (NUMERICS T5). What a thousand ulp part is not.
TEST(Instants, AnUlpApartIsOneInstantByTheDefaultLaw) {
    for (const std::size_t later : {std::size_t{1}, std::size_t{2}}) {
        const Way way{Precision::double_precision, Simultaneous::symmetric};
        const auto run = played(on_two(later, 0x1p-51), way);
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.event_count, 2U);
        EXPECT_EQ(run.events[0].cluster, run.events[1].cluster);
        EXPECT_FALSE(run.events[0].well_posed);
        const Point expected[] = {{-0.2, 0}, {0.6, kRoot3 / 5}, {0.6, -kRoot3 / 5}};
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(run.balls[k].state.velocity.x, expected[k].x, 1e-14) << k;
            EXPECT_NEAR(run.balls[k].state.velocity.y, expected[k].y, 1e-14) << k;
        }
        const double apart = 0x1p-38;
        expect_met_first(played(on_two(later, apart), way), later == 1 ? 2 : 1, 1e-15 + 2 * apart);
    }
}

TEST(Instants, FromBothSidesAnUlpApart) {
    for (const Way& way : every_way()) {
        for (const double by : {0x1p-50, 0.0, -0x1p-50}) {
            Scene scene;
            scene.balls = {disk("left", {-6, 0}, {1, 0}), disk("middle", {0, 0}),
                           disk("right", {6 + by, 0}, {-1, 0})};
            scene.limits.time = 10;
            const auto run = played(scene, way);
            OSCULO_EXPECT_ENDED(run, time_limit);
            // Three contacts in turn, two at once.
            const bool in_turn = way.law == Simultaneous::sequential;
            if (in_turn || by == 0) {
                EXPECT_EQ(run.event_count, in_turn ? 3U : 2U);
            }
            const double expected[] = {-1, 0, 1};
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(run.balls[k].state.velocity.x, expected[k]) << k << " " << by;
            }
            if (in_turn && by != 0) {
                EXPECT_EQ(run.ids(run.events[0])[by > 0 ? 0 : 1], by > 0 ? "left" : "right");
            }
        }
    }
}

// None holds up another one, and all of them are at the same instant to the last bit.
TEST(Instants, EqualInDisjointPlaces) {
    Scene scene;
    for (int k = 0; k < 200; ++k) {
        const double y = 4.0 * k;
        scene.balls.push_back(disk("left-" + std::to_string(k), {-3, y}, {1, 0}));
        scene.balls.push_back(disk("right-" + std::to_string(k), {3, y}, {-1, 0}));
    }
    scene.limits.time = 5;
    for (const Simultaneous law : kEveryLaw) {
        const auto run = played(scene, Way{Precision::double_precision, law});
        OSCULO_EXPECT_ENDED(run, time_limit);
        ASSERT_EQ(run.events.size(), 200U);
        for (const Event& event : run.events) {
            EXPECT_EQ(event.time, 2);
            EXPECT_EQ(event.time_low, 0);
        }
        for (std::size_t k = 0; k < run.balls.size(); ++k) {
            EXPECT_EQ(run.balls[k].state.velocity.x, k % 2 == 0 ? -1 : 1);
        }
    }
}

/// Deceleration 1 m/s^2, exactly.
Scene rolling() {
    Scene scene;
    scene.motion = RollingMotion{0.5};
    scene.gravity = 2;
    return scene;
}

int contacts(const Run& run) {
    int n = 0;
    for (const Event& event : run.events) n += event.kind != EventKind::transition;
    return n;
}

// The end of the last piece is where it touches, without speed: no contact. An ulp farther none, an
// ulp nearer one (or a few of what is pressed together).
TEST(Instants, ComesToRestWhereItTouches) {
    for (const Way& way : every_way()) {
        for (const bool wall : {true, false}) {
            for (const double beyond : {0.0, 0x1p-50, -0x1p-50}) {
                Scene scene = rolling();
                scene.balls = {disk("rolls", {0, 0}, {2, 0})};
                if (wall) {
                    scene.segments = {wall_at(3 + beyond)};
                } else {
                    scene.balls.push_back(disk("waits", {4 + beyond, 0}));
                }
                const auto run = played(scene, way);
                OSCULO_EXPECT_ENDED(run, at_rest);
                if (beyond >= 0) {
                    EXPECT_EQ(run.event_count, 1U) << to_string(way) << wall << beyond;
                    EXPECT_EQ(run.balls[0].state.position.x, 2);
                } else {
                    EXPECT_GE(contacts(run), 1) << to_string(way) << wall;
                    EXPECT_LE(run.event_count, 50U);
                    EXPECT_NEAR(run.balls[0].state.position.x, 2, 1e-6);
                }
            }
        }
    }
}

// The transition comes first, and the contact finds a ball at rest.
TEST(Instants, MetAtTheInstantOfComingToRest) {
    for (const Way& way : every_way()) {
        Scene scene = rolling();
        scene.balls = {disk("stops", {0, 0}, {2, 0}), disk("comes", {-6, 0}, {4, 0})};
        const auto run = played(scene, way);
        OSCULO_EXPECT_ENDED(run, at_rest);
        ASSERT_EQ(run.events.size(), 3U);
        EXPECT_EQ(run.events[0].kind, EventKind::transition);
        EXPECT_EQ(run.events[1].kind, EventKind::ball_ball);
        EXPECT_EQ(run.events[0].time, 2);
        EXPECT_EQ(run.events[1].time, 2);
        EXPECT_EQ(run.balls[0].state.position.x, 4);
        EXPECT_EQ(run.balls[1].state.position.x, 0);
    }
}

// A ball begins to roll where it meets a wall: an ulp before or after makes no difference but of
// rounding. From 7 m/s it slides for 2 v / (7 mu g) = 1 s and 12 v^2 / (49 mu g) = 6 m.
TEST(Instants, BeginsToRollWhereItMeetsAWall) {
    for (const Way& way : every_way()) {
        double ends[3] = {};
        for (int k = 0; k < 3; ++k) {
            Scene scene;
            ClothMotion cloth;
            cloth.sliding_friction = 0.25;
            cloth.rolling_friction = 0.01;
            scene.motion = cloth;
            scene.gravity = 8;
            scene.balls = {disk("ball", {0, 0}, {7, 0})};
            scene.segments = {wall_at(7 + (k - 1) * 0x1p-50)};
            scene.limits.time = 1000;
            const auto run = played(scene, way);
            OSCULO_EXPECT_ENDED(run, at_rest);
            EXPECT_EQ(contacts(run), 1) << to_string(way) << " " << k;
            EXPECT_NEAR(run.events[0].time, 1, 1e-15);
            ends[k] = run.balls[0].state.position.x;
        }
        EXPECT_NEAR(ends[0], ends[1], 1e-13);
        EXPECT_NEAR(ends[2], ends[1], 1e-13);
    }
}

}  // namespace
}  // namespace osculo::support

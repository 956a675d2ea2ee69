#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/extreme_scenes.hpp"

// Speeds of which no square and no inverse is a number, and which below 2^-1022 m/s have no digits
// left, down to the smallest number there is, in every law of motion and kind of contact: what
// happens is right as far as numbers can tell, or the run says that they cannot.
namespace osculo::support {
namespace {

constexpr double kSpeeds[] = {5e-324, 1e-323, 1e-320, 1e-312, 1e-309, 1e-305, 1e-290, 1e-200};
constexpr double kHalfRoot3 = 0.8660254037844386;

struct NamedLaw {
    const char* name;
    MotionLaw law;
};
const NamedLaw kLaws[] = {{"uniform", UniformMotion{}},
                          {"rolling", RollingMotion{0.01}},
                          {"cloth", ClothMotion{}},
                          {"drag", ResistedMotion{0.1, 0.2, 0.3, {}}},
                          {"weak drag", ResistedMotion{0, 0.2, 0.3, {}}},
                          {"hard", ResistedMotion{1e16, 0, 0, {}}}};

/// Around a disk of that speed.
struct Setting {
    const char* name;
    std::vector<Ball> others;
    bool wall = false;
};
std::vector<Setting> settings(double v) {
    return {{"alone", {}},
            {"at a wall", {}, true},
            {"at another", {disk("b", {2, 0})}},
            {"at a heavy one", {disk("b", {2, 0}, {-0.3 * v, 0.7 * v}, 1e12)}},
            {"in a row", {disk("b", {2, 0}), disk("c", {4, 0}, {}, 0.3)}},
            {"between two", {disk("b", {2 * kHalfRoot3, 1}), disk("c", {2 * kHalfRoot3, -1})}},
            {"beside a fast one", {disk("b", {6, 0}), disk("c", {0, 10}, {1, 0})}}};
}

/// Above this no digit is lost.
constexpr double kWholeDigits = 1e-290;

void expect_right(const Scene& scene, double speed, const std::string& where) {
    const Run run = simulate(scene, {.audit = true});
    EXPECT_TRUE(run.audit->clean) << where;
    for (const FinalBall& ball : run.balls) {
        EXPECT_TRUE(std::isfinite(ball.state.velocity.x)) << where;
        EXPECT_TRUE(std::isfinite(ball.state.position.x)) << where;
    }
    if (speed < kWholeDigits) return;
    EXPECT_NE(run.status, Status::numeric) << where;
    EXPECT_NE(run.status, Status::event_limit) << where;
}

TEST(Smallest, SpeedsAreRightOrSaidToBeTooSmall) {
    for (const auto& [law_name, law] : kLaws) {
        for (const double e : {1.0, 0.5, 0.0}) {
            for (const Simultaneous simultaneous : kEveryLaw) {
                for (const double v : kSpeeds) {
                    for (const Setting& setting : settings(v)) {
                        Scene scene;
                        scene.motion = law;
                        scene.impacts.ball_ball.restitution = e;
                        scene.impacts.ball_cushion.restitution = e;
                        scene.impacts.simultaneous = simultaneous;
                        scene.limits = {1e300, 40};
                        scene.balls = {disk("a", {0, 0}, {v, setting.wall ? -0.3 * v : 0})};
                        std::ranges::copy(setting.others, std::back_inserter(scene.balls));
                        if (setting.wall) scene.segments = {wall_at(1)};
                        expect_right(scene, v,
                                     std::string(law_name) + ", " + setting.name +
                                         ", e = " + std::to_string(e) +
                                         ", v = " + std::to_string(std::log10(v)) + ", " +
                                         name_of(simultaneous));
                    }
                }
            }
        }
    }
}

TEST(Smallest, SpeedsComeToRest) {
    for (const auto& [name, law] : kLaws) {
        if (std::holds_alternative<UniformMotion>(law)) continue;
        if (std::string(name) == "weak drag") continue;
        for (const double speed : kSpeeds) {
            Scene scene;
            scene.motion = law;
            scene.balls = {disk("slow", {0, 0}, {speed, 0}),
                           disk("slanted", {0, 5}, {0.7 * speed, -speed})};
            scene.limits = {10, 300};
            SCOPED_TRACE(std::string(name) + ", v = " + std::to_string(std::log10(speed)));
            OSCULO_EXPECT_ENDED(played(scene), at_rest);
        }
    }
}

// Two balls that slow down side by side, one of them already slower than numbers can say how soon
// that will be gone.
TEST(Smallest, WhatIsLeftOfASpeedAndIsGoneInNoTime) {
    Scene scene;
    scene.motion = ResistedMotion{0.1, 0.2, 0.3, {}};
    scene.impacts.ball_ball.restitution = 0.5;
    scene.balls = {disk("a", {0, 0}, {1e-309, 0}), disk("b", {2, 0}, {-3e-310, 7e-310}, 1e12)};
    scene.limits = {1e300, 40};
    OSCULO_EXPECT_ENDED(played(scene), at_rest);
}

// Drag that goes with the square alone: the same at any speed, until the third derivative of a way
// is less than there are numbers.
TEST(Smallest, DragWithTheSquareOfASpeed) {
    const auto run = [](double unit, Precision precision) {
        Scene scene;
        scene.motion = ResistedMotion{0, 0, 0.3, {}};
        scene.balls = {disk("a", {0, 0}, {unit, 0}, 1, 0.5),
                       disk("b", {3, 0.5}, {unit / 8, -unit / 8}, 1, 0.5)};
        scene.limits = {128 / unit, 40};
        return simulate(scene, {.precision = precision, .audit = true});
    };
    const auto usual = run(1, Precision::double_precision);
    ASSERT_EQ(usual.event_count, 1U);
    const auto expect_same = [&](const osculo::Run& slow, double unit) {
        OSCULO_EXPECT_ENDED(slow, time_limit);
        ASSERT_EQ(slow.event_count, 1U) << unit;
        EXPECT_NEAR(slow.events[0].time * unit / usual.events[0].time, 1, 1e-14) << unit;
        EXPECT_NEAR(slow.balls[1].state.position.x, usual.balls[1].state.position.x, 1e-12);
    };
    for (const double unit : {0x1p-100, 0x1p-300}) {
        expect_same(run(unit, Precision::double_precision), unit);
    }
    for (const double unit : {0x1p-400, 0x1p-1000}) {
        EXPECT_EQ(run(unit, Precision::double_precision).status, Status::numeric) << unit;
        expect_same(run(unit, Precision::extended), unit);
    }
}

// Momentum has nothing to do with how fast the balls turn.
TEST(Smallest, SpeedsOfBallsThatTurnFast) {
    Scene scene;
    scene.impacts.ball_ball.law = BallBallLaw::frictional;
    scene.impacts.ball_ball.restitution = 1;
    scene.impacts.ball_ball.friction = {1, 0, 0};
    scene.balls = {disk("turns", {0, 0}, {5e-151, 8e-151}, 1e-12), disk("heavy", {2, 0}, {}, 1e12),
                   disk("last", {4, 0})};
    scene.balls[0].spin = {0, 0, 1e150};
    scene.limits.time = 10;
    for (const Simultaneous simultaneous : kEveryLaw) {
        scene.impacts.simultaneous = simultaneous;
        const auto run = simulate(scene, {.audit = true});
        OSCULO_EXPECT_ENDED(run, time_limit);
        EXPECT_LT(run.audit->largest_momentum_error, 1e-14);
        EXPECT_NEAR(run.balls[0].state.velocity.x / -5e-151, 1, 1e-9);
        EXPECT_NEAR(run.balls[1].state.velocity.x / 1e-174, 1, 1e-9);
    }
}

}  // namespace
}  // namespace osculo::support

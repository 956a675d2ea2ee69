#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "osculo/outcome.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

namespace osculo::presets {
namespace {

std::string error_of(std::string_view name, const Parameters& parameters = {}) {
    try {
        static_cast<void>(make(name, parameters));
        return "no error";
    } catch (const SceneError& error) {
        return error.what();
    }
}

double energy(const std::vector<Ball>& balls) {
    double sum = 0;
    for (const Ball& ball : balls) {
        sum +=
            ball.mass / 2 * (ball.velocity.x * ball.velocity.x + ball.velocity.y * ball.velocity.y);
    }
    return sum;
}

// All bits of all balls, in order (FNV-1a).
std::uint64_t fingerprint(const Scene& scene) {
    std::uint64_t hash = 14695981039346656037U;
    for (const Ball& ball : scene.balls) {
        for (const double value : {ball.mass, ball.radius, ball.position.x, ball.position.y,
                                   ball.velocity.x, ball.velocity.y}) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
        }
    }
    return hash;
}

TEST(Presets, AreValidAndAlwaysTheSame) {
    ASSERT_EQ(list().size(), 13U);
    for (const Info& info : list()) {
        const Scene scene = make(info.name);
        EXPECT_NO_THROW(validate(scene)) << info.name;
        EXPECT_EQ(scene, make(info.name)) << info.name;
        EXPECT_FALSE(info.description.empty());
    }
}

// The same bits with every compiler and machine: these were computed once.
TEST(Presets, AreTheSameBitsEverywhere) {
    EXPECT_EQ(fingerprint(make("box")), 16699725143673766104U);
    EXPECT_EQ(fingerprint(make("carom")), 14855584810453152182U);
    EXPECT_EQ(fingerprint(make("cradle")), 4952348597869716101U);
    EXPECT_EQ(fingerprint(make("pi")), 4527358811413963925U);
    EXPECT_EQ(fingerprint(make("frictionless-break")), 11157173303410484448U);
    EXPECT_EQ(fingerprint(make("gas", {.balls = 1000, .seed = 42})), 13574959973670947877U);
}

TEST(Presets, RefuseWhatTheyDoNotKnow) {
    EXPECT_EQ(error_of("break", {.restitution = 0.5}),
              "restitution: is not a parameter of the preset break, which takes speed (8, of the "
              "cue), gap (1e-4), seed (31)");
    EXPECT_EQ(error_of("braek"),
              "preset: must be the name of a preset, did you mean break?, but it is braek");
    EXPECT_EQ(error_of("cradle", {.digits = 3}),
              "digits: is not a parameter of the preset cradle, which takes balls (5, 3 to 15), "
              "gap (0), speed (1), restitution (1)");
    EXPECT_EQ(error_of("cradle", {.balls = 16}), "balls: must be from 3 to 15, but it is 16");
    EXPECT_EQ(error_of("pi", {.digits = 8}), "digits: must be from 1 to 7, but it is 8");
    EXPECT_EQ(error_of("gas", {.packing = 0.7}),
              "packing: must be from 1e-06 to 0.6, but it is 0.7");
    EXPECT_EQ(error_of("box", {.speed = 0.0}), "speed: must be from 1e-100 to 1e+100, but it is 0");
    EXPECT_EQ(error_of("box", {.restitution = std::nan("")}),
              "restitution: must be from 0 to 1, but it is nan");
    EXPECT_EQ(error_of("break", {.gap = -1.0}),
              "rack.gap: must be from 0 to 0.028575, but it is -1");
    EXPECT_EQ(error_of("gas", {.balls = 2, .packing = 0.6}),
              "packing: must leave room for 2 balls, but it is 0.6");
}

TEST(Presets, EveryListedParameterIsTaken) {
    const Parameters all{.balls = 3,
                         .packing = 0.2,
                         .gap = 1e-3,
                         .speed = 2.0,
                         .restitution = 0.5,
                         .digits = 2,
                         .seed = 3};
    for (const Info& info : list()) {
        const auto has = [&](const char* name) {
            return info.parameters.find(name) != std::string_view::npos;
        };
        Parameters taken;
        if (has("balls")) taken.balls = all.balls;
        if (has("packing")) taken.packing = all.packing;
        if (has("gap")) taken.gap = all.gap;
        if (has("speed")) taken.speed = all.speed;
        if (has("restitution")) taken.restitution = all.restitution;
        if (has("digits")) taken.digits = all.digits;
        if (has("seed")) taken.seed = all.seed;
        const Scene scene = make(info.name, taken);
        EXPECT_NO_THROW(validate(scene)) << info.name;
        EXPECT_NE(scene, make(info.name)) << info.name;
        if (taken.restitution) {
            EXPECT_EQ(scene.impacts.ball_ball.restitution, 0.5) << info.name;
        }
        if (taken.balls) {
            EXPECT_EQ(scene.balls.size(), 3U) << info.name;
        }
    }
}

TEST(Gas, CoversTheFractionAskedFor) {
    for (const std::uint32_t count : {2U, 3U, 10U, 37U, 1000U, 4096U}) {
        const Scene scene = make("gas", {.balls = count, .packing = 0.25});
        ASSERT_EQ(scene.balls.size(), count);
        double area = 0;
        for (const Ball& b : scene.balls) area += std::numbers::pi * b.radius * b.radius;
        EXPECT_NEAR(area, 0.25, 1e-12);
        EXPECT_NO_THROW(validate(scene)) << count;
    }
    for (const std::uint32_t count : {4U, 16U, 100U, 1000U, 5000U}) {
        EXPECT_NO_THROW(validate(make("gas", {.balls = count, .packing = 0.6}))) << count;
    }
}

TEST(Gas, HasNoMomentumAndTheSpeedAskedFor) {
    const Scene scene = make("gas", {.balls = 1000, .speed = 3.0, .seed = 5});
    Point momentum;
    for (const Ball& ball : scene.balls) {
        momentum.x += ball.velocity.x;
        momentum.y += ball.velocity.y;
    }
    EXPECT_NEAR(momentum.x, 0, 1e-11);
    EXPECT_NEAR(momentum.y, 0, 1e-11);
    EXPECT_NEAR(2 * energy(scene.balls) / 1000, 9.0, 1e-11);
    EXPECT_NE(scene, make("gas", {.balls = 1000, .speed = 3.0, .seed = 6}));
}

// Maxwell: the mean of v_x^4 is three times the square of the mean of v_x^2.
TEST(Gas, VelocitiesAreNearlyMaxwells) {
    const Scene scene = make("gas", {.balls = 100'000});
    double second = 0;
    double fourth = 0;
    for (const Ball& ball : scene.balls) {
        const double squared = ball.velocity.x * ball.velocity.x;
        second += squared / 100'000;
        fourth += squared * squared / 100'000;
    }
    EXPECT_NEAR(fourth / (second * second), 2.9, 0.05);  // of twelve uniforms: 3 - 1/10
}

TEST(Gas, HoldsAMillion) {
    const Scene scene = make("gas", {.balls = 1'000'000, .packing = 0.5});
    EXPECT_EQ(scene.balls.size(), 1'000'000U);
    EXPECT_EQ(scene.balls.back().id, "disk-1000000");
}

TEST(Pi, CountsItsDigits) {
    const std::uint64_t expected[]{3, 31, 314, 3141, 31415};
    for (std::uint32_t digits = 1; digits <= 5; ++digits) {
        const osculo::Run run = simulate(make("pi", {.digits = digits}), {.record = Record::none});
        EXPECT_EQ(run.event_count, expected[digits - 1]);
        EXPECT_EQ(run.status, Status::time_limit);
        EXPECT_LT(run.event_count, run.scene.limits.events);
        // Nothing is left to happen: neither approaches the wall, and the big one is not slower.
        EXPECT_GE(run.balls[0].state.velocity.x, 0);
        EXPECT_GE(run.balls[1].state.velocity.x, run.balls[0].state.velocity.x);
    }
}

TEST(Pi, DoesNotDependOnTheSpeed) {
    for (const double speed : {1e-3, 0.7, 1e4}) {
        const osculo::Run run = simulate(make("pi", {.speed = speed}), {.record = Record::none});
        EXPECT_EQ(run.event_count, 314U) << speed;
    }
}

TEST(Cradle, PassesTheSpeedOnToTheLastBall) {
    for (const std::uint32_t balls : {3U, 5U, 15U}) {
        for (const double gap : {0.0, 1e-9, 1e-3}) {
            Scene scene = make("cradle", {.balls = balls, .gap = gap, .speed = 2.0});
            // All at once the last digit may be lost.
            const osculo::Run together = simulate(scene);
            EXPECT_EQ(together.event_count, balls - 1);
            EXPECT_EQ(together.events.back().cluster, gap == 0 ? 1U : 0U) << balls << ' ' << gap;
            for (std::uint32_t i = 0; i + 1 < balls; ++i) {
                EXPECT_NEAR(together.balls[i].state.velocity.x, 0, 1e-15) << balls << ' ' << i;
            }
            EXPECT_NEAR(together.balls.back().state.velocity.x, 2, 1e-15) << balls << ' ' << gap;

            scene.impacts.simultaneous = Simultaneous::sequential;
            const osculo::Run run = simulate(scene);
            EXPECT_EQ(run.event_count, balls - 1);
            for (std::uint32_t i = 0; i + 1 < balls; ++i) {
                EXPECT_EQ(run.balls[i].fate, BallFate::rest) << balls << ' ' << gap << ' ' << i;
            }
            EXPECT_EQ(run.balls.back().state.velocity, (Point{2, 0}));
        }
    }
}

TEST(FrictionlessBreak, BeginsWithTheCueBallAndKeepsItsEnergy) {
    const osculo::Run run = simulate(make("frictionless-break"));
    ASSERT_FALSE(run.events.empty());
    std::array<std::string, 2> first = run.ids(run.events[0]);
    std::ranges::sort(first);
    EXPECT_EQ(first, (std::array<std::string, 2>{"1", "cue"}));
    EXPECT_GT(run.event_count, 100U);
    EXPECT_GT(std::ranges::count(run.balls, BallFate::captured, &FinalBall::fate), 3);
    double final_energy = 0;
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        const Point& v = run.balls[i].state.velocity;
        final_energy += run.scene.balls[i].mass / 2 * (v.x * v.x + v.y * v.y);
    }
    EXPECT_NEAR(final_energy / energy(run.scene.balls), 1, 1e-13);
}

TEST(Shots, ComeToRest) {
    for (const char* name : {"break", "nine-ball", "snooker-break", "three-cushion"}) {
        const osculo::Run run = simulate(make(name));
        EXPECT_EQ(run.status, Status::at_rest) << name;
        EXPECT_LT(run.time, 20) << name;
        const auto moved = std::ranges::count_if(run.balls, [&](const FinalBall& ball) {
            const auto i = static_cast<std::size_t>(&ball - run.balls.data());
            return ball.state.position != run.scene.balls[i].position;
        });
        EXPECT_GE(moved, 2) << name;
        EXPECT_EQ(short_text(name).has_value(), true);
    }
    EXPECT_EQ(short_text("gas"), std::nullopt);
    EXPECT_THROW(static_cast<void>(short_text("break", {.gap = 1.0})), SceneError);
}

TEST(Shots, AreWhatTheySay) {
    const auto play = [](const char* name) { return outcome_of(simulate(make(name))).value(); };
    const auto fell = [](const Outcome& outcome, std::uint32_t ball) {
        return std::ranges::count(outcome.falls, ball, &Outcome::Fall::ball) == 1;
    };
    for (const char* name : {"break", "nine-ball"}) {
        const Outcome outcome = play(name);
        EXPECT_EQ(outcome.hits[0].ball, 0U) << name;  // the 1
        EXPECT_FALSE(fell(outcome, outcome.cue_ball.value())) << name;
        EXPECT_EQ(outcome.falls.size(), 2U) << name;
        EXPECT_GE(outcome.driven_to_cushion, 4U) << name;
    }
    const Outcome safe = play("snooker-break");
    EXPECT_EQ(make("snooker-break").balls[safe.hits.at(0).ball].id, "red-15");
    EXPECT_LT(safe.balls[safe.cue_ball.value()].position.y, 0.737);  // back in baulk
    EXPECT_TRUE(safe.falls.empty());
    const Outcome point = play("three-cushion");
    ASSERT_EQ(point.hits.size(), 2U);
    EXPECT_EQ(make("three-cushion").balls[point.hits[0].ball].id, "red");
    EXPECT_EQ(point.hits[0].cushions, 0U);
    EXPECT_EQ(point.hits[1].cushions, 3U);
}

TEST(TableLaws, AreThoseOfTheGame) {
    Scene scene;
    set_table_laws(scene, "pool-9ft");
    const auto cloth = std::get<ClothMotion>(scene.motion);
    EXPECT_EQ(cloth.sliding_friction, 0.2);
    EXPECT_DOUBLE_EQ(cloth.spinning_friction, 0.0127);
    EXPECT_EQ(scene.impacts.ball_ball.law, BallBallLaw::frictional);
    EXPECT_DOUBLE_EQ(scene.impacts.ball_cushion.height, 0.036576);
    EXPECT_EQ(scene.impacts.ball_cushion.friction, 0.2);
    set_table_laws(scene, "snooker-12ft");
    EXPECT_EQ(std::get<ClothMotion>(scene.motion).sliding_friction, 0.5);
    EXPECT_EQ(scene.impacts.ball_cushion.friction, 0.5);
    set_table_laws(scene, "carom-10ft");
    EXPECT_EQ(scene.impacts.ball_cushion.height, 0.037);
    EXPECT_EQ(scene.impacts.ball_cushion.friction, 0.15);
    EXPECT_THROW(set_table_laws(scene, "pool"), SceneError);
}

TEST(Carom, WhiteMeetsRedFourCushionsAndYellow) {
    const osculo::Run run = simulate(make("carom"));
    std::vector<std::string> met;
    for (const Event& event : run.events) {
        const auto [ball, other] = run.ids(event);
        if (ball == "white") met.push_back(other);
        if (other == "white") met.push_back(ball);
    }
    ASSERT_GE(met.size(), 6U);
    met.resize(6);
    EXPECT_EQ(met, (std::vector<std::string>{"red", "top", "right", "left", "bottom", "yellow"}));
}

}  // namespace
}  // namespace osculo::presets

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "osculo/noise.hpp"
#include "osculo/outcome.hpp"
#include "support/batches.hpp"

namespace osculo {
namespace {

constexpr double kZ = 1.959963984540054;  // of 95 %

/// The cue ball alone, 1 m away from a hole of 0.05 m.
Scene putting_green() {
    Scene scene;
    scene.motion = ClothMotion{};
    scene.balls = {test::ball("cue", {0, 0}, {}, 0.0286)};
    scene.rims = {{"hole", {1, 0}, 0.05}};
    return scene;
}

// It falls if the error of the azimuth is below asin(R / d).
TEST(Success, IsThatOfOnePutt) {
    Batch batch(putting_green(), {.threads = 2});
    const double sigma = 0.03;
    const double expected = std::erf(std::asin(0.05) / sigma / std::numbers::sqrt2);
    const Goal goal{.pots = {{0, 0}}, .no_scratch = false};
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Success success =
            success_probability(batch, {.speed = 3, .elevation = 0}, goal,
                                {.noise = {.azimuth = sigma}, .seed = seed, .draws = 20000});
        EXPECT_EQ(success.draws, 20000U);
        EXPECT_EQ(success.impossible + success.unfinished, 0U);
        // Four standard deviations.
        EXPECT_NEAR(success.probability, expected,
                    4 * std::sqrt(expected * (1 - expected) / 20000));
        EXPECT_LT(success.low, success.probability);
        EXPECT_GT(success.high, success.probability);
    }
}

// In 95 of 100 cases, within what binomial numbers do.
TEST(Success, HasTheTruthInItsIntervalAsOftenAsItSays) {
    Batch batch(putting_green());
    const double sigma = 0.03;
    const double truth = std::erf(std::asin(0.05) / sigma / std::numbers::sqrt2);
    const Goal goal{.pots = {{0, {}}}, .no_scratch = false};
    int held = 0;
    for (std::uint64_t shot = 0; shot < 400; ++shot) {
        const Success success =
            success_probability(batch, {.speed = 3, .elevation = 0}, goal,
                                {.noise = {.azimuth = sigma}, .shot = shot, .draws = 200});
        held += success.low <= truth && truth <= success.high;
    }
    EXPECT_GE(held, 380 - 4 * 4.4);
    EXPECT_LE(held, 380 + 4 * 4.4);
}

TEST(Success, DoesNotDependOnThreadsAndStopsAtTheWidth) {
    const Scene scene = test::pool_scene(5);
    const Strike strike{.speed = 3, .azimuth = 1.62};
    const Goal goal{.first_hit = 2};
    Success first;
    for (const unsigned threads : {1U, 2U, 3U}) {
        Batch batch(scene, {.threads = threads, .chunk = threads});
        const Success success = success_probability(
            batch, strike, goal, {.noise = computational_pool_noise(8), .seed = 4, .width = 0.05});
        EXPECT_LE(success.high - success.low, 0.05);
        EXPECT_LT(success.draws, 10000U);
        EXPECT_GT(success.successes, 0U);
        EXPECT_LT(success.successes, success.draws);
        if (threads == 1) first = success;
        EXPECT_EQ(success.draws, first.draws);
        EXPECT_EQ(success.successes, first.successes);
        EXPECT_EQ(success.low, first.low);
        EXPECT_EQ(success.high, first.high);
    }
}

TEST(Success, HasWilsonsInterval) {
    Batch batch(putting_green());
    const Strike strike{.speed = 1, .elevation = 0};
    const SuccessOptions options{.noise = {}, .draws = 100};
    const auto play = [&](const Predicate& predicate) {
        return success_probability(batch, strike, predicate, options);
    };
    const double square = kZ * kZ;
    const Success all = play([](const BatchResult&, std::size_t) { return true; });
    EXPECT_EQ(all.probability, 1);
    EXPECT_EQ(all.high, 1);
    EXPECT_NEAR(all.low, 100 / (100 + square), 1e-15);
    const Success none = play([](const BatchResult&, std::size_t) { return false; });
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, square / (100 + square), 1e-15);
    const Success half = play([](const BatchResult&, std::size_t shot) { return shot % 2 == 0; });
    EXPECT_EQ(half.probability, 0.5);
    EXPECT_NEAR(half.low, 0.5 - kZ / (2 * std::sqrt(100 + square)), 1e-15);
    EXPECT_NEAR(half.high, 0.5 + kZ / (2 * std::sqrt(100 + square)), 1e-15);
}

TEST(Success, CountsWhatCannotBePlayedAndWhatDoesNotEnd) {
    const Predicate always = [](const BatchResult&, std::size_t) { return true; };
    Batch batch(putting_green());
    // On the edge of a miscue.
    Success success = success_probability(batch, {.elevation = 0, .side = 0.55}, always,
                                          {.noise = {.side = 0.0005}, .draws = 4000});
    EXPECT_NEAR(static_cast<double>(success.impossible), 2000, 4 * 32);
    EXPECT_EQ(success.impossible + success.successes, 4000U);
    Batch cut_off(putting_green(), {.limits = Limits{0.1, 1000}});
    success = success_probability(cut_off, {.elevation = 0}, always, {.draws = 50});
    EXPECT_EQ(success.unfinished, 50U);
    EXPECT_EQ(success.probability, 0);
}

// A stick that would be too low lies on the rail; the least elevation is a number with noise.
TEST(Success, LaysTheStickOnWhatIsInItsWay) {
    const Scene scene = test::pool_scene(3);
    const Predicate always = [](const BatchResult&, std::size_t) { return true; };
    Batch batch(scene);
    for (const double elevation : {kLeastElevation, 0.0}) {
        const Success success =
            success_probability(batch, {.azimuth = 1.5, .elevation = elevation}, always,
                                {.noise = computational_pool_noise(), .draws = 200});
        EXPECT_EQ(success.impossible, 0U);
        EXPECT_EQ(success.probability, 1);
    }
}

TEST(Goal, IsWhatIsMeant) {
    BatchResult result;
    result.shots = 2;
    result.balls = 3;
    result.cue_ball = {0, 0};
    result.first_hit = {1, -1};
    result.rim = {-1, 4, -1, 2, -1, 3};
    EXPECT_TRUE(Goal{}(result, 0));
    EXPECT_FALSE(Goal{}(result, 1));  // a scratch
    EXPECT_TRUE((Goal{.no_scratch = false})(result, 1));
    EXPECT_TRUE((Goal{.pots = {{1, {}}}})(result, 0));
    EXPECT_TRUE((Goal{.pots = {{1, 4}}})(result, 0));
    EXPECT_FALSE((Goal{.pots = {{1, 3}}})(result, 0));
    EXPECT_FALSE((Goal{.pots = {{1, 4}, {2, {}}}})(result, 0));
    EXPECT_TRUE((Goal{.first_hit = 1})(result, 0));
    EXPECT_FALSE((Goal{.first_hit = 2})(result, 0));
    EXPECT_FALSE((Goal{.first_hit = 1, .no_scratch = false})(result, 1));
    result.cue_ball = {-1, -1};
    EXPECT_TRUE(Goal{}(result, 1));
}

TEST(Success, RefusesOptionsOutOfRange) {
    Batch batch(putting_green());
    EXPECT_THROW((void)success_probability(batch, {}, Goal{}, {.draws = 0}), std::invalid_argument);
    EXPECT_THROW((void)success_probability(batch, {}, Goal{}, {.width = -1}),
                 std::invalid_argument);
    EXPECT_THROW((void)success_probability(batch, {}, Goal{}, {.confidence = 1}),
                 std::invalid_argument);
    Scene rolling = putting_green();
    rolling.motion = RollingMotion{};
    Batch without_cloth(rolling);
    EXPECT_THROW((void)success_probability(without_cloth, {}, Goal{}), SceneError);
}

}  // namespace
}  // namespace osculo

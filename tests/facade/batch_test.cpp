#include "osculo/batch.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "osculo/outcome.hpp"
#include "support/batches.hpp"
#include "support/simulations.hpp"

namespace osculo {
namespace {

std::int32_t index_or_none(const std::optional<std::uint32_t>& index) {
    return index ? static_cast<std::int32_t>(*index) : -1;
}

/// Expects shot i to be what simulate() says of its scene. Ball n of that scene is ball place[n] of
/// the batch's scene.
void expect_shot(const BatchResult& result, std::size_t i, const Run& run,
                 const std::vector<std::size_t>& place) {
    SCOPED_TRACE(testing::Message() << "shot " << i);
    const Outcome outcome = outcome_of(run).value();
    const auto there = [&](std::uint32_t n) { return static_cast<std::int32_t>(place[n]); };
    EXPECT_EQ(result.status[i], static_cast<ShotStatus>(run.status));
    EXPECT_EQ(result.time[i], run.time);
    EXPECT_EQ(result.event_count[i], run.event_count);
    EXPECT_EQ(result.cue_ball[i], outcome.cue_ball ? there(*outcome.cue_ball) : -1);
    EXPECT_EQ(result.first_hit[i], outcome.hits.empty() ? -1 : there(outcome.hits[0].ball));
    EXPECT_EQ(result.cushions_before_hit[i], outcome.cushions_before_hit);
    EXPECT_EQ(result.cushions_after_hit[i], outcome.cushions_after_hit);
    EXPECT_EQ(result.driven_to_cushion[i], outcome.driven_to_cushion);
    EXPECT_EQ(result.kisses[i], outcome.kisses);
    EXPECT_EQ(result.settled_count[i], run.settled_count);
    for (std::size_t n = 0; n < place.size(); ++n) {
        const std::size_t k = i * result.balls + place[n];
        EXPECT_EQ(result.fate[k], static_cast<ShotFate>(run.balls[n].fate));
        EXPECT_EQ(result.position[k], run.balls[n].state.position);
        EXPECT_EQ(result.rim[k], index_or_none(run.balls[n].rim));
        EXPECT_EQ(result.ball_contacts[k], outcome.balls[n].balls);
        EXPECT_EQ(result.cushion_contacts[k], outcome.balls[n].cushions);
        if (!result.state.empty()) {
            EXPECT_EQ(result.state[k], run.balls[n].state);
        }
        const auto fall = std::ranges::find(outcome.falls, n, &Outcome::Fall::ball);
        if (fall == outcome.falls.end()) {
            EXPECT_TRUE(std::isnan(result.capture_time[k]));
        } else {
            EXPECT_EQ(result.capture_time[k], fall->time);
        }
    }
}

std::vector<std::size_t> all_places(std::size_t balls) {
    std::vector<std::size_t> places(balls);
    for (std::size_t i = 0; i < balls; ++i) places[i] = i;
    return places;
}

TEST(Batch, OfStrikesIsWhatSimulateSaysOneByOne) {
    const Scene scene = test::pool_scene(9);
    const auto strikes = test::random_strikes(60, 1);
    const BatchResult result = simulate_batch(scene, strikes, {.states = true, .threads = 2});
    ASSERT_EQ(result.shots, strikes.size());
    ASSERT_EQ(result.balls, scene.balls.size());
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        expect_shot(result, i, simulate(scene_of(scene, strikes[i])), all_places(10));
    }
    // They are not all alike.
    EXPECT_GT(std::ranges::count(result.fate, ShotFate::captured), 5);
    EXPECT_GT(std::ranges::count(result.first_hit, -1), 3);
    EXPECT_LT(std::ranges::count(result.first_hit, -1), 50);
}

TEST(Batch, OfStartsIsWhatSimulateSaysOneByOne) {
    Scene scene = test::pool_scene(7);
    for (const MotionLaw& motion :
         {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.02}), MotionLaw(ClothMotion{})}) {
        SCOPED_TRACE(motion.index());
        scene.motion = motion;
        scene.impacts.ball_ball = {BallBallLaw::restitution, 0.95, {}};
        scene.impacts.ball_cushion = {CushionLaw::restitution, 0.9};
        scene.limits.time = 5;
        constexpr std::size_t kShots = 30;
        const auto states = test::random_states(scene, kShots, 2);
        std::vector<std::uint8_t> present(states.size());
        for (std::size_t k = 0; k < present.size(); ++k) present[k] = k % 7 != 3;
        const Starts starts{states, present};
        const BatchResult result = simulate_batch(scene, starts, {.states = true, .threads = 2});
        ASSERT_EQ(result.shots, kShots);
        for (std::size_t i = 0; i < kShots; ++i) {
            std::vector<std::size_t> place;
            for (std::size_t n = 0; n < 8; ++n) {
                if (present[8 * i + n] != 0) {
                    place.push_back(n);
                } else {
                    EXPECT_EQ(result.fate[8 * i + n], ShotFate::absent);
                    EXPECT_EQ(result.position[8 * i + n], Point{});
                }
            }
            expect_shot(result, i, simulate(scene_of(scene, starts, i)), place);
        }
    }
}

// Into a rim that pulls a ball falls by a transition, at a time and in a place of its own.
TEST(Batch, CountsFallsIntoRimsThatPullAndWhatSettles) {
    std::mt19937_64 random(5);
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        Scene scene = test::pulling_scene(motion);
        scene.impacts.rest_speed = 0.4;
        scene.limits.time = 5;
        constexpr std::size_t kShots = 40;
        std::vector<BallState> states;
        for (std::size_t shot = 0; shot < kShots; ++shot) {
            for (const Ball& ball : scene.balls) {
                const Point velocity{0.2 + test::uniform(random),
                                     0.2 * test::uniform(random) - 0.1};
                states.push_back({ball.position, velocity, {}});
            }
        }
        const Starts starts{states};
        const BatchResult result = simulate_batch(scene, starts, {.states = true, .threads = 2});
        std::size_t falls = 0;
        std::uint64_t settled = 0;
        for (std::size_t i = 0; i < kShots; ++i) {
            expect_shot(result, i, simulate(scene_of(scene, starts, i)), all_places(4));
            settled += result.settled_count[i];
            for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
                if (result.rim[k] != 0) continue;
                ++falls;
                EXPECT_EQ(result.fate[k], ShotFate::captured);
                EXPECT_GT(result.capture_time[k], 0);
                EXPECT_NEAR(std::hypot(result.position[k].x, result.position[k].y),
                            0.06 - scene.balls[0].radius, 1e-15);
            }
        }
        EXPECT_GT(falls, 10U);
        EXPECT_GT(settled, 5U);
    }
}

TEST(Batch, HasTheSameBitsForAnyNumberOfThreadsAndAnyChunks) {
    const Scene scene = test::pool_scene(8);
    const auto strikes = test::random_strikes(40, 3);
    BatchOptions options{.record = Record::pieces, .states = true, .threads = 1, .chunk = 1000};
    const BatchResult expected = simulate_batch(scene, strikes, options);
    EXPECT_GT(expected.events.size(), 400U);
    for (const unsigned threads : {1U, 2U, 3U, 7U}) {
        for (const std::size_t chunk : {0, 1, 7, 100}) {
            options.threads = threads;
            options.chunk = chunk;
            EXPECT_TRUE(test::same_result(simulate_batch(scene, strikes, options), expected))
                << threads << " threads, chunks of " << chunk;
        }
    }
}

TEST(Batch, KeepsEventsAndPiecesLikeARun) {
    Scene scene = test::pool_scene(5);
    for (const CushionLaw law : {CushionLaw::restitution, CushionLaw::han_2005,
                                 CushionLaw::mathavan_2010, CushionLaw::stronge}) {
        scene.impacts.ball_cushion.law = law;
        const auto strikes = test::random_strikes(6, 4);
        for (const Record record : {Record::events, Record::pieces}) {
            const BatchResult result = simulate_batch(scene, strikes, {.record = record});
            for (std::size_t i = 0; i < strikes.size(); ++i) {
                const osculo::Run run = simulate(scene_of(scene, strikes[i]));
                const auto from = result.events.begin();
                EXPECT_TRUE(
                    std::equal(from + static_cast<std::ptrdiff_t>(result.event_offsets[i]),
                               from + static_cast<std::ptrdiff_t>(result.event_offsets[i + 1]),
                               run.events.begin(), run.events.end()));
                EXPECT_EQ(result.points, run.points);
                if (record != Record::pieces) continue;
                const auto piece = result.pieces.begin();
                EXPECT_TRUE(
                    std::equal(piece + static_cast<std::ptrdiff_t>(result.piece_offsets[i]),
                               piece + static_cast<std::ptrdiff_t>(result.piece_offsets[i + 1]),
                               run.pieces.begin(), run.pieces.end()));
            }
            EXPECT_EQ(result.pieces.empty(), record != Record::pieces);
        }
    }
}

TEST(Batch, RunsInEveryPrecision) {
    const Scene scene = test::pool_scene(2);
    const auto strikes = test::random_strikes(2, 5);
    for (const Precision precision :
         {Precision::extended, Precision::quad, Precision::digits50, Precision::digits100}) {
        const BatchResult result = simulate_batch(scene, strikes, {.precision = precision});
        for (std::size_t i = 0; i < strikes.size(); ++i) {
            expect_shot(result, i, simulate(scene_of(scene, strikes[i]), {.precision = precision}),
                        all_places(3));
        }
    }
}

bool is_valid(const Scene& scene) {
    try {
        validate(scene);
        return true;
    } catch (const SceneError&) {
        return false;
    }
}

TEST(Batch, LetsNoBadStrikeDisturbTheOthers) {
    const Scene scene = test::pool_scene(6);
    const auto good = test::random_strikes(30, 6);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Strike> bad(9);
    bad[0].speed = 0;
    bad[1].speed = kNan;
    bad[2].speed = 1e200;
    bad[3].azimuth = kNan;
    bad[4].azimuth = 1e300;
    bad[5].elevation = 1.6;
    bad[6].elevation = 0;  // the rail behind the ball is in the way
    bad[7].side = 0.5;
    bad[7].height = 0.5;  // a miscue
    bad[8].height = kNan;
    std::vector<Strike> all;
    for (std::size_t i = 0; i < good.size(); ++i) {
        if (i < bad.size()) all.push_back(bad[i]);
        all.push_back(good[i]);
    }
    const BatchResult alone = simulate_batch(scene, good, {.threads = 2});
    const BatchResult mixed = simulate_batch(scene, all, {.threads = 2, .chunk = 2});
    for (std::size_t i = 0; i < good.size(); ++i) {
        const std::size_t k = i < bad.size() ? 2 * i + 1 : i + bad.size();
        EXPECT_EQ(mixed.status[k], alone.status[i]) << i;
        EXPECT_EQ(mixed.time[k], alone.time[i]) << i;
        for (std::size_t n = 0; n < mixed.balls; ++n) {
            EXPECT_EQ(mixed.position[k * mixed.balls + n], alone.position[i * mixed.balls + n]);
        }
        EXPECT_NE(mixed.status[k], ShotStatus::invalid);
    }
    for (std::size_t i = 0; i < bad.size(); ++i) {
        EXPECT_EQ(mixed.status[2 * i], ShotStatus::invalid) << i;
        EXPECT_EQ(mixed.event_count[2 * i], 0U);
        EXPECT_EQ(mixed.fate[2 * i * mixed.balls], ShotFate::absent);
        EXPECT_FALSE(is_valid(scene_of(scene, bad[i]))) << i;
    }
}

TEST(Batch, IsInvalidWhereTheSceneOfTheShotIs) {
    // From crowded places, half of which cannot be.
    Scene scene = test::pool_scene(3);
    scene.closed = true;
    constexpr std::size_t kShots = 400;
    std::mt19937_64 random(7);
    std::vector<BallState> states;
    for (std::size_t k = 0; k < kShots * 4; ++k) {
        states.push_back(
            {{1.04 * test::uniform(random) - 0.02, 2.04 * test::uniform(random) - 0.02},
             {test::uniform(random), 0},
             {}});
    }
    states[17].position.x = std::numeric_limits<double>::quiet_NaN();
    states[21].velocity.y = 1e200;
    states[25].spin[1] = -std::numeric_limits<double>::infinity();
    states[29].position = {5, 5};  // outside of the table
    states[33].position = states[32].position;
    std::vector<std::uint8_t> present(states.size(), 1);
    for (std::size_t k = 0; k < present.size(); k += 5) present[k] = 0;
    scene.limits.time = 0.1;
    for (const Starts& starts : {Starts{states, {}}, Starts{states, present}}) {
        const BatchResult result = simulate_batch(scene, starts, {.threads = 2});
        for (std::size_t i = 0; i < kShots; ++i) {
            EXPECT_EQ(result.status[i] != ShotStatus::invalid, is_valid(scene_of(scene, starts, i)))
                << i;
        }
        const auto invalid = std::ranges::count(result.status, ShotStatus::invalid);
        EXPECT_GT(invalid, 50);
        EXPECT_LT(invalid, 350);
    }
}

TEST(Batch, KeepsToItsLimits) {
    const Scene scene = test::pool_scene(6);
    const auto strikes = test::random_strikes(20, 8);
    for (const Limits& limits : {Limits{0.25, 1000}, Limits{60, 3}}) {
        const BatchResult result = simulate_batch(scene, strikes, {.limits = limits});
        const ShotStatus reached =
            limits.events == 3 ? ShotStatus::event_limit : ShotStatus::time_limit;
        EXPECT_GT(std::ranges::count(result.status, reached), 15);
        for (std::size_t i = 0; i < strikes.size(); ++i) {
            Scene limited = scene_of(scene, strikes[i]);
            limited.limits = limits;
            expect_shot(result, i, simulate(limited), all_places(7));
        }
    }
    EXPECT_THROW(simulate_batch(scene, strikes, {.limits = Limits{-1, 3}}), SceneError);
}

TEST(Batch, PlaysBatchesOfBothKindsOneAfterAnother) {
    const Scene scene = test::pool_scene(6);
    const auto strikes = test::random_strikes(20, 9);
    const auto states = test::random_states(scene, 30, 9);
    const Starts starts{states, {}};
    Batch batch(scene, {.threads = 3, .chunk = 1});
    BatchResult result;
    for (int repetition = 0; repetition < 3; ++repetition) {
        batch.run(strikes, result);
        EXPECT_TRUE(test::same_result(result, simulate_batch(scene, strikes)));
        batch.run(starts, result);
        EXPECT_TRUE(test::same_result(result, simulate_batch(scene, starts)));
        batch.run(std::span<const Strike>(), result);
        EXPECT_EQ(result.shots, 0U);
    }
    EXPECT_EQ(batch.threads(), 3U);
    EXPECT_EQ(batch.engine_name(),
              "cloth/han_2005/symmetric/rims+segments+arcs+points/double/contacts/all-pairs");
}

TEST(Batch, IsStopped) {
    const Scene scene = test::pool_scene(4);
    const auto strikes = test::random_strikes(20, 10);
    std::stop_source stop;
    stop.request_stop();
    const BatchResult result = simulate_batch(scene, strikes, {}, {.stop = stop.get_token()});
    EXPECT_EQ(std::ranges::count(result.status, ShotStatus::not_run), 20);
    EXPECT_EQ(std::ranges::count(result.fate, ShotFate::absent), 100);
}

/// Shots that would take many seconds.
std::vector<BallState> long_shots(Scene& scene) {
    scene = {};
    test::add_box(scene, 4, 4);
    scene.balls = {test::ball("a", {1, 1})};
    scene.limits = {1e9, 2000};
    return std::vector<BallState>(50000, BallState{{1, 1}, {1, 0.3}});
}

TEST(Batch, IsStoppedByItsProgressAndKeepsWhatIsDone) {
    Scene scene;
    const auto states = long_shots(scene);
    std::stop_source stop;
    std::size_t last = 0;
    const BatchControl control{stop.get_token(), [&](std::size_t done, std::size_t all) {
                                   EXPECT_EQ(all, 50000U);
                                   EXPECT_GE(done, last);
                                   last = done;
                                   stop.request_stop();
                               }};
    const BatchResult result = simulate_batch(scene, Starts{states, {}}, {.threads = 2}, control);
    const auto done = std::ranges::count(result.status, ShotStatus::event_limit);
    const auto rest = std::ranges::count(result.status, ShotStatus::not_run);
    EXPECT_EQ(done + rest, 50000);
    EXPECT_EQ(static_cast<std::size_t>(done), last);  // called at the end
    EXPECT_GT(done, 0);
    EXPECT_GT(rest, 0);
}

TEST(Batch, ThrowsWhatItsProgressThrowsAndGoesOn) {
    Scene scene;
    const auto states = long_shots(scene);
    Batch batch(scene, {.threads = 2});
    BatchResult result;
    const BatchControl control{
        {}, [](std::size_t, std::size_t) { throw std::runtime_error("enough"); }};
    EXPECT_THROW(batch.run(Starts{states, {}}, result, control), std::runtime_error);
    const Starts few{std::span(states).first(3), {}};
    batch.run(few, result);
    EXPECT_EQ(std::ranges::count(result.status, ShotStatus::event_limit), 3);
}

TEST(Batch, RefusesWhatDoesNotFit) {
    Scene scene = test::pool_scene(2);
    const auto strikes = test::random_strikes(2, 11);
    const std::vector<BallState> states(7);
    const std::vector<std::uint8_t> present(5, 1);
    EXPECT_THROW(simulate_batch(scene, Starts{states, {}}), std::invalid_argument);
    EXPECT_THROW(simulate_batch(scene, Starts{std::span(states).first(6), present}),
                 std::invalid_argument);
    scene.cue = Cue{.mass = -1};
    EXPECT_THROW(Batch{scene}, SceneError);
    scene.cue = Cue{.ball = "nobody"};
    EXPECT_THROW(Batch{scene}, SceneError);
    scene.cue.reset();
    scene.balls[0].id = "white";
    EXPECT_THROW(simulate_batch(scene, strikes), SceneError);
    scene.cue = Cue{.ball = "white", .speed = -1};  // which does not matter
    EXPECT_EQ(simulate_batch(scene, strikes).cue_ball[0], 0);
    scene.cue.reset();
    scene.motion = RollingMotion{};
    EXPECT_THROW(simulate_batch(scene, strikes), SceneError);
    scene.balls.clear();
    EXPECT_THROW(simulate_batch(scene, Starts{}), std::invalid_argument);
}

}  // namespace
}  // namespace osculo

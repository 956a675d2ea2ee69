#include "certify.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

constexpr double kAll = Certificate::kMostDigits;

/// Sixteen balls at random in a box, without friction: some ten digits are lost in a hundred
/// events.
Scene chaos(unsigned seed, std::uint64_t events) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Scene scene;
    test::add_box(scene, 5, 5);
    for (int i = 0; i < 16; ++i) {
        scene.balls.push_back(
            test::ball(std::string("b").append(std::to_string(i)),
                       {1.0 + i % 4 + 0.1 * uniform(), 1.0 + i / 4 + 0.1 * uniform()},
                       {uniform() - 0.5, uniform() - 0.5}, 0.3));
    }
    scene.limits.time = 1e6;
    scene.limits.events = events;
    return scene;
}

Certificate certificate_of(const Scene& scene, Precision precision = Precision::double_precision) {
    return simulate(scene, {precision, Record::events, false, true}).certificate.value();
}

TEST(Certify, AFewEventsAreCertain) {
    Scene scene;
    test::add_box(scene, 10, 4);
    scene.balls = {test::ball("a", {2, 2}, {1, 0.1}), test::ball("b", {5, 2.2})};
    scene.limits.time = 20;
    const Certificate certificate = certificate_of(scene);
    EXPECT_TRUE(certificate.certain());
    EXPECT_TRUE(certificate.conclusive);
    EXPECT_EQ(certificate.reference, "quad");
    EXPECT_EQ(certificate.first_uncertain, std::nullopt);
    EXPECT_EQ(certificate.first_out_of_order, std::nullopt);
    ASSERT_GT(certificate.events.size(), 4U);
    for (const auto& event : certificate.events) {
        EXPECT_TRUE(event.confirmed);
        EXPECT_GT(event.time, 14);
        EXPECT_GT(event.position, 14);
        EXPECT_GT(event.velocity, 14);
    }
    for (const auto& ball : certificate.balls)
        EXPECT_GT(std::min(ball.position, ball.velocity), 14);
}

// Held against a hundred digits, which know nothing of the certificate: what it says is true.
TEST(Certify, WhatIsCertifiedAgreesWithAHundredDigits) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Scene scene = chaos(seed, 320);
        const osculo::Run run =
            simulate(scene, {Precision::double_precision, Record::events, false, true});
        const Certificate& certificate = run.certificate.value();
        const osculo::Run exact = simulate(scene, {Precision::digits100, Record::events});
        ASSERT_TRUE(certificate.conclusive) << seed;
        ASSERT_TRUE(certificate.first_uncertain.has_value()) << seed;
        EXPECT_FALSE(certificate.certain());
        EXPECT_GT(*certificate.first_uncertain, 40U) << seed;
        double least = kAll;
        for (std::uint64_t i = 0; i < *certificate.first_out_of_order; ++i) {
            const Event& a = run.events[i];
            const Event& b = exact.events[i];
            ASSERT_EQ(a.kind, b.kind) << seed << ' ' << i;
            ASSERT_EQ(a.ball, b.ball) << seed << ' ' << i;
            ASSERT_EQ(a.other, b.other) << seed << ' ' << i;
            const auto& digits = certificate.events[i];
            const double error = std::abs((a.time - b.time) + (a.time_low - b.time_low));
            EXPECT_LE(error, 1.01 * b.time * std::pow(10, -digits.time)) << seed << ' ' << i;
            const double off = std::hypot(a.before[0].position.x - b.before[0].position.x,
                                          a.before[0].position.y - b.before[0].position.y);
            const double place = std::hypot(b.before[0].position.x, b.before[0].position.y);
            EXPECT_LE(off, 1.01 * place * std::pow(10, -digits.position)) << seed << ' ' << i;
            least = std::min(least, digits.time);
        }
        EXPECT_LT(least, 6) << "digits get lost: " << seed;
        // The run does go its own way there, or one of the first two does.
        bool same = true;
        const std::uint64_t last = *certificate.first_uncertain;
        for (std::uint64_t i = 0; i <= last; ++i) {
            same = same && run.events[i].kind == exact.events[i].kind &&
                   run.events[i].ball == exact.events[i].ball &&
                   run.events[i].other == exact.events[i].other;
        }
        EXPECT_FALSE(same) << seed;
    }
}

TEST(Certify, HigherPrecisionsHaveMoreToTrust) {
    const Scene scene = chaos(5, 300);
    const Certificate narrow = certificate_of(scene);
    const Certificate wide = certificate_of(scene, Precision::extended);
    ASSERT_TRUE(narrow.first_uncertain && wide.conclusive);
    EXPECT_GT(wide.first_uncertain.value_or(1000), *narrow.first_uncertain);
}

TEST(Certify, ALongRunOfChaosIsNotComputedToItsEnd) {
    const Certificate certificate = certificate_of(chaos(6, 30000));
    EXPECT_EQ(certificate.events.size(), 30000U);
    EXPECT_TRUE(certificate.conclusive);
    EXPECT_LT(certificate.first_uncertain.value(), 300U);
    for (const auto& ball : certificate.balls) EXPECT_FALSE(ball.confirmed);
}

TEST(Certify, NeedsAHigherPrecision) {
    const Scene scene = chaos(1, 10);
    EXPECT_THROW(static_cast<void>(certificate_of(scene, Precision::digits100)), SceneError);
    const Certificate certificate = certificate_of(scene, Precision::digits50);
    EXPECT_EQ(certificate.reference, "100");
    EXPECT_EQ(certificate.witness, "");
    EXPECT_FALSE(certificate.conclusive);
    EXPECT_FALSE(certificate.certain());
}

// Runs made by hand.
Event hit(double time, std::uint32_t ball, std::uint32_t other) {
    Event event;
    event.time = time;
    event.kind = EventKind::ball_ball;
    event.ball = ball;
    event.other = other;
    event.before[0].position = event.after[0].position = {1, 0};
    event.before[1].position = event.after[1].position = {1, 1};
    event.before[0].velocity = event.after[1].velocity = {2, 0};
    return event;
}

osculo::Run run_of(std::vector<Event> events) {
    osculo::Run run;
    run.scene.balls.resize(5);
    run.balls.resize(5);
    run.events = std::move(events);
    return run;
}

const osculo::Run kRun = run_of({hit(1, 0, 1), hit(2, 2, 3), hit(3, 1, 2), hit(4, 3, 4)});

TEST(Compare, EqualRunsAreCertain) {
    const Certificate certificate = facade::compare(kRun, kRun, &kRun);
    EXPECT_TRUE(certificate.certain());
    EXPECT_EQ(certificate.events[2], (Certificate::EventDigits{true, kAll, kAll, kAll}));
    EXPECT_EQ(certificate.balls[4], (Certificate::BallDigits{true, kAll, kAll}));
}

TEST(Compare, OrderOfIndependentEventsIsNoMatterForBalls) {
    const osculo::Run other =
        run_of({kRun.events[1], kRun.events[0], kRun.events[2], kRun.events[3]});
    const Certificate certificate = facade::compare(kRun, other, &other);
    EXPECT_TRUE(certificate.certain());
    EXPECT_EQ(certificate.first_uncertain, std::nullopt);
    EXPECT_EQ(certificate.first_out_of_order, 0U);
}

TEST(Compare, AnotherPartnerSpoilsWhatFollows) {
    // Ball 1 meets 3 instead of 2: balls 1, 2 and with its next event 3 and 4 are lost, 0 is not.
    const osculo::Run other =
        run_of({kRun.events[0], kRun.events[1], hit(3, 1, 3), kRun.events[3]});
    const Certificate certificate = facade::compare(kRun, other, &other);
    EXPECT_TRUE(certificate.conclusive);
    EXPECT_EQ(certificate.first_uncertain, 2U);
    EXPECT_EQ(certificate.first_out_of_order, 2U);
    for (const std::size_t i : {0U, 1U}) EXPECT_TRUE(certificate.events[i].confirmed) << i;
    for (const std::size_t i : {2U, 3U}) EXPECT_FALSE(certificate.events[i].confirmed) << i;
    EXPECT_TRUE(certificate.balls[0].confirmed);
    for (const std::size_t b : {1U, 2U, 3U, 4U}) {
        EXPECT_FALSE(certificate.balls[b].confirmed) << b;
    }
}

TEST(Compare, EventsMoreOrLessAndOtherFatesAreSeen) {
    osculo::Run shorter = kRun;
    shorter.events.pop_back();
    EXPECT_EQ(facade::compare(kRun, shorter, &kRun).first_uncertain, 3U);
    const Certificate more = facade::compare(shorter, kRun, &kRun);
    EXPECT_EQ(more.first_uncertain, std::nullopt);
    EXPECT_FALSE(more.balls[3].confirmed);
    EXPECT_TRUE(more.balls[2].confirmed);
    osculo::Run fallen = kRun;
    fallen.balls[1].fate = BallFate::captured;
    EXPECT_FALSE(facade::compare(kRun, fallen, &kRun).balls[1].confirmed);
    EXPECT_FALSE(facade::compare(kRun, fallen, &kRun).certain());
}

TEST(Compare, TheFewestDigitsCount) {
    osculo::Run near = kRun;
    near.events[2].time = 3 * (1 + 1e-9);
    near.events[2].after[1].velocity.x += 2e-7;
    near.balls[0].state.position = {0, 1e-4};  // of a ball with radius 1
    using Two = std::pair<const osculo::Run*, const osculo::Run*>;
    for (const auto& [reference, witness] : {Two{&near, &kRun}, Two{&kRun, &near}}) {
        const Certificate certificate = facade::compare(kRun, *reference, witness);
        EXPECT_TRUE(certificate.certain());
        EXPECT_NEAR(certificate.events[2].time, 9, 1e-5);
        EXPECT_NEAR(certificate.events[2].velocity, 7, 1e-5);
        EXPECT_EQ(certificate.events[2].position, kAll);
        EXPECT_NEAR(certificate.balls[0].position, 4, 1e-5);
    }
    osculo::Run lost = kRun;
    lost.events[0].time = std::nan("");
    lost.events[1].time = 0.5;
    const Certificate certificate = facade::compare(kRun, lost, &kRun);
    EXPECT_EQ(certificate.events[0].time, 0);
    EXPECT_EQ(certificate.events[1].time, 0);
}

TEST(Compare, AWitnessThatDisagreesIsSaid) {
    const osculo::Run other =
        run_of({kRun.events[0], kRun.events[1], hit(3, 1, 3), kRun.events[3]});
    const Certificate certificate = facade::compare(kRun, kRun, &other);
    EXPECT_FALSE(certificate.conclusive);
    EXPECT_FALSE(certificate.certain());
    EXPECT_EQ(certificate.first_uncertain, 2U);
    EXPECT_FALSE(facade::compare(kRun, kRun, nullptr).conclusive);
}

}  // namespace
}  // namespace osculo

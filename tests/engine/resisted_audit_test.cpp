#include <gtest/gtest.h>

#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"
#include "support/resisted_families.hpp"

namespace osculo::engine {
namespace {

using State = motion::Resisted::State<double>;
using Vec = math::Vec<double>;

State random_state(support::Random& random) {
    const auto coefficient = [&](double low, double high) {
        return random.below(3) == 0 ? 0.0 : std::pow(10.0, random.uniform<double>(low, high));
    };
    State state;
    state.velocity = random.direction<double>() * std::pow(10.0, random.uniform<double>(-6, 1));
    state.law = {coefficient(-3, 1), coefficient(-3, 2), coefficient(-3, 2)};
    motion::Resisted::begin<double>({}, state);
    return state;
}

TEST(ResistedAudit, WhatTheLawSaysIsAccepted) {
    support::Random random(20291);
    for (int round = 0; round < 20'000; ++round) {
        const State state = random_state(random);
        const double end = std::min(state.remaining, 60.0);
        const double t = random.coin() ? end : end * random.unit<double>();
        ASSERT_TRUE(obeys<double>({}, state, t)) << round;
    }
}

TEST(ResistedAudit, AtAnySpeed) {
    support::Random random(20295);
    const auto coefficient = [&] {
        return random.below(3) == 0 ? 0.0 : std::pow(10.0, random.uniform<double>(-20, 5));
    };
    for (int round = 0; round < 20'000; ++round) {
        State state;
        state.velocity =
            random.direction<double>() * std::pow(10.0, random.uniform<double>(-300, 140));
        state.law = {coefficient(), coefficient(), coefficient()};
        motion::Resisted::begin<double>({}, state);
        if (state.law.constant > 0 && std::isfinite(state.slowing.m)) {
            ASSERT_GT(state.remaining, 0);
        }
        const double end = std::min(state.remaining, 60.0);
        const double t = random.coin() ? end : end * random.unit<double>();
        ASSERT_TRUE(obeys<double>({}, state, t))
            << round << ": " << state.velocity.norm() << " m/s, " << state.law.constant << ' '
            << state.law.linear << ' ' << state.law.quadratic;
    }
}

TEST(ResistedAudit, WhatItDoesNotSayIsNot) {
    support::Random random(20292);
    for (int round = 0; round < 2'000; ++round) {
        State state = random_state(random);
        if (!(state.law.constant > 1e-3)) continue;
        const double t = state.remaining / 2;
        const State good = state;
        state.slowing.m *= 1 + 1e-13;
        EXPECT_FALSE(obeys<double>({}, state, t));
        state = good;
        state.slowing.k += 1e-12 * (1 + state.slowing.k);
        EXPECT_FALSE(obeys<double>({}, state, t));
        state = good;
        state.half_acceleration *= 1 + 1e-13;
        EXPECT_FALSE(obeys<double>({}, state, t));
        EXPECT_FALSE(obeys<double>({}, good, good.remaining * (1 + 1e-13)));
    }
}

/// The differential equation is followed to the closed forms' own error, and tells others apart.
TEST(ResistedAudit, TheEquationIsFollowed) {
    support::Random random(20293);
    for (int round = 0; round < 2'000; ++round) {
        const State state = random_state(random);
        const double t =
            std::min(state.remaining, 3 / state.slowing.rate(1)) * random.unit<double>();
        if (!(state.slowing.rate(1) > 0)) continue;
        double left = t;
        const auto by_steps = integrated<double>(state.slowing, left);
        const auto said = state.slowing.after(t);
        ASSERT_EQ(left, 0);
        ASSERT_NEAR(by_steps.sigma, said.sigma, 1e-14 * said.sigma);
        ASSERT_NEAR(by_steps.q, said.q, 1e-14);
    }
}

TEST(ResistedAudit, TheSmallestGapOfTwoIsFound) {
    support::Random random(20294);
    for (int round = 0; round < 600; ++round) {
        const auto family =
            static_cast<support::ResistedFamily>(random.below(support::kResistedFamilies));
        const auto pair = support::random_pair(family, round, random);
        const ResistedStretch<double> one{pair.first, pair.end};
        const ResistedStretch<double> other{pair.second, pair.end};
        const auto found =
            smallest_distance_beyond<double>(seen_from(one, other), math::Wide<double>(pair.reach));
        double least = 1e300;
        const int samples = 4000;
        for (int n = 0; n <= samples; ++n) {
            const double share = static_cast<double>(n) / samples;
            const double t = pair.end * share * share;
            const Vec apart =
                math::difference<double>(pair.first.at(t).position, pair.second.at(t).position);
            least = std::min(least, math::norm<double>(apart) - pair.reach);
        }
        ASSERT_LE(found.gap, least + 1e-14) << round;
        ASSERT_GE(found.gap, least - 0.02) << round;  // as far as they go between two samples
        const double when = math::narrow(found.t);
        const Vec apart =
            math::difference<double>(pair.first.at(when).position, pair.second.at(when).position);
        ASSERT_NEAR(math::norm<double>(apart) - pair.reach, found.gap, 1e-13) << round;
    }
}

}  // namespace
}  // namespace osculo::engine

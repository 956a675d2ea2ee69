#include <algorithm>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include "osculo/detect/ball_ball.hpp"
#include "osculo/detect/resisted.hpp"
#include "support/resisted_families.hpp"

// First contacts of balls with drag: none missed, none invented.
namespace osculo::detect {
namespace {

using Path = motion::ResistedPath<double>;
using Vec = math::Vec<double>;
using Exact = support::Digits50;
using support::ResistedFamily;

constexpr double kEps = 0x1p-52;
constexpr const char* kNames[] = {"billiard", "linear", "linear and rolling",
                                  "strong",   "stiff",  "chase"};

TEST(ResistedAccuracy, TwoMovingBalls) {
    for (int f = 0; f < support::kResistedFamilies; ++f) {
        support::Random random(20267 + static_cast<std::uint64_t>(f));
        int contacts = 0, misses = 0, undecided = 0;
        double worst = 0;
        std::vector<double> errors;
        for (int round = 0; round < 300; ++round) {
            const auto pair = support::random_pair(static_cast<ResistedFamily>(f), round, random);
            const Vec c = math::difference<double>(pair.first.position, pair.second.position);
            if (math::norm<double>(c) < pair.reach) continue;
            const double t =
                first_contact<double>(pair.first, pair.second, pair.reach, {}, pair.end);
            EXPECT_EQ(first_contact<double>(pair.second, pair.first, pair.reach, {}, pair.end), t);
            const auto meeting = support::first_meeting(pair, 400);
            // What rounding of the ways does to the gap, over the reach.
            const double way = math::norm1<double>(pair.first.velocity) * pair.first.longest +
                               math::norm1<double>(pair.second.velocity) * pair.second.longest;
            const double ways = std::min(way, 2 * pair.end * 16) + math::norm1<double>(c);
            const double blur = 2 * math::kPathNoise * kEps * (1 + ways / pair.reach);
            const bool found = math::is_finite<double>(t);
            if (found != meeting.time.has_value()) {
                ASSERT_LE(meeting.closest, blur) << kNames[f] << " round " << round << " " << t;
                ++undecided;
                continue;
            }
            ++(found ? contacts : misses);
            if (!found) continue;
            // The error of the gap: of the time, times the closing speed.
            const auto at = support::PairGap<Exact>(pair)(Exact(t));
            const double gap = std::abs(static_cast<double>(at.gap)) / (2 * pair.reach);
            ASSERT_LE(gap / pair.reach, blur) << kNames[f] << " round " << round;
            const double error =
                std::abs(static_cast<double>(Exact((Exact(t) - *meeting.time) / *meeting.time)));
            errors.push_back(error / kEps);
            worst = std::max(worst, gap / pair.reach);
        }
        std::sort(errors.begin(), errors.end());
        ASSERT_GT(contacts, 60) << kNames[f];
        ASSERT_GT(misses, 50) << kNames[f];
        EXPECT_LT(undecided, 4) << kNames[f];
        const double median = errors[errors.size() / 2];
        EXPECT_LT(median, 8) << kNames[f];
        std::cout << kNames[f] << ": " << contacts << " contacts, " << misses << " misses, "
                  << undecided << " undecided; median error " << median << " epsilon, 99 % "
                  << errors[errors.size() * 99 / 100] << "; largest gap " << worst
                  << " of the reach\n";
    }
}

/// Obstacles: against sigma of the straight path in 100 digits.
TEST(ResistedAccuracy, ObstaclesAreMetWhereAUniformBallMeetsThem) {
    support::Random random(20268);
    int contacts = 0;
    int too_far = 0;
    double worst = 0;
    for (int round = 0; round < 20000; ++round) {
        const auto family = static_cast<ResistedFamily>(random.below(support::kResistedFamilies));
        const Path path = support::resisted_path(
            Vec(0, 0), random.direction<double>() * random.uniform<double>(0.2, 8),
            support::random_resistance(family, random));
        const double radius = 0.1;
        const geometry::Point<double> point{
            Vec(2 * random.signed_unit<double>(), 2 * random.signed_unit<double>())};
        if (math::norm<double>(point.at) < radius) continue;
        const motion::LinearPath<double> line{path.position, path.velocity};
        const double never = math::never<double>();
        const double sigma = first_contact<double>(line, radius, point, {}, never);
        const double t = first_contact<double>(path, radius, point, {}, never);
        if (!(sigma < path.longest)) {
            ASSERT_EQ(t, never);
            if (math::is_finite<double>(sigma)) ++too_far;
            continue;
        }
        ASSERT_TRUE(t <= path.end);
        const motion::Slowing<Exact> law{Exact(path.slowing.m), Exact(path.slowing.k),
                                         Exact(path.slowing.c)};
        const auto there = law.after(Exact(t));
        const double error = std::abs(static_cast<double>(Exact(there.sigma - Exact(sigma))));
        worst = std::max(worst, error / sigma);
        // An error of the time is one of the way by the share of the speed that is left.
        const double allowed =
            2 * math::kPathNoise * kEps * (sigma + t * static_cast<double>(there.q));
        ASSERT_LE(error, allowed) << round;
        ++contacts;
    }
    EXPECT_GT(contacts, 300);
    EXPECT_GT(too_far, 100);
    EXPECT_GT(worst, 0.1 * kEps);
}

TEST(ResistedAccuracy, ABallThatStandsAndEqualLawsNeedNoSegments) {
    support::Random random(20269);
    for (int round = 0; round < 2000; ++round) {
        const motion::Resistance<double> law{0, random.uniform<double>(0.01, 2), 0};
        const Vec place(random.signed_unit<double>(), random.signed_unit<double>());
        const Path first = support::resisted_path(Vec(0, 0), random.direction<double>() * 2, law);
        const Path second = support::resisted_path(place, random.direction<double>() * 2, law);
        if (math::norm<double>(place) < 0.06) continue;
        const double exact = first_contact<double>(first, second, 0.06, {}, 20);
        // The same by segments.
        const CircleCrossing<BetweenPaths<double, Path, Path>> crossing{
            {first, second}, 0.06, false};
        const double t = detail::first_certified_contact<double>(crossing, 20.0, {}, 20.0);
        if (math::is_finite<double>(exact) && math::is_finite<double>(t)) {
            ASSERT_NEAR(t, exact, 1e-7 * exact);
        } else {
            ASSERT_TRUE(!(t < 20) && !(exact < 20)) << round;
        }
    }
}

TEST(ResistedAccuracy, WithoutDragItIsUniformMotion) {
    support::Random random(20270);
    int contacts = 0;
    for (int round = 0; round < 5000; ++round) {
        const Vec place(random.signed_unit<double>(), random.signed_unit<double>());
        if (math::norm<double>(place) < 0.1) continue;
        const Vec v1 = random.direction<double>();
        const Vec v2 = random.direction<double>() * 0.5;
        const Path first = support::resisted_path(Vec(0, 0), v1, {});
        const Path second = support::resisted_path(place, v2, {});
        const math::WidePoint<double> start{Vec(0, 0)};
        const double expected =
            first_contact<double>(motion::LinearPath<double>{start, v1},
                                  motion::LinearPath<double>{second.position, v2}, 0.1, {}, 100);
        ASSERT_EQ(first_contact<double>(first, second, 0.1, {}, 100), expected);
        if (math::is_finite<double>(expected)) ++contacts;
    }
    EXPECT_GT(contacts, 200);
}

/// Two balls side by side, as an inelastic impact leaves them, part by 1e-13 or close in by as
/// much: neither is settled by how long the segments can be that their jerks allow.
TEST(ResistedAccuracy, SideBySide) {
    const motion::Resistance<double> law{0.01, 1, 0.01};
    const double reach = 0.4;
    const Path first = support::resisted_path(Vec(0, 0), Vec(0.2, 0), law);
    for (const double gap : {1e-13, 1e-11}) {
        const Vec place(0, reach + gap);
        // A pass.
        EXPECT_EQ(
            first_contact<double>(first, support::resisted_path(place, Vec(0.2 + 5e-7, 1e-14), law),
                                  reach, {}, 10),
            math::never<double>());
        // A contact, by a closing speed that falls with e^-t, but for what 0.01 does.
        const double closing = 16 * gap;
        const Path second = support::resisted_path(place, Vec(0.2, -closing), law);
        const double t = first_contact<double>(first, second, reach, {}, 10);
        EXPECT_NEAR(t, first.slowing.time_of(gap / closing, 10), 2e-15 / closing + 1e-7 * t);
    }
}

}  // namespace
}  // namespace osculo::detect

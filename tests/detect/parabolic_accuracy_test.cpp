#include <gtest/gtest.h>

#include "osculo/detect/ball_arc_parabolic.hpp"
#include "osculo/detect/ball_ball.hpp"
#include "osculo/detect/ball_point.hpp"
#include "osculo/detect/ball_rim.hpp"
#include "osculo/detect/ball_segment_parabolic.hpp"
#include "support/curved_obstacle_families.hpp"
#include "support/exact_scalars.hpp"
#include "support/tally.hpp"

/// First contacts on curved paths against 100 digits; bench/parabolic_accuracy.cpp does the same
/// with millions of cases.
namespace {

using namespace osculo;
using namespace osculo::support;

/// For double; a tenth of it for long double.
template <class S>
constexpr int kCases = std::is_same_v<S, double> ? 1000 : 100;

/// The largest error there has been in millions of cases is 0.53 ulp.
constexpr double kWorst = 0.75;

template <class S>
class Parabolic : public testing::Test {};
TYPED_TEST_SUITE(Parabolic, BuiltinScalars, ScalarName);

/// [c] seen from [origin], without rounding.
template <class S>
math::WidePoint<S> placed(const math::Vec<S>& origin, const math::Vec<S>& c) {
    return {math::Wide<S>(math::two_sum(S(origin.x()), S(c.x()))),
            math::Wide<S>(math::two_sum(S(origin.y()), S(c.y())))};
}

/// Two balls whose relative motion is that of the case but for the rounding of their own.
template <class S>
struct Pair {
    motion::ParabolicPath<S> first;
    motion::ParabolicPath<S> second;
    ParabolicCase<S> seen;  ///< what detection gets to see: differences rounded once

    Pair(const ParabolicCase<S>& p, Random& random) : seen(p) {
        const math::Vec<S> place = random.direction<S>();
        const math::Vec<S> drift = random.direction<S>() * math::norm<S>(p.b);
        const math::Vec<S> pull = random.direction<S>() * math::norm<S>(p.a);
        first = {placed<S>(place, p.c), p.b + drift, p.a + pull, p.end};
        second = {math::WidePoint<S>(place), drift, pull, S(S(2) * p.end)};
        seen.b = first.velocity - second.velocity;
        seen.a = first.half_acceleration - second.half_acceleration;
    }
};

TYPED_TEST(Parabolic, TwoBallsMeetWhereTheDefinitionSays) {
    using S = TypeParam;
    for (const auto& family : kParabolicFamilies<S>) {
        SCOPED_TRACE(family.name);
        Random random(51);
        Tally tally;
        for (int i = 0; i < kCases<S>; ++i) {
            const Pair<S> pair(family.make(random), random);
            const auto reference = exact_entry<S>(pair.seen);
            if (reference && crosses_without_speed<S>(pair.seen, *reference)) continue;
            const S t = detect::first_contact<S>(pair.first, pair.second, pair.seen.s, {},
                                                 math::never<S>());
            ASSERT_TRUE(tally.add<S>(t, reference)) << bits<S>(pair.seen);
            EXPECT_EQ(t, detect::first_contact<S>(pair.second, pair.first, pair.seen.s, {},
                                                  math::never<S>()))
                << bits<S>(pair.seen);
        }
        EXPECT_LE(tally.quantile(0.999), 0.51);
        EXPECT_LE(tally.quantile(1), kWorst);
    }
}

/// A point, or a rim, is a ball of its own radius at rest.
TYPED_TEST(Parabolic, PointsAndRimsAreBallsAtRest) {
    using S = TypeParam;
    for (const auto& family : kParabolicFamilies<S>) {
        Random random(52);
        Tally tally;
        for (int i = 0; i < kCases<S>; ++i) {
            const ParabolicCase<S> p = family.make(random);
            const auto reference = exact_entry<S>(p);
            if (reference && crosses_without_speed<S>(p, *reference)) continue;
            const math::Vec<S> at(S(3), S(-7));
            const motion::ParabolicPath<S> path{placed<S>(at, p.c), p.b, p.a, p.end};
            const S t =
                detect::first_contact<S>(path, p.s, geometry::Point<S>{at}, {}, math::never<S>());
            ASSERT_TRUE(tally.add<S>(t, reference)) << family.name << " " << bits<S>(p);
            EXPECT_EQ(t, detect::first_contact<S>(path, S(1), geometry::Rim<S>{at, p.s}, {},
                                                  math::never<S>()));
        }
        EXPECT_LE(tally.quantile(1), kWorst) << family.name;
    }
}

TYPED_TEST(Parabolic, ACircleIsMetFromInsideWhereTheDefinitionSays) {
    using S = TypeParam;
    for (const auto& family : kParabolicFamilies<S>) {
        SCOPED_TRACE(family.name);
        Random random(53);
        Tally tally;
        for (int i = 0; i < kCases<S>; ++i) {
            const ParabolicCase<S> p = family.make(random);
            if (p.a.x() == S(0) && p.a.y() == S(0)) continue;
            const bool inside = math::norm<S>(p.c) <= p.s;
            const auto reference = exact_exit<S>(p, inside);
            if (reference && crosses_without_speed<S>(p, *reference)) continue;
            const math::ParabolicApproach<S> approach{p.c, p.b, p.a, p.s};
            ASSERT_TRUE(tally.add<S>(math::first_exit<S>(approach, p.end, inside), reference))
                << bits<S>(p) << (inside ? " inside" : " outside");
        }
        EXPECT_LE(tally.quantile(0.999), 0.51);
        EXPECT_LE(tally.quantile(1), kWorst);
    }
}

template <class S, class Make>
void expect_exact(Make make) {
    for (const CurvedTraits& family : kCurvedFamilies) {
        SCOPED_TRACE(family.name);
        Random random(54);
        Tally tally;
        for (int i = 0; i < kCases<S>; ++i) {
            const auto a = make(random, family);
            const auto reference = exact_contact<S>(a.path, a.radius, a.obstacle);
            if (reference.at_an_end) continue;
            const S t = detect::first_contact(a.path, a.radius, a.obstacle,
                                              math::ContactHistory<S>{}, math::never<S>());
            ASSERT_TRUE(tally.add<S>(t, reference.time)) << bits<S>(a);
        }
        EXPECT_GT(tally.contacts(), kCases<S> / 20);
        EXPECT_LE(tally.quantile(0.999), kWorst);
        EXPECT_LE(tally.quantile(1), kWorst);
    }
}
TYPED_TEST(Parabolic, SegmentsAreMetWhereTheDefinitionSays) {
    expect_exact<TypeParam>(curved_segment_case<TypeParam>);
}
TYPED_TEST(Parabolic, ArcsAreMetWhereTheDefinitionSays) {
    expect_exact<TypeParam>(curved_arc_case<TypeParam>);
}

/// Two that have just been resolved and approach all the same, by rounding or because they are
/// pulled together, meet when they have come nearer by kTouch epsilon.
TYPED_TEST(Parabolic, WhatHasJustBeenResolvedMeetsWhenItHasComeNoticeablyNearer) {
    using S = TypeParam;
    Random random(55);
    Tally tally;
    for (int i = 0; i < 4 * kCases<S>; ++i) {
        ParabolicCase<S> p = i % 2 == 0 ? approaching<S>(random) : pulled_back<S>(random);
        if (p.a.x() == S(0) && p.a.y() == S(0)) continue;
        const math::ParabolicApproach<S> approach{p.c, p.b, p.a, p.s};
        const S t = math::first_entry<S>(approach, p.end, math::ContactHistory<S>{true, S(0)});
        if (math::accurate_dot<S>(p.b, p.c) < S(0))
            p.s *= S(1) - S(math::kTouch) * math::epsilon<S>();
        ASSERT_TRUE(tally.add<S>(t, exact_entry<S>(p))) << bits<S>(p);
    }
    EXPECT_GT(tally.contacts(), kCases<S>);
    EXPECT_LE(tally.quantile(1), kWorst);
}

/// A ball that leaves an arc's circle through its opening and falls back on it from outside, and
/// one that comes in by the opening and meets it from inside.
TEST(ParabolicArc, IsMetFromOutsideAfterLeavingThroughTheOpening) {
    geometry::Arc<double> arc;
    arc.center = {0, 0};
    arc.radius = 1;
    arc.full = false;
    // Open to the left only.
    arc.start = {-0.8, -0.6};
    arc.end = {-0.8, 0.6};
    arc.reflex = true;
    const auto contact = [&](const math::Vec<double>& place, const math::Vec<double>& velocity,
                             const math::Vec<double>& half_acceleration) {
        const motion::ParabolicPath<double> path{math::WidePoint<double>(place), velocity,
                                                 half_acceleration, 100};
        const double t = detect::first_contact<double>(path, 0.1, arc, {}, 1000);
        const auto reference = exact_contact<double>(path, 0.1, arc);
        EXPECT_TRUE(reference.time);
        EXPECT_LE(error_in_ulp<double>(t, reference.time.value_or(0)), 1);
        return (place + t * (velocity + t * half_acceleration)).norm();
    };
    // Out to the left and up, back over the top.
    EXPECT_NEAR(1.1, contact({0, 0}, {-4, 0.385}, {1.6, 0}), 1e-12);
    // The same, first coming nearer to the centre.
    EXPECT_NEAR(1.1, contact({0.503, -0.0462}, {-4.384, 0.385}, {1.6, 0}), 1e-12);
    // In by the opening: met from inside.
    EXPECT_NEAR(0.9, contact({-3, 0.2}, {2, -0.1}, {0.1, 0}), 1e-12);
}

}  // namespace

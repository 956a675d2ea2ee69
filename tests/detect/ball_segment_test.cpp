#include "osculo/detect/ball_segment.hpp"

#include <gtest/gtest.h>

#include "osculo/detect/ball_point.hpp"
#include "support/exact_scalars.hpp"
#include "support/obstacle_families.hpp"
#include "support/tally.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCases = 10000;

template <class S>
S first_contact(const ObstacleCase<S, geometry::Segment<S>>& a) {
    return detect::first_contact<S>(a.path, a.radius, a.obstacle, {}, math::never<S>());
}

template <class S>
class BallSegment : public testing::Test {};
TYPED_TEST_SUITE(BallSegment, BuiltinScalars, ScalarName);

TYPED_TEST(BallSegment, AgreesWithTheDefinitionToOneUlp) {
    using S = TypeParam;
    for (const ObstacleTraits& family : kObstacleFamilies) {
        SCOPED_TRACE(family.name);
        Random random(31);
        Tally tally;
        for (int i = 0; i < kCases; ++i) {
            const auto a = segment_case<S>(random, family);
            const auto reference = exact_contact<S>(a.path, a.radius, a.obstacle);
            if (reference.at_an_end) continue;
            ASSERT_TRUE(tally.add<S>(first_contact<S>(a), reference.time)) << bits<S>(a);
        }
        EXPECT_GT(tally.contacts(), kCases / 100);
        EXPECT_LE(tally.quantile(1), 1.0);
    }
}

TYPED_TEST(BallSegment, NothingSlipsThroughBetweenTheSegmentAndItsEnds) {
    using S = TypeParam;
    Random random(32);
    constexpr ObstacleTraits kAtAnEnd{.name = "", .at_an_end = true};
    int both = 0;
    for (int i = 0; i < kCases; ++i) {
        auto a = segment_case<S>(random, kAtAnEnd);
        a.obstacle.one_sided = false;
        const math::Vec<S> ends[] = {a.obstacle.from,
                                     a.obstacle.from + a.obstacle.tangent * a.obstacle.length};
        S first = first_contact<S>(a);
        both += math::is_finite<S>(first);
        for (const auto& end : ends) {
            first =
                std::min(first, detect::first_contact<S>(a.path, a.radius, geometry::Point<S>{end},
                                                         {}, math::never<S>()));
        }
        // The distance from the segment as a whole has to reach the radius, and at that instant.
        using R = Exact;
        const ExactVec<R> c(rounded_difference<S, R>(a.path.position, a.obstacle.from));
        const ExactVec<R> v(a.path.velocity);
        const ExactVec<R> tangent(a.obstacle.tangent);
        const ExactVec<R> normal(a.obstacle.normal);
        const R length = exact<R>(a.obstacle.length);
        const auto distance = [&](const R& t) {
            const ExactVec<R> at = c.moved(v, t);
            const R foot = at.dot(tangent);
            const R beyond = foot < 0 ? foot : foot > length ? R(foot - length) : R(0);
            const R height = at.dot(normal);
            return R(sqrt(R(beyond * beyond + height * height)));
        };
        const R tolerance = 1e-14 * (c.norm() + length + exact<R>(a.radius));
        if (math::is_finite<S>(first)) {
            EXPECT_LE(abs(R(distance(exact<R>(first)) - exact<R>(a.radius))), tolerance)
                << bits<S>(a);
        } else {  // the closest the ball comes, by sampling around it
            const R closest = -c.dot(v) / v.dot(v);
            for (int k = -50; k <= 50; ++k) {
                const R t = closest * (1 + R(k) / 25);
                if (t > 0) {
                    EXPECT_GE(distance(t), exact<R>(a.radius) - tolerance) << bits<S>(a);
                }
            }
        }
    }
    EXPECT_GT(both, kCases / 10);
}

TYPED_TEST(BallSegment, ScalesWithPowersOfTwoBitForBit) {
    using S = TypeParam;
    Random random(33);
    for (const ObstacleTraits& family : kObstacleFamilies) {
        for (int i = 0; i < kCases / 10; ++i) {
            const auto a = segment_case<S>(random, family);
            const S length = power_of_two<S>(random.between(-150, 150));
            const S time = power_of_two<S>(random.between(-150, 150));
            auto b = a;
            const auto scaled = [&](const math::Wide<S>& x) {
                return math::Wide<S>(x.hi * length, x.lo * length);
            };
            b.path.position = {scaled(a.path.position.x), scaled(a.path.position.y)};
            b.path.velocity = a.path.velocity * length / time;
            b.radius *= length;
            b.obstacle = geometry::Segment<S>(
                a.obstacle.from * length,
                (a.obstacle.from + a.obstacle.tangent * a.obstacle.length) * length,
                a.obstacle.one_sided);
            auto same = a;
            same.obstacle = geometry::Segment<S>(
                a.obstacle.from, a.obstacle.from + a.obstacle.tangent * a.obstacle.length,
                a.obstacle.one_sided);
            EXPECT_EQ(S(first_contact<S>(same) * time), first_contact<S>(b)) << bits<S>(a);
        }
    }
}

TYPED_TEST(BallSegment, HorizonCullsNothingThatComesBeforeIt) {
    using S = TypeParam;
    Random random(34);
    for (int i = 0; i < kCases; ++i) {
        const auto a = segment_case<S>(random, kObstacleFamilies[static_cast<std::size_t>(i % 6)]);
        const S t = first_contact<S>(a);
        if (math::is_finite<S>(t)) {
            EXPECT_EQ(t, detect::first_contact<S>(a.path, a.radius, a.obstacle, {}, t))
                << bits<S>(a);
        }
    }
}

/// At the wall, in every direction, with every gap: contact at once if and only if approaching.
TYPED_TEST(BallSegment, AtTheWallOnlyTheDirectionCounts) {
    using S = TypeParam;
    const geometry::Segment<S> wall({S(-10), S(0)}, {S(10), S(0)}, true);
    for (const double gap : {0.0, -0.0, -1e-16, -1e-12, -1e-6}) {
        for (int k = 0; k < 64; ++k) {
            const double angle = k * 0.09817477042468103;  // 2 pi / 64
            math::Vec<S> v(S(std::cos(angle)), S(std::sin(angle)));
            if (k % 32 == 0) v.y() = S(0);
            const motion::LinearPath<S> path{math::WidePoint<S>(math::Vec<S>(S(0), S(1) + S(gap))),
                                             v};
            const S t = detect::first_contact<S>(path, S(1), wall, {}, math::never<S>());
            // Just back from the wall: not at once again, but before it sinks in noticeably.
            const S again =
                detect::first_contact<S>(path, S(1), wall, {true, S(0)}, math::never<S>());
            if (v.y() < S(0)) {
                EXPECT_EQ(S(0), t) << k;
                EXPECT_GT(again, S(0)) << k;
                EXPECT_LE(again * -v.y(), S(math::kTouch + 1) * math::epsilon<S>()) << k;
            } else {
                EXPECT_FALSE(math::is_finite<S>(t)) << k;
                EXPECT_FALSE(math::is_finite<S>(again)) << k;
            }
        }
    }
}

TEST(BallSegment, OneSidedSegmentsLetPassFromBehind) {
    const geometry::Segment<double> wall({0, 0}, {4, 0}, true);
    const geometry::Segment<double> both({0, 0}, {4, 0}, false);
    const motion::LinearPath<double> up{math::WidePoint<double>(math::Vec<double>(2, -3)), {0, 1}};
    EXPECT_FALSE(math::is_finite(detect::first_contact<double>(up, 1.0, wall, {}, 1e9)));
    EXPECT_EQ(2.0, detect::first_contact<double>(up, 1.0, both, {}, 1e9));
    const motion::LinearPath<double> down{math::WidePoint<double>(math::Vec<double>(2, 3)),
                                          {0, -1}};
    EXPECT_EQ(2.0, detect::first_contact<double>(down, 1.0, wall, {}, 1e9));
    EXPECT_EQ(2.0, detect::first_contact<double>(down, 1.0, both, {}, 1e9));
    // Beside the ends.
    const motion::LinearPath<double> beside{math::WidePoint<double>(math::Vec<double>(4.5, 3)),
                                            {0, -1}};
    EXPECT_FALSE(math::is_finite(detect::first_contact<double>(beside, 1.0, wall, {}, 1e9)));
}

}  // namespace

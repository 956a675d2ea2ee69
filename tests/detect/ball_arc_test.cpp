#include "osculo/detect/ball_arc.hpp"

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
using ArcCase = ObstacleCase<S, geometry::Arc<S>>;

template <class S>
S first_contact(const ArcCase<S>& a) {
    return detect::first_contact<S>(a.path, a.radius, a.obstacle, {}, math::never<S>());
}

template <class S>
class BallArc : public testing::Test {};
TYPED_TEST_SUITE(BallArc, BuiltinScalars, ScalarName);

TYPED_TEST(BallArc, AgreesWithTheDefinitionToOneUlp) {
    using S = TypeParam;
    for (const ObstacleTraits& family : kObstacleFamilies) {
        SCOPED_TRACE(family.name);
        Random random(71);
        Tally tally;
        for (int i = 0; i < kCases; ++i) {
            const auto a = arc_case<S>(random, family);
            const auto reference = exact_contact<S>(a.path, a.radius, a.obstacle);
            if (reference.at_an_end) continue;
            ASSERT_TRUE(tally.add<S>(first_contact<S>(a), reference.time)) << bits<S>(a);
        }
        EXPECT_GT(tally.contacts(), kCases / 100);
        EXPECT_LE(tally.quantile(1), 1.0);
    }
}

/// Distance from the ball's centre to the arc with its ends.
double distance(const geometry::Arc<double>& arc, const math::Vec<double>& at) {
    const math::Vec<double> d = at - arc.center;
    if (arc.covers(d)) return std::abs(d.norm() - arc.radius);
    return std::min((at - arc.start_point()).norm(), (at - arc.end_point()).norm());
}

/// The whole obstacle (arc and end points) against its definition as a set of points, by stepping
/// along the path no further than the distance allows: no case analysis at all.
TEST(BallArc, WithItsEndsIsMetWhereTheDistanceFirstFallsToTheRadius) {
    Random random(72);
    int met = 0;
    int from_inside = 0;
    int small = 0;
    for (int i = 0; i < kCases; ++i) {
        const ObstacleTraits& family = i % 3 == 0 ? kObstacleFamilies[4] : kObstacleFamilies[0];
        const ArcCase<double> a = arc_case<double>(random, family);
        const math::Vec<double> start = a.path.position.rounded();
        const math::Vec<double> v = a.path.velocity;
        if (!(distance(a.obstacle, start) > a.radius * (1 + 1e-9))) continue;

        double computed = first_contact<double>(a);
        const bool by_the_arc = math::is_finite(computed);
        if (!a.obstacle.full) {
            for (const auto& end : {a.obstacle.start_point(), a.obstacle.end_point()}) {
                computed = std::min(computed, detect::first_contact<double>(
                                                  a.path, a.radius, geometry::Point<double>{end},
                                                  {}, math::never<double>()));
            }
        }
        // The gap changes no faster than the ball moves: a step of gap / speed passes nothing.
        const double speed = v.norm();
        const double tiny = 1e-11 * a.obstacle.radius;
        const double reach = (start - a.obstacle.center).norm() + a.obstacle.radius + a.radius;
        double t = 0;
        double gap = 0;
        int steps = 0;
        do {
            gap = distance(a.obstacle, start + v * t) - a.radius;
            t += std::max(gap, 0.0) / speed;
        } while (gap > tiny && t * speed < 3 * reach && ++steps < 100000);
        if (gap > tiny) {
            // A graze within the tolerance is all that may be found.
            if (math::is_finite(computed)) {
                EXPECT_LT(distance(a.obstacle, start + v * computed) - a.radius, 2 * tiny)
                    << bits<double>(a);
                const double later = computed + 1e-3 * reach / speed;
                EXPECT_GT(distance(a.obstacle, start + v * later) - a.radius, -1e-4 * reach)
                    << bits<double>(a);
            }
            continue;
        }
        if (!math::is_finite(computed)) {  // it came near without touching
            const double later = t + 1e-5 * a.obstacle.radius / speed;
            EXPECT_GT(distance(a.obstacle, start + v * later) - a.radius, -tiny) << bits<double>(a);
            continue;
        }
        ++met;
        from_inside += by_the_arc && (start - a.obstacle.center).norm() < a.obstacle.radius;
        small += a.radius > a.obstacle.radius;
        EXPECT_GE(computed * speed, (t * speed) - 1e-12 * reach) << bits<double>(a);
        // From there to the contact the gap stays within the tolerance: nothing else was hit
        // before.
        for (int k = 0; k <= 20; ++k) {
            const double between = t + (computed - t) * k / 20;
            EXPECT_LT(std::abs(distance(a.obstacle, start + v * between) - a.radius), 2 * tiny)
                << bits<double>(a);
        }
    }
    EXPECT_GT(met, kCases / 4);
    EXPECT_GT(from_inside, kCases / 100);
    EXPECT_GT(small, kCases / 100);
}

TEST(BallArc, ThroughTheOpeningAndAgainstTheInside) {
    // A circle with an opening around the direction of +x; the ball comes in from there.
    geometry::Arc<double> arc{{0, 0}, 10, {0.8, 0.6}, {0.8, -0.6}, true, false};
    const motion::LinearPath<double> in{math::WidePoint<double>(math::Vec<double>(30, 0)), {-1, 0}};
    const auto contact = [&](const motion::LinearPath<double>& path, double radius) {
        return detect::first_contact<double>(path, radius, arc, {}, math::never<double>());
    };
    EXPECT_EQ(39.0, contact(in, 1));
    // Above the opening: from outside.
    const motion::LinearPath<double> above{math::WidePoint<double>(math::Vec<double>(30, 8.8)),
                                           {-1, 0}};
    EXPECT_DOUBLE_EQ(30 - std::sqrt(121 - 8.8 * 8.8), contact(above, 1));
    // From the centre out through the opening.
    const motion::LinearPath<double> out{math::WidePoint<double>(math::Vec<double>(0, 0)), {1, 0}};
    EXPECT_FALSE(math::is_finite(contact(out, 1)));
    // From the centre against the inside; a ball larger than the circle cannot be there.
    const motion::LinearPath<double> back{math::WidePoint<double>(math::Vec<double>(0, 0)),
                                          {-2, 0}};
    EXPECT_EQ(4.5, contact(back, 1));
    EXPECT_FALSE(math::is_finite(contact(in, 10.5)));
    // A full circle has no way in.
    arc.full = true;
    EXPECT_EQ(19.0, contact(in, 1));
    EXPECT_EQ(4.5, contact(back, 1));
}

TYPED_TEST(BallArc, HorizonCullsNothingThatComesBeforeIt) {
    using S = TypeParam;
    Random random(73);
    for (int i = 0; i < kCases; ++i) {
        const auto a = arc_case<S>(random, kObstacleFamilies[static_cast<std::size_t>(i % 6)]);
        const S t = first_contact<S>(a);
        if (math::is_finite<S>(t)) {
            EXPECT_EQ(t, detect::first_contact<S>(a.path, a.radius, a.obstacle, {}, t))
                << bits<S>(a);
        }
    }
}

}  // namespace

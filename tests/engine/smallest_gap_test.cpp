#include "osculo/engine/audit/smallest_gap.hpp"

#include <gtest/gtest.h>

#include "support/random_arc.hpp"

// The closed forms of the audit against what brute sampling of the same path finds.
namespace osculo::engine {
namespace {

using support::Random;
using Vec = math::Vec<double>;
using Path = RelativePath<double>;

Path random_path(Random& random) {
    const Vec start(random.uniform<double>(-4, 4), random.uniform<double>(-4, 4));
    const Vec velocity = random.uniform<double>(0, 3) * random.direction<double>();
    return {math::WidePoint<double>(start), math::WidePoint<double>(velocity),
            random.uniform<double>(0, 4)};
}

/// The smallest of gap(x) along the path, from samples, where there is one.
template <class Gap>
double sampled(const Path& path, Gap gap) {
    constexpr int kSamples = 4000;
    double smallest = math::never<double>();
    for (int k = 0; k <= kSamples; ++k) {
        smallest = std::min(
            smallest, gap(path.at(path.time * math::Wide<double>(double(k) / kSamples)).rounded()));
    }
    return smallest;
}

/// What lies between two samples is at most this far from one of them.
double step(const Path& path) {
    return math::norm<double>(path.velocity.rounded()) * path.time.hi / 4000;
}

void expect_same(const GapAt<double>& found, double expected, const Path& path, int seed) {
    if (std::isinf(expected)) return;  // the stretch may be shorter than a step
    EXPECT_LE(found.gap, expected + 1e-14) << "seed " << seed;
    EXPECT_GE(found.gap, expected - step(path)) << "seed " << seed;
    EXPECT_GE(found.t.hi, 0) << "seed " << seed;
    EXPECT_LE(found.t.hi, path.time.hi) << "seed " << seed;
}

TEST(SmallestGap, OfAPoint) {
    for (int seed = 0; seed < 2000; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const geometry::Point<double> point{Vec(0, 0)};
        expect_same(smallest_gap(path, 0.5, point),
                    sampled(path, [](const Vec& x) { return math::norm<double>(x) - 0.5; }), path,
                    seed);
    }
}

TEST(SmallestGap, OfASegment) {
    for (int seed = 0; seed < 2000; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const geometry::Segment<double> segment(
            Vec(0, 0), random.uniform<double>(0.5, 5) * random.direction<double>(), false);
        bool behind = false;
        bool in_front = false;
        const double expected = sampled(path, [&](const Vec& x) {
            const double foot = math::dot<double>(x, segment.tangent);
            if (foot < 0 || foot > segment.length) return math::never<double>();
            const double distance = math::dot<double>(x, segment.normal);
            (distance < 0 ? behind : in_front) = true;
            return std::abs(distance) - 0.5;
        });
        const GapAt<double> found = smallest_gap(path, 0.5, segment);
        if (behind && in_front) {
            EXPECT_EQ(found.gap, -0.5) << "seed " << seed;
        } else {
            expect_same(found, expected, path, seed);
        }
    }
}

TEST(SmallestGap, OfAOneSidedSegmentCountsOnTheWayIn) {
    const geometry::Segment<double> segment(Vec(0, 0), Vec(10, 0), true);  // its front is above
    const auto gap = [&](const Vec& from, const Vec& to) {
        const Path path{math::WidePoint<double>(from), math::WidePoint<double>(Vec(to - from)),
                        1.0};
        return smallest_gap(path, 1.0, segment).gap;
    };
    EXPECT_EQ(gap({5, 3}, {6, 2}), 1);  // near
    EXPECT_EQ(gap({5, 2}, {5, 0.75}), -0.25);
    EXPECT_EQ(gap({5, 2}, {5, -2}), -3);                     // through
    EXPECT_EQ(gap({5, 1}, {6, 1}), 0);                       // along
    EXPECT_EQ(gap({5, 1}, {6, 2}), 0);                       // away
    EXPECT_TRUE(std::isinf(gap({5, -2}, {5, 2})));           // from behind
    EXPECT_TRUE(std::isinf(gap({5, 0.5}, {5, 0.75})));       // on the way out
    EXPECT_TRUE(std::isinf(gap({5, 1 - 0x1p-30}, {5, 2})));  // all but out
    EXPECT_EQ(gap({5, 0.75}, {5, 0.5}), -0.5);               // and in again
    EXPECT_EQ(gap({5, 1 - 0x1p-30}, {5, 1 - 0x1p-29}), -0x1p-29);
    EXPECT_TRUE(std::isinf(gap({5, 0.5}, {5, 0.5 - 0x1p-53})));  // it rests there, but for rounding
    EXPECT_TRUE(std::isinf(gap({5, -2}, {5, -1})));
    EXPECT_TRUE(std::isinf(gap({-5, 2}, {-1, 0})));  // beside
    EXPECT_EQ(gap({-2, 4}, {2, 0}), 0.0 - 1.0);      // ends on the line
}

TEST(SmallestGap, OfAnArc) {
    for (int seed = 0; seed < 4000; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const geometry::Arc<double> arc = support::random_arc(random, 8);
        const double expected = sampled(path, [&](const Vec& x) {
            return arc.covers(x) ? std::abs(math::norm<double>(x) - arc.radius) - 0.5
                                 : math::never<double>();
        });
        expect_same(smallest_gap(path, 0.5, arc), expected, path, seed);
    }
}

TEST(SmallestGap, OfARimIsHowFarABallWentInside) {
    const geometry::Rim<double> rim{Vec(0, 0), 1};
    const auto gap = [&](const Vec& from, const Vec& to) {
        const Path path{math::WidePoint<double>(from), math::WidePoint<double>(Vec(to - from)),
                        1.0};
        return smallest_gap(path, 1.0, rim).gap;
    };
    EXPECT_TRUE(std::isinf(gap({3, 0}, {2, 0})));
    EXPECT_TRUE(std::isinf(gap({-3, 1.5}, {3, 1.5})));
    EXPECT_NEAR(gap({-3, 0.5}, {3, 0.5}), -0.5, 1e-15);
    EXPECT_NEAR(gap({0.5, 0}, {0.25, 0}), -0.25, 1e-15);  // deeper than its start
    EXPECT_TRUE(std::isinf(gap({0.5, 0}, {0.75, 0})));    // out again
}

TEST(SmallestGap, IsMeasuredFarBelowTheRoundingOfItsCoordinates) {
    // Two paths of 1e8 m whose closest distance is 1 + 2^-60.
    const math::WidePoint<double> start{math::Wide<double>(-1e8), math::Wide<double>(1, 0x1p-60)};
    const Path path{start, math::WidePoint<double>(Vec(1e7, 0)), 20.0};
    EXPECT_DOUBLE_EQ(smallest_distance_beyond<double>(path, 1.0).gap, 0x1p-60);
}

TEST(ContactGap, IsTheDistanceToTheWholeObstacle) {
    const auto at = [](double x, double y) { return math::WidePoint<double>(Vec(x, y)); };
    const geometry::Segment<double> segment(Vec(0, 0), Vec(10, 0), true);
    EXPECT_EQ(contact_gap(at(5, 3), 1.0, segment), 2);
    EXPECT_EQ(contact_gap(at(5, -3), 1.0, segment), 2);
    EXPECT_EQ(contact_gap(at(-3, 4), 1.0, segment), 4);
    EXPECT_EQ(contact_gap(at(13, 4), 1.0, segment), 4);
    const geometry::Arc<double> arc{Vec(0, 0), 5, Vec(1, 0), Vec(0, 1), false, false};
    EXPECT_EQ(contact_gap(at(0, 8), 1.0, arc), 2);
    EXPECT_EQ(contact_gap(at(1.5, 2), 1.0, arc), 1.5);
    EXPECT_EQ(contact_gap(at(8, -4), 1.0, arc), 4);  // its first end
    EXPECT_EQ(contact_gap(at(-4, 2), 1.0, arc), 4);  // its last end
    EXPECT_EQ(contact_gap(at(3, 4), 1.0, geometry::Rim<double>{Vec(0, 0), 2}), 3);
}

}  // namespace
}  // namespace osculo::engine

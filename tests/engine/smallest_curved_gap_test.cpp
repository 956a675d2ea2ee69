#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "osculo/engine/audit/smallest_gap_parabolic.hpp"
#include "support/random_arc.hpp"

// The audit's smallest gaps of curved paths: against closed forms, against brute sampling of the
// same path in 50 digits, and against those of straight paths.
namespace osculo::engine {
namespace {

using support::Random;
using Vec = math::Vec<double>;
using Wide = math::Wide<double>;
using Path = RelativeParabola<double>;
using Exact = boost::multiprecision::cpp_bin_float_50;

Path parabola(const Vec& start, const Vec& velocity, const Vec& half_acceleration, double time) {
    return {math::WidePoint<double>(start), math::WidePoint<double>(velocity),
            math::WidePoint<double>(half_acceleration), Wide(time)};
}

/// Paths of all kinds: turning back, grazing the origin's surroundings, straight, at rest.
Path random_path(Random& random) {
    const auto some = [&](double most) {
        return random.below(8) == 0
                   ? Vec(0, 0)
                   : Vec(random.uniform<double>(0, most) * random.direction<double>());
    };
    const Vec start(random.uniform<double>(-4, 4), random.uniform<double>(-4, 4));
    const Vec velocity = some(4);
    // Often against the velocity, as friction is.
    const Vec acceleration =
        random.coin() ? some(2) : Vec(-random.uniform<double>(0, 1) * velocity);
    return parabola(start, velocity, acceleration, random.uniform<double>(0, 4));
}

struct ExactPlace {
    Exact x, y;
};
ExactPlace exact_at(const Path& path, const Exact& t) {
    const auto coordinate = [&](const Wide& p, const Wide& v, const Wide& a) {
        const auto exact = [](const Wide& w) { return Exact(w.hi) + Exact(w.lo); };
        return Exact(exact(p) + t * (exact(v) + t * exact(a)));
    };
    return {coordinate(path.start.x, path.velocity.x, path.half_acceleration.x),
            coordinate(path.start.y, path.velocity.y, path.half_acceleration.y)};
}
double exact_length(const Path& path, const Exact& t) {
    const ExactPlace p = exact_at(path, t);
    return static_cast<double>(sqrt(Exact(p.x * p.x + p.y * p.y)));
}

/// The smallest of gap(t) for times from 0 to 1: samples, and golden sections around those that are
/// smaller than their neighbours.
template <class Gap>
double brute(const Path& path, Gap gap) {
    constexpr int kSamples = 200;
    const Exact whole = Exact(path.time.hi) + Exact(path.time.lo);
    std::vector<double> samples;
    for (int k = 0; k <= kSamples; ++k) samples.push_back(gap(Exact(whole * k / kSamples)));
    double smallest = math::never<double>();
    for (std::size_t k = 0; k <= kSamples; ++k) {
        smallest = std::min(smallest, samples[k]);
        const std::size_t before = k == 0 ? 0 : k - 1;
        const std::size_t after = std::min<std::size_t>(k + 1, kSamples);
        const bool higher = samples[k] > samples[before] || samples[k] > samples[after];
        if (higher || std::isinf(samples[k])) continue;
        Exact low = whole * before / kSamples;
        Exact high = whole * after / kSamples;
        for (int i = 0; i < 50; ++i) {  // far enough: a minimum is flat
            const Exact third = (high - low) / 3;
            const Exact first = low + third;
            const Exact last = high - third;
            if (gap(first) < gap(last)) {
                high = last;
            } else {
                low = first;
            }
        }
        smallest = std::min(smallest, gap(low));
    }
    return smallest;
}

void expect_on_path(const GapAt<double>& found, const Path& path, int seed) {
    if (std::isinf(found.gap)) return;
    EXPECT_GE(found.t.hi, 0) << "seed " << seed;
    EXPECT_LE(found.t.hi, path.time.hi) << "seed " << seed;
}

TEST(SmallestCurvedGap, OfAPointIsExact) {
    for (int seed = 0; seed < 400; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const GapAt<double> found = smallest_distance_beyond<double>(path, Wide(0.5));
        expect_on_path(found, path, seed);
        const double expected = brute(path, [&](const Exact& t) { return exact_length(path, t); });
        EXPECT_NEAR(found.gap, expected - 0.5, 2e-15) << "seed " << seed;
    }
}

TEST(SmallestCurvedGap, OfAPointAtATurningPoint) {
    // x = 1 - (t - 2)^2 touches the line x = 1 from the left at t = 2; |x - 2| = 1 there.
    const Path back = parabola({-3, 0}, {4, 0}, {-1, 0}, 10);
    EXPECT_NEAR(smallest_distance_beyond<double>(back, Wide(0.5)).gap, -0.5, 1e-15);
    const Path past = parabola({-3, 0.75}, {4, 0}, {-1, 0}, 2);
    EXPECT_EQ(smallest_distance_beyond<double>(past, Wide(0.5)).gap, 0.25);
    // (t, t^2 - 1): |x|^2 = t^4 - t^2 + 1 is smallest at t^2 = 1/2, twice.
    const Path bowl = parabola({-2, 3}, {1, -4}, {0, 1}, 4);
    const GapAt<double> found = smallest_distance_beyond<double>(bowl, Wide(0));
    EXPECT_DOUBLE_EQ(found.gap, std::sqrt(0.75));
    EXPECT_NEAR(std::abs(found.t.hi - 2), std::sqrt(0.5), 1e-15);
}

TEST(SmallestCurvedGap, IsMeasuredFarBelowTheRoundingOfItsCoordinates) {
    // A vertex 1 + 2^-60 from the origin, on a path of 4e8 m.
    const math::WidePoint<double> start{Wide(-1e8), Wide(1e8 + 1, 0x1p-60)};
    const Path path{start, math::WidePoint<double>(Vec(1e4, -2e4)),
                    math::WidePoint<double>(Vec(0, 1)), Wide(2e4)};
    EXPECT_DOUBLE_EQ(smallest_distance_beyond<double>(path, Wide(1.0)).gap, 0x1p-60);
}

TEST(SmallestCurvedGap, OfASegment) {
    for (int seed = 0; seed < 400; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const geometry::Segment<double> segment(
            Vec(0, 0), random.uniform<double>(0.5, 5) * random.direction<double>(), false);
        bool behind = false;
        bool in_front = false;
        const double expected = brute(path, [&](const Exact& t) {
            const ExactPlace p = exact_at(path, t);
            const Exact foot = p.x * segment.tangent.x() + p.y * segment.tangent.y();
            if (foot < 0 || foot > segment.length) return math::never<double>();
            const Exact distance = p.x * segment.normal.x() + p.y * segment.normal.y();
            (distance < 0 ? behind : in_front) = true;
            return static_cast<double>(Exact(abs(distance) - 0.5));
        });
        const GapAt<double> found = smallest_gap(path, 0.5, segment);
        expect_on_path(found, path, seed);
        if (behind && in_front) {
            // Through the line, or around the end of the segment.
            EXPECT_LE(found.gap, expected + 2e-15) << "seed " << seed;
        } else if (std::isfinite(expected)) {
            // Where the foot passes an end, the samples stop up to a step before it.
            EXPECT_LE(found.gap, expected + 2e-15) << "seed " << seed;
            const double step = path.time.hi / 200;
            const double fastest = path.velocity.rounded().norm() +
                                   2 * path.time.hi * path.half_acceleration.rounded().norm();
            EXPECT_GE(found.gap, expected - step * fastest - 1e-14) << "seed " << seed;
        }
    }
}

TEST(SmallestCurvedGap, OfASegmentAtTheTurningPoint) {
    const geometry::Segment<double> segment(Vec(0, 0), Vec(10, 0), false);
    const geometry::Segment<double> front(Vec(0, 0), Vec(10, 0), true);
    // Down to y = 0.75 at t = 1 and up again; the foot stays on the segment.
    const Path dip = parabola({5, 2}, {0.5, -2.5}, {0, 1.25}, 3);
    EXPECT_DOUBLE_EQ(smallest_gap(dip, 1.0, segment).gap, -0.25);
    EXPECT_DOUBLE_EQ(smallest_gap(dip, 1.0, front).gap, -0.25);
    EXPECT_DOUBLE_EQ(smallest_gap(dip, 1.0, front).t.hi, 1);
    // The same from behind: up to -0.75.
    const Path rise = parabola({5, -2}, {0.5, 2.5}, {0, -1.25}, 3);
    EXPECT_DOUBLE_EQ(smallest_gap(rise, 1.0, segment).gap, -0.25);
    EXPECT_TRUE(std::isinf(smallest_gap(rise, 1.0, front).gap));
    // Out from behind, and then in again: what counts is the way back.
    const Path over = parabola({5, -2}, {0.5, 4}, {0, -1}, 3.5);
    EXPECT_DOUBLE_EQ(smallest_gap(over, 1.0, front).gap, -2 + 4 * 3.5 - 3.5 * 3.5 - 1);
    EXPECT_EQ(smallest_gap(over, 1.0, segment).gap, -1);
    // Out from behind but for a part of it, and back.
    const Path peep = parabola({5, -2}, {0.5, std::sqrt(10.0)}, {0, -1}, 3);  // up to y = 0.5
    EXPECT_TRUE(std::isinf(smallest_gap(peep, 1.0, front).gap));
    EXPECT_EQ(smallest_gap(peep, 1.0, segment).gap, -1);
    // Beside it, over an end and out again: only the time over the segment counts.
    const Path visit = parabola({-3, 3}, {4, -1}, {-1, 0}, 4);  // x = 1 - (t - 2)^2, y = 3 - t
    EXPECT_DOUBLE_EQ(smallest_gap(visit, 1.0, segment).gap, -1);
    const Path brief = parabola({-3, 5}, {4, -1}, {-1, 0}, 4);  // foot at an end at t = 1 and 3
    EXPECT_DOUBLE_EQ(smallest_gap(brief, 1.0, segment).gap, 1);
    EXPECT_TRUE(std::isinf(smallest_gap(parabola({-3, 3}, {2, 0}, {-1, 0}, 4), 1.0, segment).gap));
}

TEST(SmallestCurvedGap, OfAnArc) {
    for (int seed = 0; seed < 400; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Path path = random_path(random);
        const geometry::Arc<double> arc = support::random_arc(random, 4);
        const double expected = brute(path, [&](const Exact& t) {
            const ExactPlace p = exact_at(path, t);
            if (!arc.covers(Vec(static_cast<double>(p.x), static_cast<double>(p.y)))) {
                return math::never<double>();
            }
            return std::abs(exact_length(path, t) - arc.radius) - 0.5;
        });
        const GapAt<double> found = smallest_gap(path, 0.5, arc);
        expect_on_path(found, path, seed);
        if (std::isinf(expected)) continue;
        EXPECT_LE(found.gap, expected + 4e-15) << "seed " << seed;
        if (arc.full) {
            EXPECT_NEAR(found.gap, expected, 1e-9) << "seed " << seed;  // |..| has no derivative
            if (expected > -0.499) {
                EXPECT_NEAR(found.gap, expected, 4e-15) << "seed " << seed;
            }
        } else {
            const double step = path.time.hi / 200;
            const double fastest = path.velocity.rounded().norm() +
                                   2 * path.time.hi * path.half_acceleration.rounded().norm();
            EXPECT_GE(found.gap, expected - step * fastest - 1e-14) << "seed " << seed;
        }
    }
}

TEST(SmallestCurvedGap, OfARimIsHowFarABallWentInside) {
    const geometry::Rim<double> rim{Vec(0, 0), 1};
    const auto gap = [&](const Vec& start, const Vec& v, const Vec& a, double time) {
        return smallest_gap(parabola(start, v, a, time), 1.0, rim).gap;
    };
    EXPECT_TRUE(std::isinf(gap({3, 0}, {-2, 0}, {0.5, 0}, 4)));          // to x = 1 and back
    EXPECT_NEAR(gap({3, 0}, {-2.25, 0}, {0.5, 0}, 4), -0.53125, 1e-15);  // to x = 0.46875
    EXPECT_NEAR(gap({3, 0.5}, {-6, 0}, {2, 0}, 3), -0.5, 1e-15);         // through, and back again
    EXPECT_NEAR(gap({0.5, 0}, {-0.5, 0}, {0.5, 0}, 1), -0.125, 1e-15);   // deeper than its start
    EXPECT_TRUE(std::isinf(gap({0.5, 0}, {0.5, 0}, {-0.25, 0}, 2)));     // not deeper
    EXPECT_NEAR(gap({0.5, 0}, {2, 0}, {-1, 0}, 2), -0.5, 1e-15);         // out, and in again
}

TEST(SmallestCurvedGap, OfAStraightPathIsThatOfUniformMotion) {
    for (int seed = 0; seed < 4000; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Vec start(random.uniform<double>(-4, 4), random.uniform<double>(-4, 4));
        const Vec v = random.uniform<double>(0, 3) * random.direction<double>();
        const double time = random.uniform<double>(0, 4);
        const Path path = parabola(start, v, {0, 0}, time);
        const RelativePath<double> straight{math::WidePoint<double>(start),
                                            math::WidePoint<double>(v), Wide(time)};
        const Vec direction = random.direction<double>();
        const auto same = [&](const auto& obstacle) {
            const double a = smallest_gap(path, 0.5, obstacle).gap;
            const double b = smallest_gap(straight, 0.5, obstacle).gap;
            if (a != b) {  // both may be infinite
                EXPECT_NEAR(a, b, 1e-14) << "seed " << seed;
            }
        };
        same(geometry::Point<double>{Vec(0, 0)});
        same(geometry::Segment<double>(Vec(0, 0), 3 * direction, random.coin()));
        same(geometry::Arc<double>{Vec(0, 0), 1.5, direction, random.direction<double>(), false,
                                   random.coin()});
        same(geometry::Rim<double>{Vec(0, 0), 2});
    }
}

}  // namespace
}  // namespace osculo::engine

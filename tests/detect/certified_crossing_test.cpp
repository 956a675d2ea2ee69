#include <gtest/gtest.h>

#include "osculo/detect/ball_arc_certified.hpp"
#include "osculo/detect/ball_ball_certified.hpp"
#include "osculo/detect/ball_point.hpp"
#include "osculo/detect/ball_point_certified.hpp"
#include "osculo/detect/ball_segment_certified.hpp"
#include "support/cubic_path.hpp"
#include "support/random.hpp"

// First contacts on certified paths: against polynomials in 100 digits.
namespace osculo::detect {
namespace {

using support::Exact;
using Path = support::CubicPath<double>;
using Vec = math::Vec<double>;

/// How far from zero a gap may be at a contact, or from a contact at a miss: what the paths
/// resolve.
double resolution(const Path& path, double scale) {
    const double t = path.end;
    const double way = math::norm1<double>(path.velocity) +
                       t * (math::norm1<double>(path.square) + t * math::norm1<double>(path.cube));
    return 8 * math::epsilon<double>() * (scale + math::kPathNoise * t * way);
}

Path random_path(support::Random& random, double reach) {
    const double bend = std::pow(10.0, -3 * random.unit<double>());
    const double jerk = std::pow(10.0, 1 - 4 * random.unit<double>());
    return {math::WidePoint<double>(
                Vec(reach * random.signed_unit<double>(), reach * random.signed_unit<double>())),
            random.direction<double>() * random.uniform<double>(0, 3),
            random.direction<double>() * bend, random.direction<double>() * jerk,
            random.uniform<double>(0.1, 3)};
}

/// Moves the path such that its distance from the origin at a time t, where it has a minimum or
/// not, is s - depth.
void aim(Path& path, support::Random& random, double s, double depth) {
    const double t = path.end * random.unit<double>();
    const auto now = path.at(t);
    const double speed = math::norm<double>(now.velocity);
    if (!(speed > 0)) return;
    const Vec side =
        Vec(-now.velocity.y(), now.velocity.x()) / speed * (random.coin() ? 1.0 : -1.0);
    const Vec place = side * (s - depth);
    const Vec start = path.position.rounded() + (place - now.position.rounded());
    path.position = math::WidePoint<double>(start);
}

struct Count {
    int contacts = 0;
    int misses = 0;
    int undecided = 0;  ///< less than the resolution from the other answer
};

/// Compares an answer with the gap function f, |f'| per metre of gap [steepness].
template <std::size_t N>
void compare(double t, const support::Polynomial<Exact, N>& f, double end, double steepness,
             double blur, Count& count, int round) {
    const auto all = support::meetings<Exact, N>(f, Exact(end));
    const bool found = math::is_finite<double>(t);
    if (all.empty() && !found) {
        ++count.misses;
        return;
    }
    if (found && !all.empty()) {
        const double gap = static_cast<double>(support::value<Exact, N>(f, Exact(t))) / steepness;
        const double early = static_cast<double>(Exact(t - all.front().time));
        const auto slope = support::derivative<Exact, N>(f);
        const double speed =
            static_cast<double>(abs(support::value<Exact, N - 1>(slope, all.front().time))) /
            steepness;
        if (std::abs(gap) <= blur &&
            (std::abs(early) <= 4 * blur / speed || std::abs(early) <= 1e-6 * t)) {
            ++count.contacts;
            return;
        }
        // Another one, because the first is a graze below the resolution?
        const Exact until =
            early > 0 ? Exact(all.front().time + (t - all.front().time) / 2) : Exact(t);
        const double depth =
            -static_cast<double>(support::least_value<Exact, N>(f, early > 0 ? until : Exact(t))) /
            steepness;
        ASSERT_LE(std::abs(depth), blur) << "round " << round << " found " << t << " instead of "
                                         << static_cast<double>(all.front().time);
        ++count.undecided;
        return;
    }
    const double least =
        static_cast<double>(support::least_value<Exact, N>(f, Exact(end))) / steepness;
    ASSERT_LE(std::abs(least), blur)
        << "round " << round << (found ? " invented " : " missed ") << t;
    ++count.undecided;
}

TEST(CertifiedCrossing, FindsTheFirstContactsOfCubicPaths) {
    support::Random random(20261);
    Count count;
    for (int round = 0; round < 20000; ++round) {
        const double s = random.uniform<double>(0.02, 0.2);
        Path first = random_path(random, 2);
        const Path second{math::WidePoint<double>(Vec(0, 0)), Vec(0, 0), Vec(0, 0), Vec(0, 0),
                          first.end};
        if (round % 3 != 0) {
            const double depth = round % 3 == 1 ? s * random.uniform<double>(-0.1, 1)
                                                : s * std::pow(10.0, -12 * random.unit<double>());
            aim(first, random, s, random.coin() ? depth : -depth);
        }
        const auto f =
            support::circle_gap<Exact>(support::coordinate<Exact>(first, Vec(0, 0), 0),
                                       support::coordinate<Exact>(first, Vec(0, 0), 1), Exact(s));
        if (f[0] < 0) continue;
        const double blur = resolution(first, s + math::norm1<double>(first.position.rounded()));
        const double t = first_contact<double>(first, second, s, {}, math::never<double>());
        compare<7>(t, f, first.end, 2 * s, blur, count, round);
        if (HasFatalFailure()) return;
        // As a point, the same.
        EXPECT_EQ(first_contact<double>(first, s, geometry::Point<double>{Vec(0, 0)}, {},
                                        math::never<double>()),
                  t);
    }
    EXPECT_GT(count.contacts, 5000);
    EXPECT_GT(count.misses, 3000);
    EXPECT_LT(count.undecided, 200);
}

TEST(CertifiedCrossing, FindsTheFirstContactsOfTwoCubicPaths) {
    support::Random random(20262);
    Count count;
    for (int round = 0; round < 10000; ++round) {
        const double s = random.uniform<double>(0.02, 0.2);
        Path first = random_path(random, 0.5);
        Path second = random_path(random, 0.5);
        if (round % 2 == 0) second.velocity = first.velocity * random.uniform<double>(0.9, 1.1);
        const double end = std::min(first.end, second.end);
        const auto along = [&](int i) {
            return support::difference<Exact>(support::coordinate<Exact>(first, Vec(0, 0), i),
                                              support::coordinate<Exact>(second, Vec(0, 0), i));
        };
        const auto f = support::circle_gap<Exact>(along(0), along(1), Exact(s));
        if (f[0] < 0) continue;
        const double blur = resolution(first, s + 1) + resolution(second, s + 1);
        const double t = first_contact<double>(first, second, s, {}, math::never<double>());
        EXPECT_EQ(first_contact<double>(second, first, s, {}, math::never<double>()), t);
        compare<7>(t, f, end, 2 * s, blur, count, round);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(count.contacts, 500);
    EXPECT_GT(count.misses, 1000);
    EXPECT_LT(count.undecided, 10);
}

TEST(CertifiedCrossing, AgreesWithTheExactRoutineOnParabolas) {
    support::Random random(20263);
    int contacts = 0;
    for (int round = 0; round < 20000; ++round) {
        const double s = random.uniform<double>(0.02, 0.2);
        Path path = random_path(random, 1);
        path.cube = Vec(0, 0);
        if (round % 2 == 0) {
            aim(path, random, s, s * std::pow(10.0, -9 * random.unit<double>()));
        }
        const Vec c = path.position.rounded();
        if (math::norm<double>(c) < s) continue;
        const motion::ParabolicPath<double> parabola{path.position, path.velocity, path.square,
                                                     path.end};
        const motion::QuadraticPath<double> certified{parabola};
        const geometry::Point<double> point{Vec(0, 0)};
        const double expected =
            first_contact<double>(parabola, s, point, {}, math::never<double>());
        const double t = first_contact<double>(certified, s, point, {}, math::never<double>());
        ASSERT_EQ(math::is_finite<double>(t), math::is_finite<double>(expected)) << round;
        if (!math::is_finite<double>(t)) continue;
        ++contacts;
        ASSERT_NEAR(t, expected, 1e-15 * (1 + s) / s * expected + 1e-8 * s) << round;
    }
    EXPECT_GT(contacts, 8000);
}

TEST(CertifiedCrossing, FindsTheFirstContactsWithSegments) {
    support::Random random(20264);
    Count count;
    int both = 0;
    for (int round = 0; round < 10000; ++round) {
        const double r = random.uniform<double>(0.02, 0.1);
        const Path path = random_path(random, 0.5);
        const geometry::Segment<double> segment(Vec(-1, 0), Vec(1, 0), random.coin());
        // The line as an axis: distance is the second coordinate.
        const double y = path.position.rounded().y();
        if (y < 0 && segment.one_sided) continue;
        auto f = support::coordinate<Exact>(path, Vec(0, 0), 1);
        if (y < 0) {
            for (Exact& x : f) x = -x;
        }
        f[0] -= r;
        if (f[0] < 0) continue;
        const auto all = support::meetings<Exact, 4>(f, Exact(path.end));
        const double t = first_contact<double>(path, r, segment, {}, math::never<double>());
        // All that are within the segment; it can also be met from behind after having passed it.
        double expected = math::never<double>();
        bool passes = false;
        for (const auto& m : all) {
            const double at = static_cast<double>(m.time);
            if (std::abs(path.at(at).position.rounded().x()) <= 1) {
                expected = at;
                break;
            }
            passes = true;
        }
        if (passes && !segment.one_sided) {
            ++both;
            continue;
        }
        if (expected == t) {
            ++count.misses;
            continue;
        }
        ASSERT_NEAR(t, expected, 1e-12) << round;
        ++count.contacts;
    }
    EXPECT_GT(count.contacts, 500);
    EXPECT_LT(both, 2000);
}

// Half out from behind a one-sided wall: it is met where the way back begins, or later from
// outside.
TEST(CertifiedCrossing, LetsBallsOutFromBehindAWall) {
    support::Random random(20268);
    int out = 0, turned = 0, met = 0;
    for (int round = 0; round < 4000; ++round) {
        const double r = random.uniform<double>(0.02, 0.5);
        Path path = random_path(random, 0.5);
        path.position = math::WidePoint<double>(
            Vec(path.position.rounded().x(), r * random.uniform<double>(0.01, 0.99)));
        if (path.velocity.y() < 0) path.velocity.y() = -path.velocity.y();
        const geometry::Segment<double> segment(Vec(-1000, 0), Vec(1000, 0), true);
        auto f = support::coordinate<Exact>(path, Vec(0, 0), 1);
        f[0] -= r;
        if (f[1] == 0 && f[2] == 0 && f[3] == 0) continue;  // along the wall
        const auto all = support::meetings<Exact, 4>(f, Exact(path.end));
        const double t = first_contact<double>(path, r, segment, {}, math::never<double>());
        ASSERT_EQ(math::is_finite<double>(t), !all.empty()) << round << " " << t;
        if (all.empty()) {
            ++out;
            continue;
        }
        const Exact expected = all.front().time;
        if (abs(Exact(t - expected)) > 1e-9) {  // one is as good as the other, but for rounding
            const auto between =
                support::value<Exact, 4>(f, Exact(t)) - support::value<Exact, 4>(f, expected);
            ASSERT_LE(abs(between), 1e-12) << round << " " << t;
        }
        ++(support::value<Exact, 4>(f, all.front().time) < -1e-9 ? turned : met);
    }
    EXPECT_GT(out, 500);
    EXPECT_GT(turned, 100);
    EXPECT_GT(met, 100);
}

TEST(CertifiedCrossing, FindsTheFirstContactsWithArcs) {
    support::Random random(20265);
    int contacts = 0;
    int through_the_opening = 0;
    for (int round = 0; round < 10000; ++round) {
        const double r = random.uniform<double>(0.02, 0.1);
        const Path path = random_path(random, 0.6);
        const Vec start = random.direction<double>();
        const Vec end = random.direction<double>();
        const geometry::Arc<double> arc{
            Vec(0, 0), 0.3, start, end, math::cross<double>(start, end) < 0, random.below(4) == 0};
        const double distance = math::norm<double>(path.position.rounded());
        if (std::abs(distance - arc.radius) < r) continue;
        const auto x = support::coordinate<Exact>(path, Vec(0, 0), 0);
        const auto y = support::coordinate<Exact>(path, Vec(0, 0), 1);
        double expected = math::never<double>();
        bool refused = false;
        const auto look_at = [&](double s, int sign) {
            auto f = support::circle_gap<Exact>(x, y, Exact(s));
            if (sign < 0) {
                for (Exact& c : f) c = -c;
            }
            for (const auto& m : support::meetings<Exact, 7>(f, Exact(path.end))) {
                const double t = static_cast<double>(m.time);
                if (!m.crossing) continue;
                if (t < expected && arc.covers(path.at(t).position.rounded())) {
                    expected = t;
                    return;
                }
                refused = true;
            }
        };
        look_at(arc.radius + r, 1);
        look_at(arc.radius - r, -1);
        const double t = first_contact<double>(path, r, arc, {}, math::never<double>());
        if (refused) ++through_the_opening;
        if (t == expected) continue;
        ASSERT_NEAR(t, expected, 1e-11) << round;
        ++contacts;
    }
    EXPECT_GT(contacts, 400);
    EXPECT_GT(through_the_opening, 500);
}

TEST(CertifiedCrossing, ThosePulledTogetherAfterAContactMeetAgain) {
    // Touching, parting at u, pulled back by the cubic term: f = u t - j t^3 in the gap.
    for (const double u : {1e-9, 1e-6, 1e-3, 1.0}) {
        const double s = 0.0625;
        const Path path{math::WidePoint<double>(Vec(s, 0)), Vec(u, 0), Vec(0, 0), Vec(-1, 0), 10};
        const geometry::Point<double> point{Vec(0, 0)};
        const double t = first_contact<double>(path, s, point, {true, 0}, math::never<double>());
        EXPECT_NEAR(t, std::sqrt(u), 1e-10 * std::sqrt(u) + 1e-16 / u) << u;
    }
}

TEST(CertifiedCrossing, ThoseThatStayTogetherEnd) {
    // Side by side for ever, on paths that bend as one: within rounding, no contact or one.
    const double s = 0.0625;
    const Path first{math::WidePoint<double>(Vec(s, 0)), Vec(0, 1), Vec(0, -0.1), Vec(0, 1e-3), 5};
    const Path second{math::WidePoint<double>(Vec(0, 0)), Vec(0, 1), Vec(0, -0.1), Vec(0, 1e-3), 5};
    const double t = first_contact<double>(first, second, s, {true, 0}, math::never<double>());
    EXPECT_GT(t, 0);
}

TEST(CertifiedCrossing, WiderTypesHaveTheirDigits) {
    using S = math::Quad;
    using QuadVec = math::Vec<S>;
    const support::CubicPath<S> path{math::WidePoint<S>(QuadVec(S(-1), S(0))), QuadVec(S(1), S(0)),
                                     QuadVec(S(0), S(0)), QuadVec(S(1), S(0)), S(5)};
    const S t = first_contact<S>(path, S(0.5), geometry::Point<S>{QuadVec(S(0), S(0))}, {},
                                 math::never<S>());
    const S gap = S(0.5) - t - t * t * t;
    EXPECT_LT(math::to_double<S>(math::abs<S>(gap)), 1e-33);
}

}  // namespace
}  // namespace osculo::detect

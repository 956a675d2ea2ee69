#include "osculo/motion/rim_tipping_stay.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "osculo/motion/rim_tipping.hpp"
#include "support/exact_scalars.hpp"
#include "support/exact_tipping.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using motion::TippingEnd;
using motion::TippingStart;
using Vec = math::Vec<double>;

constexpr double kGravity = 9.81;
constexpr double kRadius = 0.028575;

/// A ball that comes to the rim at (rim, 0).
template <class S>
motion::RimTippingStay<S> entering(double rim, double inwards, double along, double heaviness = 1) {
    const geometry::Rim<S> hole{math::Vec<S>(S(0), S(0)), S(rim)};
    const motion::Hovering<S> ball{math::WidePoint<S>(math::Vec<S>(S(rim), S(0))),
                                   math::Vec<S>(S(-inwards), S(along)), S(kRadius), S(0)};
    return {hole, S(kGravity), S(kRadius), S(heaviness), ball, TippingStart::touches};
}
ExactTipping reference(double rim, double inwards, double along) {
    return {rim, kRadius, kGravity, {rim, 0, kRadius, -inwards, along, 0}};
}

/// Where the reference's own function of its state comes down to 0, by bisection in [low, high].
template <class F>
Digits50 zero(double rim, double inwards, double along, double low, double high, const F& f) {
    Digits50 a = low, b = high;
    ExactTipping start = reference(rim, inwards, along);
    start.at(a);
    for (int i = 0; i < 80; ++i) {
        const Digits50 middle = (a + b) / 2;
        ExactTipping now = start;
        (f(now, now.at(middle)) > 0 ? a : b) = middle;
    }
    return a;
}

struct Row {
    double rim, inwards, along;
    TippingEnd end;
};

/// Time and place at the end, against 50 digits of the motion in space: by lift-off, back over the
/// rim, straight, from all but rest, swinging, grazing, and beside the separatrix.
TEST(RimTippingStay, EndsWhenAndWhereFiftyDigitsSay) {
    const Row rows[] = {
        {0.0571, 0.3, 0, TippingEnd::lift_off},     {0.0571, 1e-3, 0, TippingEnd::lift_off},
        {0.0571, 1e-8, 0, TippingEnd::lift_off},    {0.0571, 0.1, 0.173, TippingEnd::lift_off},
        {0.0571, 0.15, 0.26, TippingEnd::lift_off}, {0.0571, 0.05, 0.1, TippingEnd::lift_off},
        {0.0571, 0.25, 0.45, TippingEnd::exit},     {0.0571, 0.1, 1.5, TippingEnd::exit},
        {0.0571, 1e-6, 1.0, TippingEnd::exit},      {0.2, 0.5, 0.3, TippingEnd::lift_off},
        {0.2, 0.3, 2.0, TippingEnd::exit},          {0.033, 0.3, 0.05, TippingEnd::lift_off},
        {0.033, 0.3, 0.2, TippingEnd::exit}};
    for (const Row& row : rows) {
        const auto stay = entering<double>(row.rim, row.inwards, row.along);
        ASSERT_EQ(stay.end(), row.end) << row.rim << " " << row.inwards << " " << row.along;
        ASSERT_TRUE(stay.sound());
        const double end = stay.duration();
        const Digits50 exact_end =
            zero(row.rim, row.inwards, row.along, end * (1 - 1e-6), end * (1 + 1e-6),
                 [&](ExactTipping& ball, const ExactTipping::State& s) {
                     if (row.end == TippingEnd::lift_off) return ball.push(s);
                     return Digits50(Digits50(row.rim) - sqrt(Digits50(s.x * s.x + s.y * s.y)));
                 });
        EXPECT_LE(double(abs(Digits50(end / exact_end - 1))), 1e-13)
            << row.rim << " " << row.inwards << " " << row.along;
        ExactTipping ball = reference(row.rim, row.inwards, row.along);
        const double speed = std::sqrt(kGravity * kRadius) + std::hypot(row.inwards, row.along);
        for (const double share : {0.03125, 0.25, 0.5, 0.75, 0.9375, 1.0}) {
            const double t = share * end;
            const auto is = stay.in_space(t);
            const auto& should = ball.at(t);
            const auto error = [](double a, const Digits50& b) { return std::abs(double(a - b)); };
            const double place = double(abs(Digits50(exact<Digits50>(is.position.x) - should.x))) +
                                 double(abs(Digits50(exact<Digits50>(is.position.y) - should.y))) +
                                 error(is.height, should.z);
            EXPECT_LE(place, 4e-15 * row.rim) << row.inwards << " " << row.along << " at " << share;
            EXPECT_LE(error(is.velocity.x(), should.vx) + error(is.velocity.y(), should.vy) +
                          error(is.climb, should.vz),
                      8e-15 * speed)
                << row.inwards << " " << row.along << " at " << share;
        }
    }
}

/// The speed along the rim at which balls with that speed inwards just do not get in.
double separatrix(double rim, double inwards) {
    double in = 0, out = 2;
    while (in + (out - in) / 2 > in && in + (out - in) / 2 < out) {
        const double middle = in + (out - in) / 2;
        const auto stay = entering<double>(rim, inwards, middle);
        (stay.end() == TippingEnd::exit ? out : in) = middle;
    }
    return out;
}

/// Beside the separatrix, time and place are those of the stored start: within 1e-9 of it and, as
/// no double is on it, next to it.
TEST(RimTippingStay, BesideTheSeparatrix) {
    for (const double inwards : {0.05, 0.1, 0.3}) {
        const double edge = separatrix(0.0571, inwards);
        for (const double along : {edge * (1 - 1e-3), edge * (1 - 1e-9), std::nextafter(edge, 0.0),
                                   edge, edge * (1 + 1e-9), edge * (1 + 1e-3)}) {
            const auto stay = entering<double>(0.0571, inwards, along);
            const auto wide = entering<Digits100>(0.0571, inwards, along);
            ASSERT_EQ(stay.end() == TippingEnd::exit, !(along < edge));
            ASSERT_EQ(stay.end(), wide.end());
            EXPECT_LE(double(abs(Digits100(stay.duration() / wide.duration() - 1))), 1e-12);
            const auto is = stay.at(stay.duration()).position.rounded();
            const auto should = wide.at(wide.duration()).position.rounded();
            EXPECT_NEAR(is.x(), double(should.x()), 1e-12 * 0.0571) << inwards << " " << along;
            EXPECT_NEAR(is.y(), double(should.y()), 1e-12 * 0.0571) << inwards << " " << along;
        }
    }
}

template <class S>
class RimTippingStayTypes : public testing::Test {};
TYPED_TEST_SUITE(RimTippingStayTypes, AllScalars, ScalarName);

TYPED_TEST(RimTippingStayTypes, AreAsAccurateAsTheyAreWide) {
    using S = TypeParam;
    for (const auto& [inwards, along] : {std::pair{0.3, 0.0}, {0.1, 0.17}, {0.25, 0.45}}) {
        const auto stay = entering<S>(0.0571, inwards, along);
        const auto wide = entering<Digits100>(0.0571, inwards, along);
        ASSERT_EQ(stay.end(), wide.end());
        const Digits100 error = exact<Digits100>(stay.duration()) / wide.duration() - 1;
        EXPECT_LE(double(abs(error)), 64 * math::to_double<S>(math::epsilon<S>()) + 1e-97);
    }
}

/// A ball that rolls is moved by g / (1 + k), and lifts off where (10 + 7 v^2 / (g r)) / 17 says.
TEST(RimTippingStay, BallsThatRoll) {
    for (const double v : {0.01, 0.3, 0.5}) {
        const auto stay = entering<double>(0.0571, v, 0, 1.4);
        EXPECT_EQ(stay.end(), TippingEnd::lift_off);
        const auto end = stay.in_space(stay.duration());
        const double cosine = (10 + 7 * v * v / (kGravity * kRadius)) / 17;
        EXPECT_NEAR(end.height / kRadius, cosine, 1e-15);
        EXPECT_NEAR(end.velocity.squaredNorm() + end.climb * end.climb, kGravity * kRadius * cosine,
                    1e-15);
        ExactTipping ball(0.0571, kRadius, Digits50(kGravity) / Digits50(1.4),
                          {0.0571, 0, kRadius, -v, 0, 0});
        const auto& should = ball.at(stay.duration());
        EXPECT_NEAR(end.position.x.hi, double(should.x), 1e-15);
        EXPECT_NEAR(end.climb, double(should.vz), 1e-15);
    }
}

/// In a narrow hole a ball can circle on the edge, between two tilts.
TEST(RimTippingStay, SwingsBetweenTwoTurns) {
    const double rim = 1.2 * kRadius;
    const double sine = 0.5;
    const double cosine = std::sqrt(1 - sine * sine);
    const double d = rim - sine * kRadius;
    // The speed of a circle there: q d^3 = L^2 c in units of r and g r.
    const double circle = std::sqrt(sine * d / kRadius / cosine * kGravity * kRadius);
    const geometry::Rim<double> hole{Vec(0, 0), rim};
    const auto start = [&](double share) {
        const motion::Hovering<double> ball{math::WidePoint<double>(Vec(d, 0)),
                                            Vec(0, share * circle), kRadius * cosine, 0};
        return motion::RimTippingStay<double>(hole, kGravity, kRadius, 1, ball,
                                              TippingStart::touches);
    };
    const auto stay = start(1.02);
    ASSERT_EQ(stay.end(), TippingEnd::turn);
    EXPECT_TRUE(stay.sound());
    // Back where it was but for the angle.
    const auto end = stay.in_space(stay.duration());
    EXPECT_NEAR(math::norm<double>(end.position.rounded()), d, 1e-15);
    EXPECT_NEAR(end.climb, 0, 1e-15);
    EXPECT_NEAR(math::norm<double>(end.velocity), 1.02 * circle, 1e-15);
    const Digits50 inside = Digits50(rim) - Digits50(d);
    const Digits50 height = sqrt(Digits50(Digits50(kRadius) * kRadius - inside * inside));
    ExactTipping ball(rim, kRadius, kGravity, {d, 0, height, 0, 1.02 * circle, 0});
    EXPECT_NEAR(end.position.x.hi, double(ball.at(stay.duration()).x), 1e-14);
}

TEST(RimTippingStay, CannotTellWhatNoDigitTells) {
    const auto stay = entering<double>(0.06, 0, 0);
    EXPECT_EQ(stay.end(), TippingEnd::balanced);
    const auto tiny = entering<double>(0.06, 1e-30, 0);
    EXPECT_EQ(tiny.end(), TippingEnd::lift_off);
    // It grows by e per sqrt(r / g).
    EXPECT_NEAR(tiny.duration() - entering<double>(0.06, 1e-29, 0).duration(),
                std::sqrt(kRadius / kGravity) * std::log(10), 1e-12);
}

TEST(RimTippingStay, KeepsEnergyAndAngularMomentum) {
    Random random(21);
    int ends[6] = {};
    for (int i = 0; i < 500; ++i) {
        const double rim = kRadius * (1.05 + 3 * random.unit<double>());
        const double inwards = 0.55 * random.unit<double>();
        const double along = 1.2 * random.unit<double>();
        const auto stay = entering<double>(rim, inwards, along);
        ASSERT_TRUE(stay.sound()) << rim << " " << inwards << " " << along;
        ++ends[static_cast<int>(stay.end())];
        const double square = inwards * inwards + along * along;
        for (const double share : {0.2, 0.7, 1.0}) {
            const auto now = stay.in_space(share * stay.duration());
            const double energy = now.velocity.squaredNorm() + now.climb * now.climb +
                                  2 * kGravity * (now.height - kRadius);
            EXPECT_NEAR(energy, square, 1e-13 * (square + kGravity * kRadius));
            EXPECT_NEAR(math::cross<double>(now.position.rounded(), now.velocity), rim * along,
                        1e-13 * rim);
        }
    }
    EXPECT_GT(ends[static_cast<int>(TippingEnd::exit)], 50);
    EXPECT_GT(ends[static_cast<int>(TippingEnd::lift_off)], 50);
}

/// At any time, no further from the parabola that touches it than the bound says.
TEST(RimTippingStay, StaysWithinItsJerkBoundOfItsParabola) {
    Random random(22);
    for (int i = 0; i < 200; ++i) {
        const double rim = kRadius * (1.05 + 2 * random.unit<double>());
        const auto stay =
            entering<double>(rim, 0.5 * random.unit<double>(), 1.2 * random.unit<double>());
        for (int k = 0; k < 10; ++k) {
            const double t = random.unit<double>() * stay.duration();
            const double h = random.unit<double>() * (stay.duration() - t);
            auto parabola = stay.at(t);
            parabola.shift(h);
            const double off = math::norm<double>(
                math::difference<double>(stay.at(t + h).position, parabola.position));
            EXPECT_LE(off, stay.jerk_bound(t, h) * h * h * h / 6 + 1e-16);
            EXPECT_LE(math::norm<double>(stay.at(t).velocity), stay.most_speed());
        }
    }
}

/// Flights end at the first of three things: sampled, nothing comes before, and the end is one.
TEST(RimTippingStay, FlightsEndAtTheFirstContact) {
    Random random(23);
    int ends[6] = {};
    for (int i = 0; i < 3000; ++i) {
        const double rim = kRadius * (1.05 + 3 * random.unit<double>());
        const double tilt = 1.5 * random.unit<double>();
        const double away = random.magnitude<double>(-12, 0) * kRadius;
        const Vec out = random.direction<double>();
        const double inside = (kRadius + away) * std::sin(tilt);
        if (inside > rim) continue;
        motion::Hovering<double> ball{math::WidePoint<double>(Vec((rim - inside) * out)),
                                      random.magnitude<double>(-3, 1) * random.direction<double>(),
                                      (kRadius + away) * std::cos(tilt),
                                      2 * random.unit<double>() - 1};
        const geometry::Rim<double> hole{Vec(0, 0), rim};
        const motion::RimTippingStay<double> stay(hole, kGravity, kRadius, 1, ball,
                                                  TippingStart::flies);
        ++ends[static_cast<int>(stay.end())];
        const auto at = [&](double t) {
            const auto now = stay.in_space(t);
            const double d = math::norm<double>(now.position.rounded());
            return std::array{std::hypot(rim - d, now.height) - kRadius, now.height, rim - d};
        };
        for (int k = 0; k <= 400; ++k) {
            const auto [off, height, within] = at(stay.duration() * k / 400);
            EXPECT_GE(off, -1e-15) << i;
            EXPECT_GE(height, -1e-16) << i;
            EXPECT_GE(within, -1e-16) << i;
        }
        const auto [off, height, within] = at(stay.duration());
        const double end = stay.end() == TippingEnd::edge      ? off
                           : stay.end() == TippingEnd::capture ? height
                                                               : within;
        EXPECT_NEAR(end, 0, 1e-15 * (1 + math::norm<double>(ball.velocity))) << i;
    }
    for (const TippingEnd end : {TippingEnd::edge, TippingEnd::capture, TippingEnd::exit}) {
        EXPECT_GT(ends[static_cast<int>(end)], 100);
    }
}

}  // namespace

#include "osculo/motion/rim_tipping.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/scalars.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using motion::TippingOutcome;

constexpr double kGravity = 9.81;
constexpr double kRadius = 0.028575;

double degrees(const motion::Tipping<double>& t) {
    return std::atan2(t.sine, t.cosine) * 180 / std::numbers::pi;
}

template <class S>
class RimTipping : public testing::Test {};
TYPED_TEST_SUITE(RimTipping, AllScalars, ScalarName);

/// cos = (2 + v^2 / (g r)) / 3 frictionless, (10 + 7 v^2 / (g r)) / 17 rolling (NUMERICS 3.5).
TYPED_TEST(RimTipping, LiftOffStraightOverTheEdge) {
    using S = TypeParam;
    const S g = S(981) / S(100);
    const S r = S(28575) / S(1000000);
    const S bound = S(20) * math::epsilon<S>();
    for (int i = 0; i < 20; ++i) {
        const S square = S(i) / S(20);  // v^2 / (g r)
        const S speed = math::square_root<S>(square * g * r);
        const auto slides = motion::tip_straight<S>(g, r, S(0), speed);
        const auto rolls = motion::tip_straight<S>(g, r, S(2) / S(5), speed);
        EXPECT_TRUE(math::abs<S>(slides.cosine - (S(2) + square) / S(3)) <= bound);
        EXPECT_TRUE(math::abs<S>(rolls.cosine - (S(10) + S(7) * square) / S(17)) <= bound);
        for (const auto& t : {slides, rolls}) {
            // The edge pushes no more where gravity just bends the way: speed^2 = g r cos.
            EXPECT_TRUE(math::abs<S>(t.speed * t.speed / (g * r) - t.cosine) <= bound);
            EXPECT_TRUE(math::abs<S>(t.sine * t.sine + t.cosine * t.cosine - S(1)) <= bound);
        }
        const auto general = motion::tip_frictionless<S>(g, S(S(2) * r), r, speed, S(0));
        EXPECT_EQ(general.outcome, TippingOutcome::lift_off);
        EXPECT_TRUE(math::abs<S>(general.cosine - slides.cosine) <= bound);
        EXPECT_TRUE(math::abs<S>(general.speed - slides.speed) <= bound * slides.speed);
    }
}

TEST(RimTippingAngles, OfABallFromRest) {
    EXPECT_NEAR(degrees(motion::tip_straight<double>(kGravity, kRadius, 0, 0)), 48.18968510422140,
                1e-12);
    EXPECT_NEAR(degrees(motion::tip_straight<double>(kGravity, kRadius, 0.4, 0)),
                std::acos(10.0 / 17) * 180 / std::numbers::pi, 1e-12);
}

/// From sqrt(g r), 0.529 m/s for a pool ball, there is nothing to hold it to the edge.
TEST(RimTippingAngles, FastBallsFlyAtOnce) {
    const double fly = std::sqrt(kGravity * kRadius);
    EXPECT_NEAR(fly, 0.529, 5e-4);
    for (const double along : {0.0, 0.4}) {
        const auto fast =
            motion::tip_frictionless<double>(kGravity, 0.06, kRadius, fly * (1 + 1e-12), along);
        EXPECT_EQ(fast.outcome, TippingOutcome::lift_off);
        EXPECT_EQ(fast.sine, 0);
        EXPECT_EQ(fast.along, along);
        const auto slow =
            motion::tip_frictionless<double>(kGravity, 0.06, kRadius, fly * (1 - 1e-12), along);
        EXPECT_GT(slow.sine, 0);
    }
    EXPECT_EQ(motion::tip_straight<double>(kGravity, kRadius, 0.4, fly * 1.001).sine, 0);
}

/// A ball pushed by the edge in three dimensions, by steps of time: the contact keeps its centre on
/// a torus around the edge.
struct Stepped {
    double x, y, z, vx, vy, vz;
    double push = 1;  ///< of the edge, over the mass

    void step(double rim, double h) {
        const auto acceleration = [&](const Stepped& s, double& push_out) {
            const double d = std::hypot(s.x, s.y);
            const double radial = (s.x * s.vx + s.y * s.vy) / d;
            const double swing = (s.vx * s.vx + s.vy * s.vy) - radial * radial;
            // n from the edge to the centre; |d - R|^2 + z^2 = r^2 twice derived.
            const double nd = (d - rim) / kRadius;
            const double nz = s.z / kRadius;
            push_out =
                kGravity * nz - (radial * radial + s.vz * s.vz + (d - rim) * swing / d) / kRadius;
            return std::array{push_out * nd * s.x / d, push_out * nd * s.y / d,
                              push_out * nz - kGravity};
        };
        const auto moved = [&](const Stepped& s, const std::array<double, 6>& k, double t) {
            return Stepped{s.x + t * k[0],  s.y + t * k[1],  s.z + t * k[2],
                           s.vx + t * k[3], s.vy + t * k[4], s.vz + t * k[5]};
        };
        const auto rates = [&](const Stepped& s, double& push_out) {
            const auto a = acceleration(s, push_out);
            return std::array{s.vx, s.vy, s.vz, a[0], a[1], a[2]};
        };
        double unused = 0;
        const auto a = rates(*this, push);
        const auto b = rates(moved(*this, a, h / 2), unused);
        const auto c = rates(moved(*this, b, h / 2), unused);
        const auto d = rates(moved(*this, c, h), unused);
        std::array<double, 6> mean{};
        for (std::size_t i = 0; i < 6; ++i) mean[i] = (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6;
        const double last = push;
        *this = moved(*this, mean, h);
        push = last;
    }
};

TEST(RimTippingAngles, AreThoseOfSteppedMotion) {
    Random random(12);
    int outcomes[3] = {};
    for (int i = 0; i < 200; ++i) {
        const double rim = kRadius * (1.1 + 2 * random.unit<double>());
        const double inwards = 0.5 * random.unit<double>() + 0.02;
        const double along = 0.9 * random.unit<double>();
        const auto end = motion::tip_frictionless<double>(kGravity, rim, kRadius, inwards, along);
        ++outcomes[static_cast<int>(end.outcome)];
        Stepped ball{rim, 0, kRadius, -inwards, along, 0};
        const double h = 5e-6;
        TippingOutcome outcome = TippingOutcome::down;
        for (int k = 0; k < 400000; ++k) {
            ball.step(rim, h);
            if (ball.push <= 0) {
                outcome = TippingOutcome::lift_off;
                break;
            }
            if (std::hypot(ball.x, ball.y) > rim) {
                outcome = TippingOutcome::back;
                break;
            }
            if (ball.z <= 0) break;
        }
        ASSERT_EQ(outcome, end.outcome) << rim << " " << inwards << " " << along;
        if (outcome == TippingOutcome::back) continue;
        const double sine = (rim - std::hypot(ball.x, ball.y)) / kRadius;
        EXPECT_NEAR(sine, end.sine, 1e-3) << rim << " " << inwards << " " << along;
        const double speed = std::hypot(end.speed, end.along);
        EXPECT_NEAR(std::hypot(ball.vx, ball.vy, ball.vz), speed, 1e-3 * speed);
    }
    EXPECT_GT(outcomes[0], 20);
    EXPECT_GT(outcomes[1], 20);
}

/// The rows of NUMERICS 3.4 for R = 57.1 mm without friction: tilt at lift-off, to its degree.
TEST(RimTippingAngles, PublishedOutcomes) {
    struct Row {
        double speed, from_normal, tilt;  ///< [m/s, deg, deg]; tilt < 0: it leaves
    };
    const Row rows[] = {{0.05, 0, 48}, {0.05, 60, 49}, {0.1, 75, 51}, {0.1, 85, -1}, {0.2, 30, 48},
                        {0.2, 60, 58}, {0.2, 75, 63},  {0.3, 0, 39},  {0.3, 60, 81}, {0.3, 75, -1},
                        {0.5, 0, 15},  {0.5, 30, 49},  {0.5, 60, -1}, {0.7, 0, 0}};
    for (const Row& row : rows) {
        const double a = row.from_normal * std::numbers::pi / 180;
        const auto t = motion::tip_frictionless<double>(
            kGravity, 0.0571, kRadius, row.speed * std::cos(a), row.speed * std::sin(a));
        if (row.tilt < 0) {
            EXPECT_EQ(t.outcome, TippingOutcome::back) << row.speed << " " << row.from_normal;
        } else {
            EXPECT_EQ(t.outcome, TippingOutcome::lift_off) << row.speed << " " << row.from_normal;
            EXPECT_NEAR(degrees(t), row.tilt, 0.6) << row.speed << " " << row.from_normal;
        }
    }
}

}  // namespace

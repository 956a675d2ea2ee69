#include <cmath>

#include <gtest/gtest.h>

#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_mathavan_2010.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/cushion_stronge.hpp"
#include "osculo/impact/frictional.hpp"
#include "support/spinning.hpp"

// Limit cases of the impact laws.
namespace osculo::impact {
namespace {

using support::Ball;
using support::Point;
using support::same_bits;

/// Calls [check] with each cushion law: (name, resolve(normal, ball)).
template <class Check>
void for_each_cushion(double e, double mu, double height, const Check& check) {
    check("simple", [=](const Point& n, Ball& b) { CushionSimple<double>{e, mu}.resolve(n, b); });
    check("han", [=](const Point& n, Ball& b) {
        CushionHan2005<double>{e, mu, height * b.radius}.resolve(n, b);
    });
    check("stronge", [=](const Point& n, Ball& b) {
        CushionStronge<double>{e, mu, height * b.radius}.resolve(n, b);
    });
    check("mathavan", [=](const Point& n, Ball& b) {
        CushionMathavan2010<double>{e, mu, height * b.radius, mu}.resolve(n, b);
    });
}

TEST(Limits, NoFrictionIsRestitutionBitForBit) {
    support::Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const Ball one = support::random_ball(random);
        const Ball other = support::random_ball(random);
        const Point n = random.direction<double>();
        const double e = random.unit<double>();
        Ball a = one, b = other;
        Frictional<double>{e, {}}.resolve(n, a, b);
        Point va = one.velocity, vb = other.velocity;
        Restitution::resolve<double>(e, one.mass, other.mass, n, va, vb);
        ASSERT_TRUE(a.velocity == va && b.velocity == vb && a.spin == one.spin &&
                    b.spin == other.spin);
        const Point towards = math::dot<double>(one.velocity, n) < 0 ? Point(-n) : n;
        a = one;
        CushionSimple<double>{e, 0}.resolve(towards, a);
        va = one.velocity;
        Restitution::resolve<double>(e, towards, va);
        ASSERT_TRUE(a.velocity == va && a.spin == one.spin);
        // Mathavan's cushion without friction and upright is the same to rounding.
        a = one;
        CushionMathavan2010<double>{e, 0, a.radius, 0}.resolve(towards, a);
        ASSERT_LE((a.velocity - va).norm(), 1e-13 * one.velocity.norm()) << i;
        ASSERT_EQ(a.spin, one.spin);
    }
}

TEST(Limits, NoRestitutionLeavesNoNormalVelocity) {
    for (const double height : {1., 1.28, 1.8}) {
        for_each_cushion(0, 0.2, height, [&](const char* name, const auto& resolve) {
            for (const double spin : {-60., 0., 60.}) {
                Ball b{0.17, 0.028, 0.4, {1, 2}, {spin, -spin, spin}};
                resolve(Point(0, 3), b);
                // Han's and Stronge's plane is tilted: the ball may leave it by the friction alone.
                EXPECT_LE(b.velocity.y(), 1e-15) << name << ' ' << height;
                EXPECT_GE(b.velocity.y(), -0.5) << name << ' ' << height;
                if (height == 1) {
                    EXPECT_NEAR(b.velocity.y(), 0, 1e-15) << name;
                }
            }
        });
    }
}

TEST(Limits, NothingHappensWithoutApproach) {
    for_each_cushion(0.8, 0.2, 1.28, [&](const char* name, const auto& resolve) {
        for (const double v : {0., -0., -1.}) {
            const Ball start{0.17, 0.028, 0.4, {1, v}, {3, 4, 5}};
            Ball b = start;
            resolve(Point(0, 3), b);
            EXPECT_TRUE(same_bits(b, start)) << name << ' ' << v;
        }
    });
    const Ball one{1, 1, 0.4, {0, 1}, {3, 4, 5}};
    const Ball other{2, 1, 0.4, {0, 1}, {6, 7, 8}};
    Ball a = one, b = other;
    Frictional<double>{0.9, {0.2}}.resolve({0, 1}, a, b);
    EXPECT_TRUE(same_bits(a, one) && same_bits(b, other));
}

// A central hit without spin on an upright cushion and between balls: no slip, no friction.
TEST(Limits, NoSlipNoFriction) {
    Ball b{0.17, 0.028, 0.4, {0, 2}, {0, 0, 0}};
    CushionSimple<double>{0.5, 0.3}.resolve({0, 1}, b);
    EXPECT_EQ(b.velocity, Point(0, -1));
    EXPECT_EQ(b.spin.norm(), 0);
    Ball c{0.17, 0.028, 0.4, {0, 2}, {0, 0, 0}};
    CushionStronge<double>{0.5, 0.3, 0.028}.resolve({0, 1}, c);
    EXPECT_TRUE(same_bits(b, c));
}

TEST(Limits, EverythingScalesWithTheSpeed) {
    // Powers of two change no digit, but where a difference of speeds is rounded.
    for (const int exponent : {-498, -40, 40, 498}) {
        const double scale = std::ldexp(1, exponent);
        for_each_cushion(0.8, 0.2, 1.28, [&](const char* name, const auto& resolve) {
            Ball unit{0.17, 0.028, 0.4, {1, 2}, {30, -20, 50}};
            Ball scaled = unit;
            scaled.velocity *= scale;
            scaled.spin *= scale;
            resolve(Point(0.3, 0.9), unit);
            resolve(Point(0.3, 0.9), scaled);
            unit.velocity *= scale;
            unit.spin *= scale;
            EXPECT_TRUE(same_bits(unit, scaled)) << name << ' ' << exponent;
        });
        Ball a{0.17, 0.028, 0.4, {1, 2}, {30, -20, 50}}, b{0.2, 0.03, 0.5, {-1, 0}, {7, 8, 9}};
        Ball c = a, d = b;
        for (Ball* x : {&c, &d}) {
            x->velocity *= scale;
            x->spin *= scale;
        }
        Frictional<double>{0.9, {0.1}}.resolve({1, 1}, a, b);
        Frictional<double>{0.9, {0.1}}.resolve({1, 1}, c, d);
        EXPECT_EQ(a.velocity * scale, c.velocity);
        EXPECT_EQ(b.spin * scale, d.spin);
    }
}

// 1e150 m/s across and 1e-150 m/s towards the cushion, and the other way round.
TEST(Limits, MixedSpeeds) {
    for_each_cushion(0.8, 0.2, 1.28, [&](const char* name, const auto& resolve) {
        for (const Point& v : {Point(1e150, 1e-150), Point(1e-150, 1e150)}) {
            Ball b{0.17, 0.028, 0.4, v, {0, 0, v.x()}};
            resolve(Point(0, 1), b);
            EXPECT_TRUE(std::isfinite(b.velocity.norm() / 1e10) && b.spin.allFinite()) << name;
            EXPECT_LE(b.velocity.y(), 0) << name;
            EXPECT_GE(b.velocity.y(), -v.y()) << name;
        }
    });
}

// A ball of any inertia that sticks to the end leaves with no slip; one that slides has lost mu Jn.
TEST(Limits, StickingLeavesNoSlip) {
    for (const double k : {0.1, 0.4, 0.5, 2. / 3, 1.}) {
        Ball one{1, 0.5, k, {2, 1}, {0, 0, 1}};
        Ball other{3, 0.25, 0.4, {0, 0}, {0, 0, -2}};
        Frictional<double>{0.5, {10}}.resolve({1, 0}, one, other);
        const double slip =
            one.velocity.y() - other.velocity.y() + 0.5 * one.spin.z() + 0.25 * other.spin.z();
        EXPECT_NEAR(slip, 0, 1e-15) << k;
        Ball ball{1, 0.5, k, {2, 1}, {0, 0, 1}};
        CushionSimple<double>{0.5, 10}.resolve({1, 0}, ball);
        EXPECT_NEAR(ball.velocity.y() + 0.5 * ball.spin.z(), 0, 1e-15) << k;
        ball = {1, 0.5, k, {2, 100}, {0, 0, 1}};
        CushionSimple<double>{0.5, 0.125}.resolve({1, 0}, ball);
        EXPECT_NEAR(ball.velocity.y(), 100 - 0.125 * 1.5 * 2, 1e-13) << k;
    }
}

// A compliant contact flings a slipping ball back; a fast one slides throughout, as with Coulomb's
// law.
TEST(Limits, StrongeReversesEnglish) {
    Ball b{0.17, 0.028, 0.4, {0, 2}, {0, 0, 40}};
    CushionStronge<double>{0.85, 0.3, 0.028}.resolve({0, 1}, b);
    const double slip = -b.velocity.x() + 0.028 * b.spin.z();  // along z x n
    EXPECT_LT(slip, -0.2 * 0.028 * 40);
    EXPECT_GT(slip, -0.028 * 40);
    Ball fast{0.17, 0.028, 0.4, {50, 2}, {0, 0, 0}};
    Ball coulomb = fast;
    CushionStronge<double>{0.85, 0.3, 0.028}.resolve({0, 1}, fast);
    CushionSimple<double>{0.85, 0.3}.resolve({0, 1}, coulomb);
    EXPECT_TRUE(same_bits(fast, coulomb));
}

}  // namespace
}  // namespace osculo::impact

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "osculo/impact/frictional.hpp"
#include "support/spinning.hpp"

// A million random impacts of two balls.
namespace osculo::impact {
namespace {

using support::Ball;
using support::distance;
using support::mirrored;
using support::Point;
using support::same_bits;
constexpr int kCases = 1000000;
constexpr double kEpsilon = 0x1p-52;

struct Case {
    Point normal;
    Ball one;
    Ball other;
    Frictional<double> law;

    explicit Case(support::Random& random) {
        normal = random.magnitude<double>(-5, 5) * random.direction<double>();
        one = support::random_ball(random);
        other = support::random_ball(random);
        if (random.coin()) {  // of a kind
            other.mass = one.mass;
            other.radius = one.radius;
            other.inertia = one.inertia;
        }
        if (math::dot<double>(one.velocity - other.velocity, normal) < 0) normal = -normal;
        const double ends[] = {0, 1, 0.95};
        law.restitution = random.coin() ? random.unit<double>() : ends[random.below(3)];
        law.friction.a = random.below(4) == 0 ? 0 : random.magnitude<double>(-8, 2);
        if (random.coin()) law.friction = {0.009951, 0.108, 1.088};
    }
    [[nodiscard]] std::string described() const {
        std::ostringstream out;
        out << std::hexfloat << "normal " << normal.transpose() << ", e " << law.restitution
            << ", mu " << law.friction.a << ' ' << law.friction.b << ", " << support::described(one)
            << ", " << support::described(other);
        return out.str();
    }
};

double angular_momentum_z(const Ball& one, const Ball& other, const Point& unit) {
    const Point arm = (one.radius + other.radius) * unit;
    return other.mass * math::cross<double>(arm, other.velocity) +
           one.inertia * one.mass * one.radius * one.radius * one.spin.z() +
           other.inertia * other.mass * other.radius * other.radius * other.spin.z();
}

TEST(RandomBallBall, LawsOfMechanics) {
    support::Random random(20261);
    double gain = 0, approach = 0, momentum = 0, turning = 0, mirror = 0;
    for (int i = 0; i < kCases; ++i) {
        const Case c(random);
        Ball one = c.one;
        Ball other = c.other;
        c.law.resolve(c.normal, one, other);
        const Point unit = c.normal / math::norm<double>(c.normal);

        const double before = support::energy(c.one) + support::energy(c.other);
        const double after = support::energy(one) + support::energy(other);
        const double speeds =
            math::norm<double>(c.one.velocity) + math::norm<double>(c.other.velocity) + 1e-300;
        if (before > 0) gain = std::max(gain, (after - before) / before / kEpsilon);
        approach = std::max(
            approach, math::dot<double>(one.velocity - other.velocity, unit) / speeds / kEpsilon);

        const Point p = c.one.mass * c.one.velocity + c.other.mass * c.other.velocity;
        const Point q = one.mass * one.velocity + other.mass * other.velocity;
        const double scale = c.one.mass * support::speed_scale(c.one) +
                             c.other.mass * support::speed_scale(c.other) + 1e-300;
        momentum = std::max(momentum, math::norm_max<double>(q - p) / scale / kEpsilon);
        const double change =
            angular_momentum_z(one, other, unit) - angular_momentum_z(c.one, c.other, unit);
        turning =
            std::max(turning, std::abs(change) / (scale * (one.radius + other.radius)) / kEpsilon);

        // Mirrored at an axis and with the balls exchanged: the same bits.
        const Point x(1, 0);
        Ball m1 = mirrored(c.one, x), m2 = mirrored(c.other, x);
        c.law.resolve(mirrored(c.normal, x), m1, m2);
        ASSERT_TRUE(same_bits(m1, mirrored(one, x)) && same_bits(m2, mirrored(other, x)))
            << "case " << i << ": " << c.described();
        Ball e1 = c.one, e2 = c.other;
        c.law.resolve(-c.normal, e2, e1);
        ASSERT_TRUE(same_bits(e1, one) && same_bits(e2, other))
            << "case " << i << ": " << c.described();

        // Mirrored anywhere: to rounding. Where stick meets slide the results meet as well.
        const Point m = random.direction<double>();
        Ball g1 = mirrored(c.one, m), g2 = mirrored(c.other, m);
        c.law.resolve(mirrored(c.normal, m), g1, g2);
        const double size = support::speed_scale(c.one) + support::speed_scale(c.other) + 1e-300;
        mirror = std::max({mirror, distance(g1, mirrored(one, m)) / size / kEpsilon,
                           distance(g2, mirrored(other, m)) / size / kEpsilon});
    }
    std::printf(
        "  in epsilons: gain %.2f, approach %.2f, momentum %.2f, angular momentum %.2f, "
        "mirror %.2f\n",
        gain, approach, momentum, turning, mirror);
    EXPECT_LE(gain, 8);
    EXPECT_LE(approach, 4);
    EXPECT_LE(momentum, 8);
    EXPECT_LE(turning, 8);
    EXPECT_LE(mirror, 40);
}

}  // namespace
}  // namespace osculo::impact

#include "osculo/impact/disc_friction.hpp"

#include <gtest/gtest.h>

#include "support/spinning.hpp"

namespace osculo::impact {
namespace {

using support::Ball;
using support::Point;
using Laws = DiscFriction::Laws<double>;

constexpr double kEps = 0x1p-52;

Ball random_disc(support::Random& random) {
    Ball disc = support::random_ball(random);
    disc.spin = {0, 0, disc.spin.z()};
    return disc;
}

/// Discs whose masses, sizes and speeds are comparable, so that rounding can be bounded simply.
Ball ordinary_disc(support::Random& random) {
    Ball disc;
    disc.mass = random.uniform<double>(0.2, 2);
    disc.radius = random.uniform<double>(0.2, 2);
    disc.inertia = random.coin() ? 0.5 : random.uniform<double>(0.1, 1);
    disc.velocity = {random.uniform<double>(-2, 2), random.uniform<double>(-2, 2)};
    disc.spin = {0, 0, random.uniform<double>(-5, 5)};
    return disc;
}

Laws random_laws(support::Random& random) {
    const double e = random.unit<double>();
    const double mu = random.below(4) == 0 ? 4 * random.unit<double>() : random.unit<double>() / 2;
    return {{e, {mu, 0, 0}}, {e, mu}};
}

/// Of both, about the point of contact: m (x x v) + I w.
double angular_momentum(const Ball& one, const Ball& other, const Point& n) {
    const auto own = [](const Ball& b) {
        return b.inertia * b.mass * b.radius * b.radius * b.spin.z();
    };
    return own(one) + own(other) - one.mass * one.radius * math::cross<double>(n, one.velocity) +
           other.mass * other.radius * math::cross<double>(n, other.velocity);
}

TEST(DiscFriction, AMillionImpactsOfTwoMakeNoEnergy) {
    support::Random random(20281);
    for (int round = 0; round < 1'000'000; ++round) {
        Ball one = random_disc(random);
        Ball other = random_disc(random);
        const Point normal = random.direction<double>();
        if (!(math::dot<double>(one.velocity - other.velocity, normal) > 0)) continue;
        const double before = support::energy(one) + support::energy(other);
        random_laws(random).ball_ball.resolve(normal, one, other);
        const double after = support::energy(one) + support::energy(other);
        ASSERT_LE(after, before * (1 + 32 * kEps)) << round;
        const double left = math::dot<double>(one.velocity - other.velocity, normal);
        ASSERT_LE(left, 16 * kEps *
                            (math::norm<double>(one.velocity) + math::norm<double>(other.velocity)))
            << round;
        ASSERT_TRUE(one.spin.x() == 0 && one.spin.y() == 0);
        ASSERT_TRUE(other.spin.x() == 0 && other.spin.y() == 0);
    }
}

TEST(DiscFriction, AMillionCushionsMakeNoEnergy) {
    support::Random random(20282);
    for (int round = 0; round < 1'000'000; ++round) {
        Ball disc = random_disc(random);
        const Point normal = random.direction<double>();
        if (!(math::dot<double>(disc.velocity, normal) > 0)) continue;
        const double before = support::energy(disc);
        random_laws(random).ball_cushion.resolve(normal, disc);
        ASSERT_LE(support::energy(disc), before * (1 + 32 * kEps)) << round;
        ASSERT_LE(math::dot<double>(disc.velocity, normal),
                  16 * kEps * math::norm<double>(disc.velocity));
        ASSERT_TRUE(disc.spin.x() == 0 && disc.spin.y() == 0);
    }
}

/// Against the law as it is written, with the inertia ratios as they come.
TEST(DiscFriction, IsTheLawInThePlane) {
    support::Random random(20283);
    int sticks = 0;
    int slides = 0;
    for (int round = 0; round < 100'000; ++round) {
        Ball one = ordinary_disc(random);
        Ball other = ordinary_disc(random);
        const Point n = random.direction<double>();
        const Point t(-n.y(), n.x());
        const double approach = math::dot<double>(one.velocity - other.velocity, n);
        if (!(approach > 0)) continue;
        const Laws laws = random_laws(random);
        const double u = math::dot<double>(one.velocity - other.velocity, t) +
                         one.radius * one.spin.z() + other.radius * other.spin.z();
        const double reduced = one.mass * other.mass / (one.mass + other.mass);
        const double normal = (1 + laws.ball_ball.restitution) * reduced * approach;
        const double stick =
            std::abs(u) / ((1 + 1 / one.inertia) / one.mass + (1 + 1 / other.inertia) / other.mass);
        const double most = laws.ball_ball.friction.a * normal;
        const double j = std::copysign(std::min(stick, most), u);
        ++(stick < most ? sticks : slides);
        const Point push = normal * n + j * t;
        const Point v1 = one.velocity - push / one.mass;
        const Point v2 = other.velocity + push / other.mass;
        const double w1 = one.spin.z() - j / (one.inertia * one.mass * one.radius);
        const double w2 = other.spin.z() - j / (other.inertia * other.mass * other.radius);
        const double turning = angular_momentum(one, other, n);
        const Point momentum = one.mass * one.velocity + other.mass * other.velocity;
        laws.ball_ball.resolve(n, one, other);
        ASSERT_LE(math::norm<double>(one.velocity - v1), 1e-12) << round;
        ASSERT_LE(math::norm<double>(other.velocity - v2), 1e-12) << round;
        ASSERT_NEAR(one.spin.z(), w1, 1e-11) << round;
        ASSERT_NEAR(other.spin.z(), w2, 1e-11) << round;
        ASSERT_NEAR(angular_momentum(one, other, n), turning, 1e-13) << round;
        ASSERT_LE(
            math::norm<double>(one.mass * one.velocity + other.mass * other.velocity - momentum),
            1e-13);
    }
    EXPECT_GT(sticks, 5'000);
    EXPECT_GT(slides, 5'000);
}

}  // namespace
}  // namespace osculo::impact

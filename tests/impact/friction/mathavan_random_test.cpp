#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "osculo/impact/cushion_mathavan_2010.hpp"
#include "support/spinning.hpp"

// Mathavan's cushion over random impacts, and against a plain integration of the same equations.
namespace osculo::impact {
namespace {

using support::Ball;
using support::distance;
using support::mirrored;
using support::Point;
using support::same_bits;
constexpr int kCases = 250000;  // in each of four parts

struct Case {
    Ball ball;
    Point normal;
    CushionMathavan2010<double> law;

    /// [ordinary]: speeds of the same order and frictions as on tables.
    explicit Case(support::Random& random, bool ordinary = false) {
        ball = support::random_ball(random);
        if (ordinary) {
            ball.velocity = random.uniform(0.2, 2.0) * random.direction<double>();
            ball.radius = 0.5;
            ball.inertia = 0.4;
            ball.spin = {random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0),
                         random.uniform(-4.0, 4.0)};
        }
        normal = random.magnitude<double>(-5, 5) * random.direction<double>();
        if (math::dot<double>(ball.velocity, normal) < 0) normal = -normal;
        const double ends[] = {0, 1, 0.98};
        law.restitution = random.coin() ? random.unit<double>() : ends[random.below(3)];
        law.friction = random.below(8) == 0 ? 0 : random.uniform(0.0, ordinary ? 0.3 : 0.6);
        law.cloth_friction = random.below(8) == 0 ? 0 : random.uniform(0.0, ordinary ? 0.3 : 0.6);
        law.height = ball.radius * (random.coin() ? 1.28 : random.uniform(0.7, 1.6));
    }
    [[nodiscard]] std::string described() const {
        std::ostringstream out;
        out << std::hexfloat << "e " << law.restitution << ", mu " << law.friction << ' '
            << law.cloth_friction << ", h " << law.height << ", normal " << normal.transpose()
            << ", " << support::described(ball);
        return out.str();
    }
};

class MathavanLaws : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Part, MathavanLaws, testing::Range(0, 4));

TEST_P(MathavanLaws, OfMechanics) {
    support::Random random(static_cast<std::uint64_t>(410 + GetParam()));
    double gain = 0, approach = 0;
    for (int i = 0; i < kCases; ++i) {
        const Case c(random);
        Ball ball = c.ball;
        c.law.resolve(c.normal, ball);
        const double before = support::energy(c.ball);
        const double scale = support::speed_scale(c.ball) + 1e-300;
        const double gained = before > 0 ? (support::energy(ball) - before) / before : 0;
        ASSERT_LT(gained, 1e-12) << "case " << i << ": " << c.described();
        gain = std::max(gain, gained);
        const Point unit = c.normal / math::norm<double>(c.normal);
        approach = std::max(approach, math::dot<double>(ball.velocity, unit) / scale);
        if (i % 4 != 0) continue;
        const Point axis(0, 1);
        Ball reflected = mirrored(c.ball, axis);
        c.law.resolve(mirrored(c.normal, axis), reflected);
        ASSERT_TRUE(same_bits(reflected, mirrored(ball, axis)))
            << "case " << i << ": " << c.described();
    }
    std::printf("  energy gained at most %.1e of it, approach left %.1e of the speed\n", gain,
                approach);
    EXPECT_LE(approach, 1e-15);
}

TEST(MathavanRandom, MirroredAnywhere) {
    support::Random random(42);
    std::vector<double> errors;
    for (int i = 0; i < 50000; ++i) {
        const Case c(random);
        Ball ball = c.ball;
        c.law.resolve(c.normal, ball);
        const Point m = random.direction<double>();
        Ball turned = mirrored(c.ball, m);
        c.law.resolve(mirrored(c.normal, m), turned);
        errors.push_back(distance(turned, mirrored(ball, m)) /
                         (support::speed_scale(c.ball) + 1e-300));
    }
    std::sort(errors.begin(), errors.end());
    const auto quantile = [&](double q) {
        return errors[static_cast<std::size_t>(q * static_cast<double>(errors.size() - 1))];
    };
    std::printf("  mirrored: median %.1e, 99.9 %% below %.1e, worst %.1e of the speed\n",
                quantile(0.5), quantile(0.999), errors.back());
    EXPECT_LT(quantile(0.5), 1e-15);
    EXPECT_LT(quantile(0.999), 1e-12);
    EXPECT_LT(errors.back(), 1e-11);
}

/// The same equations by Euler's method with the friction's direction smoothed below a slip speed
/// [smooth], written straight from forces and torques. (Forces that jump at zero make fixed steps
/// chatter; smoothed ones err in proportion to [smooth].)
Ball integrated(const Case& c, double smooth, double step) {
    using Vec3 = math::Vec3<double>;
    Ball b = c.ball;
    const Point n2 = c.normal / math::norm<double>(c.normal);
    const double s = c.law.height / b.radius - 1;
    const double cosine = std::sqrt(1 - s * s);
    const Vec3 up(0, 0, 1);
    const Vec3 nose(cosine * n2.x(), cosine * n2.y(), s);
    const double speed = math::dot<double>(n2, b.velocity);
    Vec3 v(b.velocity.x(), b.velocity.y(), 0);
    Vec3 w = b.spin;
    const auto cross = [](const Vec3& x, const Vec3& y) {
        return Vec3(x.y() * y.z() - x.z() * y.y(), x.z() * y.x() - x.x() * y.z(),
                    x.x() * y.y() - x.y() * y.x());
    };
    const auto opposing = [&](Vec3 slip) {
        slip /= speed;
        return Vec3(-slip / std::sqrt(slip.squaredNorm() + smooth * smooth));
    };
    struct Rates {
        Vec3 v, w;
        double work;
    };
    const auto rates = [&](const Vec3& velocity, const Vec3& spin) {
        Vec3 at_nose = velocity + cross(spin, b.radius * nose);
        at_nose -= at_nose.dot(nose) * nose;
        Vec3 at_cloth = velocity + cross(spin, -b.radius * up);
        at_cloth.z() = 0;
        const Vec3 f = c.law.friction * opposing(at_nose);
        const double press = std::max(0.0, -(f - nose).z());
        const Vec3 g = c.law.cloth_friction * press * opposing(at_cloth);
        Vec3 force = f + g - nose;
        force.z() = 0;
        return Rates{force, (cross(nose, f) - cross(up, g)) / (b.inertia * b.radius),
                     velocity.dot(nose)};
    };
    double work = 0;
    double target = 0;
    bool restitution = false;
    const double h = step * speed;
    for (;;) {
        const Rates first = rates(v, w);
        const Rates middle = rates(v + h / 2 * first.v, w + h / 2 * first.w);
        const Vec3 next = v + h * middle.v;
        const double gained = h * middle.work;
        const Point next2(next.x(), next.y());
        const double now = math::dot<double>(n2, Point(v.x(), v.y()));
        const double then = math::dot<double>(n2, next2);
        double part = 1;
        bool ends = false;
        if (!restitution && then <= 0) {
            part = now / (now - then);
            ends = true;
        } else if (restitution && work - gained >= target) {
            part = (target - work) / -gained;
            ends = true;
        }
        v += part * h * middle.v;
        w += part * h * middle.w;
        work += restitution ? -part * gained : part * gained;
        if (!ends) continue;
        if (restitution) break;
        restitution = true;
        target = c.law.restitution * c.law.restitution * work;
        work = 0;
        if (!(target > 0)) break;
    }
    b.velocity = {v.x(), v.y()};
    b.spin = w;
    return b;
}

TEST(MathavanRandom, AgreesWithPlainIntegration) {
    support::Random random(43);
    std::vector<double> errors;
    while (errors.size() < 100) {
        const Case c(random, true);
        const double speed =
            math::dot<double>(c.normal, c.ball.velocity) / math::norm<double>(c.normal);
        if (speed < 0.1) continue;  // hardly an impact
        Ball ball = c.ball;
        c.law.resolve(c.normal, ball);
        errors.push_back(distance(ball, integrated(c, 1e-4, 4e-5)) / speed);
    }
    std::sort(errors.begin(), errors.end());
    std::printf("  plain integration: median %.1e, 95 %% below %.1e, worst %.1e of the approach\n",
                errors[50], errors[95], errors.back());
    EXPECT_LT(errors[50], 1e-4);
    EXPECT_LT(errors.back(), 1e-3);
}

}  // namespace
}  // namespace osculo::impact

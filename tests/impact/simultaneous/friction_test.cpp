#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "osculo/impact/symmetric/surface.hpp"
#include "random_clusters.hpp"
#include "support/spinning.hpp"

// Friction in clusters.
namespace osculo::support {
namespace {

using impact::SymmetricSolver;
using Cluster = impact::SpinningCluster<double>;
constexpr double kEpsilon = 0x1p-52;

/// One contact is the binary law.
TEST(ClusterFriction, OneContactIsTheBinaryLaw) {
    Random random(424501);
    SymmetricSolver<double> solver;
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        Cluster cluster;
        cluster.balls = {random_ball(random), random_ball(random)};
        Ball& one = cluster.balls[0];
        Ball& other = cluster.balls[1];
        // A ball far lighter than one that has no part in it would stop.
        other.mass = one.mass * random.magnitude<double>(-4, 3);
        Point n = random.magnitude<double>(-5, 5) * random.direction<double>();
        const double ends[] = {0, 1, 0.95};
        const double e = random.coin() ? random.unit<double>() : ends[random.below(3)];
        const double mu = random.below(4) == 0 ? 0 : random.magnitude<double>(-8, 1);
        Ball first = one;
        Ball second = other;
        const int kind = random.below(3);
        if (kind == 0) {
            if (math::dot<double>(one.velocity - other.velocity, n) < 0) n = -n;
            impact::Frictional<double> law{e, {mu, 0, 0}};
            if (random.coin()) law.friction = {0.009951, 0.108, 1.088};
            cluster.contacts.push_back(impact::contact<double>(0, 1, n, impact::surface(law)));
            law.resolve(n, first, second);
        } else {
            if (math::dot<double>(one.velocity, n) < 0) n = -n;
            cluster.balls.pop_back();
            if (kind == 1) {
                const impact::CushionSimple<double> law{e, mu};
                cluster.contacts.push_back(impact::contact<double>(
                    0, impact::kFixed, n, impact::surface(law, first.radius)));
                law.resolve(n, first);
            } else {
                // Where the ball does not go on under the nose.
                const double height = random.uniform(0.9, 1.4) * first.radius;
                const double s = height / first.radius - 1;
                const impact::CushionHan2005<double> law{std::max(e, 1 / ((1 - s) * (1 + s)) - 1),
                                                         mu, height};
                cluster.contacts.push_back(impact::contact<double>(
                    0, impact::kFixed, n, impact::surface(law, first.radius)));
                law.resolve(n, first);
            }
        }
        const auto before = cluster;
        solver.resolve(cluster);
        double size = speed_scale(before.balls[0]);
        double off = distance(cluster.balls[0], first);
        if (kind == 0) {
            size += speed_scale(before.balls[1]);
            off = std::max(off, distance(cluster.balls[1], second));
        }
        worst = std::max(worst, off / (size + 1e-300) / kEpsilon);
        ASSERT_LE(off, 200 * kEpsilon * size)
            << "case " << i << " kind " << kind << std::hexfloat << " e " << e << " mu " << mu
            << " n " << n.transpose() << ' ' << described(before.balls[0]);
    }
    std::printf("  at most %.2f epsilon\n", worst);
}

/// Random clusters with spins.
struct Spinning {
    RandomCluster<double> source;
    Cluster cluster;

    explicit Spinning(Random& random) : source(random, 2) {
        for (std::size_t i = 0; i < source.stage.cluster.balls.size(); ++i) {
            const auto& plain = source.stage.cluster.balls[i];
            Ball ball{plain.mass,
                      1,
                      random.coin() ? 0.4 : random.uniform(0.1, 1.0),
                      plain.velocity,
                      {0, 0, 0}};
            if (random.coin()) {
                const double rate = random.magnitude<double>(-4, 2);
                ball.spin = {rate * random.signed_unit<double>(),
                             rate * random.signed_unit<double>(),
                             rate * random.signed_unit<double>()};
            }
            cluster.balls.push_back(ball);
        }
        const double mu = random.magnitude<double>(-6, -1);
        for (const auto& plain : source.stage.cluster.contacts) {
            impact::SpinningContact<double> contact{plain.one, plain.other, plain.normal,
                                                    plain.restitution};
            contact.friction = random.coin() ? impact::Friction<double>{0.009951, 0.108, 1.088}
                                             : impact::Friction<double>{mu, 0, 0};
            if (plain.other == impact::kFixed && random.coin()) {
                contact.tilt = random.uniform(-0.3, 0.4);
            }
            cluster.contacts.push_back(contact);
        }
    }
};

double total_energy(const Cluster& cluster) {
    double sum = 0;
    for (const Ball& ball : cluster.balls) sum += energy<double>(ball);
    return sum;
}

TEST(ClusterFriction, LawsOfMechanics) {
    Random random(424502);
    SymmetricSolver<double> solver(1000);
    double gain = 0, momentum = 0, approach = 0, mirror = 0;
    int unsettled = 0, left = 0, cases = 0;
    for (int i = 0; i < 100000; ++i) {
        const Spinning start(random);
        Cluster cluster = start.cluster;
        const auto outcome = solver.resolve(cluster);
        const auto label = [&] {
            return "case " + std::to_string(i) + ": " + start.source.described();
        };
        ++cases;
        unsettled += !outcome.friction_settled;
        left += !outcome.no_approach;
        const double before = total_energy(start.cluster);
        if (before == 0) continue;
        const double steps = 1 + outcome.reflections;
        const double gained = (total_energy(cluster) - before) / before / kEpsilon / steps;
        gain = std::max(gain, gained);
        ASSERT_LE(gained, 16) << label();
        Point change(0, 0);
        double size = 0;
        for (std::size_t b = 0; b < cluster.balls.size(); ++b) {
            const Ball& a = start.cluster.balls[b];
            change += a.mass * (cluster.balls[b].velocity - a.velocity);
            size += a.mass * (speed_scale(a) + speed_scale(cluster.balls[b]));
        }
        if (!start.source.walls) {
            momentum = std::max(momentum, math::norm<double>(change) / size / kEpsilon / steps);
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            const auto& c = cluster.contacts[k];
            ASSERT_GE(c.impulse, 0) << label();
            // Coulomb's bound, with the coefficient of rest at most.
            const double pressure = c.impulse / std::sqrt(1 - c.tilt * c.tilt);
            ASSERT_LE(math::norm<double>(c.friction_impulse),
                      (c.friction.a + c.friction.b) * pressure + 1e-14 * size)
                << label();
            const Point rest(0, 0);
            const Point& v = cluster.balls[c.one].velocity;
            const Point& w = c.other == impact::kFixed ? rest : cluster.balls[c.other].velocity;
            const double closing =
                math::dot<double>(v - w, c.normal) / math::norm<double>(c.normal);
            if (closing > 0) approach = std::max(approach, closing / solver.noise(k));
        }
        // Mirrored: the same bits.
        Cluster image = start.cluster;
        const Point x(1, 0);
        for (Ball& ball : image.balls) ball = mirrored(ball, x);
        for (auto& c : image.contacts) c.normal = mirrored(c.normal, x);
        solver.resolve(image);
        for (std::size_t b = 0; b < image.balls.size(); ++b) {
            ASSERT_TRUE(same_bits(image.balls[b], mirrored(cluster.balls[b], x))) << label();
        }
        // In another order: to what is left of the sweeps.
        Cluster reversed = start.cluster;
        std::ranges::reverse(reversed.contacts);
        const auto other = solver.resolve(reversed);
        if (!outcome.friction_settled || !other.friction_settled ||
            !start.source.same_restitution || start.source.masses == Masses::extreme) {
            continue;
        }
        double off = 0;
        double scale = 0;
        for (std::size_t b = 0; b < cluster.balls.size(); ++b) {
            off = std::max(off, distance(cluster.balls[b], reversed.balls[b]));
            scale = std::max(scale, speed_scale(start.cluster.balls[b]));
        }
        mirror = std::max(mirror, off / scale);
        ASSERT_LE(off, 1e-10 * scale) << label();
    }
    std::printf(
        "  %d clusters: unsettled %d, left %d; in epsilons: gain %.2f, momentum %.2f per step; "
        "approach %.2f of noise; reversed %.2g\n",
        cases, unsettled, left, gain, momentum, approach, mirror);
    EXPECT_EQ(left, 0);
    EXPECT_LE(unsettled, cases / 400);
}

}  // namespace
}  // namespace osculo::support

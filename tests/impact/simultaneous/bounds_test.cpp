#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "clusters.hpp"
#include "support/random.hpp"

// What the tolerances of clusters are for: normals that are known to some epsilon only.
namespace osculo::support {
namespace {

using impact::SymmetricSolver;
using Point = math::Vec<double>;
constexpr double kEpsilon = 0x1p-52;

/// A rack whose places are rounded as far from the origin as [distance] radii.
Rack<double> rounded_rack(Random& random, double distance, double e) {
    Rack<double> rack({1, 0}, e);
    const Point shift = distance * random.direction<double>();
    for (Point& place : rack.stage.places) {
        place += shift;  // rounds
        place -= shift;
    }
    for (auto& contact : rack.stage.cluster.contacts) {
        contact.normal = rack.stage.places[contact.other] - rack.stage.places[contact.one];
    }
    return rack;
}

TEST(ClusterBounds, ARoundedRackBreaksLikeAnExactOne) {
    Random random(424601);
    SymmetricSolver<double> solver;
    double worst = 0;
    for (const double e : {1.0, 0.95}) {
        auto exact = Rack<double>({1, 0}, e).stage.cluster;
        solver.resolve(exact);
        for (int i = 0; i < 1000; ++i) {
            auto cluster = rounded_rack(random, 128, e).stage.cluster;
            solver.resolve(cluster);
            for (std::size_t b = 0; b < cluster.balls.size(); ++b) {
                const Point off = cluster.balls[b].velocity - exact.balls[b].velocity;
                worst = std::max(worst, math::norm_max<double>(off) / kEpsilon);
            }
        }
    }
    std::printf("  at most %.1f epsilon\n", worst);
    EXPECT_LE(worst, 5000);
}

/// Walls behind every ball of the rack's outer rows: nothing can move, and the load is shared by
/// contacts that all depend on each other.
TEST(ClusterBounds, AWalledInRackStops) {
    Random random(424602);
    SymmetricSolver<double> solver;
    double worst = 0;
    double load = 0;
    for (int i = 0; i < 1000; ++i) {
        auto rack = rounded_rack(random, 32, 0);
        for (int k = 0; k < 5; ++k) {
            const auto index = [](int row, int place) { return Rack<double>::index(row, place); };
            rack.stage.wall(index(4, k), {1, 0}, 0);
            rack.stage.wall(index(k, 0), {-0.5, -std::sqrt(0.75)}, 0);
            rack.stage.wall(index(k, k), {-0.5, std::sqrt(0.75)}, 0);
        }
        auto& cluster = rack.stage.cluster;
        const auto outcome = solver.resolve(cluster);
        EXPECT_TRUE(outcome.no_approach) << i;
        for (const auto& ball : cluster.balls) {
            worst = std::max(worst, math::norm_max<double>(ball.velocity) / kEpsilon);
        }
        for (const auto& contact : cluster.contacts) load = std::max(load, contact.impulse);
    }
    std::printf("  at most %.1f epsilon, impulse %.3f\n", worst, load);
    EXPECT_LE(worst, 500);
    EXPECT_LE(load, 1.01);
}

/// Two balls side by side run into two others that press them together. Whether they approach each
/// other before that decides what comes out: 100 epsilon of a velocity are no approach.
TEST(ClusterBounds, NoiseIsNoApproach) {
    const auto result = [](double sideways) {
        Stage<double> stage;
        stage.ball({0, 1}, {1, -sideways});
        stage.ball({0, -1}, {1, sideways});
        stage.ball({std::sqrt(3.0), 2});
        stage.ball({std::sqrt(3.0), -2});
        stage.touch(0, 1);
        stage.touch(0, 2);
        stage.touch(1, 3);
        SymmetricSolver<double>().resolve(stage.cluster);
        return stage;
    };
    const auto expected = result(0);
    for (const double noise : {-100.0, 1.0, 100.0}) {
        const auto stage = result(noise * kEpsilon);
        for (std::size_t b = 0; b < 4; ++b) {
            EXPECT_NEAR(stage.vx(b), expected.vx(b), 200 * kEpsilon) << noise;
            EXPECT_NEAR(stage.vy(b), expected.vy(b), 200 * kEpsilon) << noise;
        }
    }
    // A hundred times that is one.
    EXPECT_GT(std::abs(result(1e4 * kEpsilon).vx(0) - expected.vx(0)), 0.01);
}

/// Walls that are parallel but for some epsilon do not stop what flies along them.
TEST(ClusterBounds, NoiseIsNoFunnel) {
    for (const double noise : {1.0, 10.0, 40.0}) {
        Stage<double> stage;
        stage.ball({0, 0}, {0.5, 1});
        stage.wall(0, {1, 0}, 0);
        stage.wall(0, {-1, noise * kEpsilon}, 0);
        SymmetricSolver<double>().resolve(stage.cluster);
        EXPECT_NEAR(stage.vy(0), 1, 1e-13) << noise;
        EXPECT_NEAR(stage.vx(0), 0, 1e-13) << noise;
    }
}

/// Balls of all masses in a row between two walls cannot move along it. That one contact depends on
/// the others must not be lost in the rounding of their shares: the impulses would be endless.
TEST(ClusterBounds, ARowOfAnyMassesBetweenWallsIsJammed) {
    Random random(424605);
    SymmetricSolver<double> solver;
    for (int i = 0; i < 5000; ++i) {
        const Point axis = random.direction<double>();
        Stage<double> stage;
        const double e = random.coin() ? 1 : random.unit<double>();
        const int count = random.between(3, 8);
        for (int k = 0; k < count; ++k) {
            const double mass = random.magnitude<double>(-20, 19);
            const auto b = static_cast<std::size_t>(k);
            stage.ball(2 * k * axis, random.unit<double>() * random.direction<double>(), mass);
            if (k > 0) stage.touch(b - 1, b, e);
        }
        stage.wall(0, -axis, e);
        stage.wall(static_cast<std::size_t>(count - 1), axis, e);
        auto cluster = stage.cluster;
        solver.resolve(cluster);
        double before = 0, after = 0, load = 0, bearable = 0;
        for (std::size_t b = 0; b < cluster.balls.size(); ++b) {
            const double mass = cluster.balls[b].mass;
            before += mass * stage.cluster.balls[b].velocity.squaredNorm();
            after += mass * cluster.balls[b].velocity.squaredNorm();
            bearable += mass;
        }
        for (const auto& contact : cluster.contacts) load = std::max(load, contact.impulse);
        EXPECT_LE(after, before * (1 + math::kClusterEnergy * kEpsilon)) << "case " << i;
        EXPECT_LE(load, bearable * SymmetricSolver<double>::kMostReflections) << "case " << i;
    }
}

/// What rounding alone makes of the energy of elastic chains, measured as the law measures it.
TEST(ClusterBounds, GainIsMoreThanRounding) {
    Random random(424604);
    impact::symmetric::NormalPhase<double> normals(1000);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        auto stage = chain<double>({random.signed_unit<double>(), random.signed_unit<double>()}, 1,
                                   {random.magnitude<double>(-1, 1), 1});
        normals.load(stage.cluster);
        impact::ClusterOutcome outcome;
        normals.resolve(outcome);
        const double before = normals.size() * normals.size();
        const double after = normals.system().size() * normals.system().size();
        worst = std::max(worst, (after / before - 1) / kEpsilon);
    }
    EXPECT_LE(worst, math::kClusterGain);
    EXPECT_GT(worst, math::kClusterGain / 10.0);
}

/// A rack between walls on two sides has a way out, on three it has none.
TEST(ClusterBounds, JamsAreFound) {
    Random random(424603);
    impact::symmetric::System<double> system;
    impact::symmetric::Projection<double> projection;
    for (int i = 0; i < 2000; ++i) {
        auto rack = rounded_rack(random, 32, 1);
        const bool closed = random.coin();
        for (int k = 0; k < 5; ++k) {
            const auto index = [](int row, int place) { return Rack<double>::index(row, place); };
            if (closed) rack.stage.wall(index(4, k), {1, 0});
            rack.stage.wall(index(k, 0), {-0.5, -std::sqrt(0.75)});
            rack.stage.wall(index(k, k), {-0.5, std::sqrt(0.75)});
        }
        system.load(rack.stage.cluster);
        EXPECT_EQ(projection.jammed(system, [](std::size_t) { return true; }), closed) << i;
    }
}

}  // namespace
}  // namespace osculo::support

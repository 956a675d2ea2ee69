#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "random_clusters.hpp"
#include "sequential.hpp"
#include "support/scalars.hpp"

// Clusters whose outcome is known otherwise.
namespace osculo::support {
namespace {

using impact::ClusterStatus;
using impact::SymmetricSolver;
using Point = math::Vec<double>;

template <class S>
class Simultaneous : public testing::Test {};
using Tested = testing::Types<float, double, long double, math::Quad, Digits50>;
TYPED_TEST_SUITE(Simultaneous, Tested, ScalarName);

TYPED_TEST(Simultaneous, OneContactIsTheBinaryLaw) {
    using S = TypeParam;
    Random random(424401);
    double worst = 0;
    SymmetricSolver<S> solver;
    for (int i = 0; i < (math::Builtin<S> ? 20000 : 500); ++i) {
        impact::Cluster<S> cluster;
        // The bounce of a ball that has less than 256 epsilon of |y| is lost.
        const int range = std::is_same_v<S, float> ? 3 : 20;
        for (int b = 0; b < 2; ++b) {
            cluster.balls.push_back({random.magnitude<S>(-range, range),
                                     random.magnitude<S>(-2, 2) * random.direction<S>()});
        }
        const S e = random.below(3) == 0 ? S(1) : random.coin() ? S(0) : random.unit<S>();
        const math::Vec<S> n = random.magnitude<S>(-5, 5) * random.direction<S>();
        const bool wall = random.coin();
        cluster.contacts.push_back({0, wall ? impact::kFixed : 1, n, e});
        auto before = cluster;
        auto expected = cluster;
        auto& v1 = expected.balls[0].velocity;
        auto& v2 = expected.balls[1].velocity;
        const math::Vec<S> approach = wall ? v1 : math::Vec<S>(v1 - v2);
        if (math::dot<S>(approach, n) > S(0)) {
            if (wall) {
                impact::Restitution::resolve<S>(e, n, v1);
            } else {
                impact::Restitution::resolve<S>(e, cluster.balls[0].mass, cluster.balls[1].mass, n,
                                                v1, v2);
            }
        }
        EXPECT_TRUE(solver.resolve(cluster).well_posed);
        const S scale =
            math::norm<S>(before.balls[0].velocity) + math::norm<S>(before.balls[1].velocity);
        for (std::size_t b = 0; b < 2; ++b) {
            const S off = math::norm_max<S>(cluster.balls[b].velocity - expected.balls[b].velocity);
            worst = std::max(worst, in_epsilons<S>(off / scale));
        }
    }
    EXPECT_LE(worst, 8);
}

/// A chain hit at its end whose masses fall or rise evenly enough that each contact closes once:
/// ball i keeps v_i (m_i - m_(i+1)) / (m_i + m_(i+1)) of the 2 m_i v_i / (m_i + m_(i+1)) it passes
/// on less its own v_i.
TYPED_TEST(Simultaneous, ChainsOfUnequalMassesPassTheBlowOn) {
    using S = TypeParam;
    for (const std::vector<S>& masses : {std::vector<S>{S(1), S(0.75), S(0.5), S(0.25), S(0.0625)},
                                         std::vector<S>{S(1), S(2), S(4), S(8), S(16), S(32)},
                                         std::vector<S>{S(1e6), S(1e3), S(1), S(0.001)},
                                         std::vector<S>{S(0.001), S(1), S(1e3), S(1e6)}}) {
        std::vector<S> speeds(masses.size(), S(0));
        speeds[0] = S(2);
        auto stage = chain<S>(speeds, S(1), masses);
        SymmetricSolver<S>().resolve(stage.cluster);
        S speed(2);
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const S next = i + 1 == masses.size() ? S(0) : masses[i + 1];
            const S kept = speed * (masses[i] - next) / (masses[i] + next);
            EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vx(i) / kept - S(1))), 64) << i;
            speed = S(2) * masses[i] * speed / (masses[i] + next);
        }
    }
}

TYPED_TEST(Simultaneous, WithoutRestitutionAChainOnAWallStops) {
    using S = TypeParam;
    auto stage = chain<S>({S(3), S(0), S(-1), S(0)}, S(0), {S(1), S(1000), S(0.001), S(5)});
    auto free = stage;
    SymmetricSolver<S> solver;
    solver.resolve(free.cluster);
    const S common = (S(3) - S(0.001)) / (S(1) + S(1000) + S(0.001) + S(5));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LE(in_epsilons<S>(math::abs<S>(free.vx(i) - common)), 32) << i;
    }
    stage.wall(3, {S(0.5), S(0)}, S(0));
    solver.resolve(stage.cluster);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vx(i))), 32) << i;
    }
}

/// A ball between two walls has nowhere to go across, and keeps its velocity along.
TYPED_TEST(Simultaneous, BetweenParallelWalls) {
    using S = TypeParam;
    for (const double e : {1.0, 0.5, 0.0}) {
        Stage<S> stage;
        stage.ball({S(0), S(0)}, {S(0.75), S(0.5)});
        stage.wall(0, {S(0), S(1)}, S(e));
        stage.wall(0, {S(0), S(-3)}, S(e));
        const auto outcome = SymmetricSolver<S>().resolve(stage.cluster);
        EXPECT_EQ(outcome.status, e > 0 ? ClusterStatus::jammed : ClusterStatus::separated);
        EXPECT_LE(outcome.reflections, 100);
        EXPECT_TRUE(outcome.no_approach);
        if (e > 0) {
            EXPECT_FALSE(outcome.well_posed);
        }
        EXPECT_EQ(stage.vx(0), S(0.75));
        EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vy(0))), 8);
    }
    // A chain hit along a channel that it fits in does not touch the walls.
    auto stage = chain<S>({S(1), S(0), S(0)}, S(1));
    for (std::size_t i = 0; i < 3; ++i) {
        stage.wall(i, {S(0), S(1)});
        stage.wall(i, {S(0), S(-1)});
    }
    const auto outcome = SymmetricSolver<S>().resolve(stage.cluster);
    EXPECT_EQ(outcome.status, ClusterStatus::separated);
    EXPECT_TRUE(outcome.well_posed);
    EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vx(2) - S(1))), 4);
}

/// Nor has one between two points that are opposite but for a small angle: it is turned back, by
/// impulses that exceed its momentum by the angle's inverse. Their rounding makes no energy.
TYPED_TEST(Simultaneous, BetweenPointsThatAreAllButOpposite) {
    using S = TypeParam;
    for (const double angle : {1e-2, 6e-8, 3e-12}) {
        if (in_epsilons<S>(S(angle)) < 1e3) continue;  // parallel walls, as far as S can tell
        Stage<S> stage;
        stage.ball({S(0), S(0)}, {S(0.75), S(0)});
        stage.wall(0, {S(angle), S(1)});
        stage.wall(0, {S(angle), S(-1)});
        SymmetricSolver<S>().resolve(stage.cluster);
        EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vx(0) + S(0.75))), 8) << angle;
        EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vy(0))), 8) << angle;
        // One that has others before and beside it has no energy to gain either; where it may be
        // turned back only after more reflections than the law allows, it loses some.
        stage = {};
        stage.ball({S(0), S(0)}, {S(0.75), S(-0.25)});
        stage.ball({S(-2), S(0.125)}, {S(1), S(0)}, S(3));
        stage.ball({S(2), S(-0.5)}, {S(-1), S(0.5)}, S(0.2));
        stage.wall(0, {S(angle) * root_of<S>(2), S(1)});
        stage.wall(0, {S(angle) / root_of<S>(3), S(-1)});
        stage.touch(1, 0);
        stage.touch(0, 2);
        const auto energy = [&] {
            S sum(0);
            for (const auto& ball : stage.cluster.balls) {
                sum += ball.mass * math::dot<S>(ball.velocity, ball.velocity);
            }
            return sum;
        };
        const S before = energy();
        const auto outcome = SymmetricSolver<S>().resolve(stage.cluster);
        const S gain = (energy() - before) / before;
        EXPECT_LE(in_epsilons<S>(gain), 256) << angle;
        if (outcome.status == ClusterStatus::separated) {
            EXPECT_LE(in_epsilons<S>(math::abs<S>(gain)), 256) << angle;
        }
    }
}

/// A ball that hits a heavy one and a wall beside it: in the metric of the masses these are all but
/// the same, yet each gets what is its own.
TYPED_TEST(Simultaneous, ImpulsesAreThoseOfTheirOwnContacts) {
    using S = TypeParam;
    Stage<S> stage;
    const S heavy = S(1) / (math::epsilon<S>() * S(64));
    stage.ball({S(0), S(0)}, {S(-500), S(0)});
    stage.ball({S(-1), S(0)}, {S(0), S(0)}, heavy);
    stage.touch(0, 1);
    stage.wall(0, {S(-1), S(0)});
    SymmetricSolver<S>().resolve(stage.cluster);
    // The wall turns it back, whichever of them is first.
    EXPECT_LE(in_epsilons<S>(math::abs<S>(stage.vx(0) - S(500))), 500 * 256);
    const auto& contacts = stage.cluster.contacts;
    const S given = heavy * stage.vx(1);
    EXPECT_LE(math::abs<S>(contacts[0].impulse + given), S(1));
    EXPECT_LE(math::abs<S>(contacts[0].impulse + contacts[1].impulse - S(1000)), S(1));
}

/// A light ball between heavy ones, the last of which touches a fourth one: the cap ends it,
/// without an approach and without a gain, and it is said.
TEST(SimultaneousInDouble, TheCapEndsInAnInelasticImpact) {
    auto stage = chain<double>({1, 0, 0, 0}, 1, {1e6, 1e-6, 1e6, 1e6});
    auto outcome = SymmetricSolver<double>().resolve(stage.cluster);
    EXPECT_EQ(outcome.status, ClusterStatus::capped);
    EXPECT_TRUE(outcome.no_approach);
    EXPECT_FALSE(outcome.well_posed);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GE(stage.vx(i) - stage.vx(i - 1), -1e-9);
    EXPECT_NEAR(stage.vx(0) + stage.vx(2) + stage.vx(3), 1, 1e-9);
    // Galperin's count: pi / arctan(...) reflections where they are made one by one.
    auto short_stage = chain<double>({1, 0, 0}, 1, {400, 1, 400});
    outcome = SymmetricSolver<double>().resolve(short_stage.cluster);
    EXPECT_EQ(outcome.status, ClusterStatus::separated);
    const double beta = std::acos(1 / (1 + 1.0 / 400) / 1.0);
    EXPECT_NEAR(outcome.reflections, std::acos(-1.0) / beta, 1.5);
}

TYPED_TEST(Simultaneous, WellPosedWedges) {
    using S = TypeParam;
    const S tolerance = math::square_root<S>(math::epsilon<S>());
    const double pi = std::acos(-1.0);
    const auto posed = [&](double angle, bool elastic) {
        return impact::symmetric::wedge_is_well_posed<S>(S(std::cos(angle)), elastic,
                                                         std::max(tolerance, S(1e-12)));
    };
    for (int n = 2; n <= 40; ++n) {
        EXPECT_TRUE(posed(pi / n, true)) << n;
        EXPECT_EQ(posed(pi / n, false), n == 2) << n;
        if (std::is_same_v<S, float> && n > 12) continue;
        EXPECT_FALSE(posed(pi / (n + 0.1), true)) << n;
        EXPECT_FALSE(posed(pi / (n - 0.1), true)) << n;
    }
    EXPECT_FALSE(posed(2 * pi / 3, true));
    EXPECT_FALSE(posed(2 * pi / 5, true));
    EXPECT_FALSE(posed(104.4775 / 180 * pi, true));
    EXPECT_TRUE(posed(pi, false));  // one contact, named twice
}

double fastest(const impact::Cluster<double>& cluster) {
    double speed = 0;
    for (const auto& ball : cluster.balls) {
        speed = std::max(speed, math::norm<double>(ball.velocity));
    }
    return speed;
}

/// What is well posed has one outcome, in whatever order pairs are taken.
TEST(SimultaneousInDouble, WellPosedClustersDoNotDependOnTheLaw) {
    Random random(424402);
    SymmetricSolver<double> solver;
    int posed = 0;
    int differ = 0;
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const RandomCluster<double> source(random, 1);
        if (source.e < 0.5) continue;
        auto cluster = source.stage.cluster;
        const auto outcome = solver.resolve(cluster);
        if (outcome.status != ClusterStatus::separated) continue;
        bool same = true;
        for (const Order order : {Order::most_approaching, Order::first, Order::last}) {
            auto other = source.stage.cluster;
            resolve_sequentially<double>(other, 1e-12 * fastest(other), order);
            double off = 0;
            double size = 0;
            for (std::size_t b = 0; b < other.balls.size(); ++b) {
                const double root = std::sqrt(other.balls[b].mass);
                off = std::max(off, root * math::norm_max<double>(cluster.balls[b].velocity -
                                                                  other.balls[b].velocity));
                size = std::hypot(
                    size, root * math::norm<double>(source.stage.cluster.balls[b].velocity));
            }
            if (!outcome.well_posed) {
                same = same && off < 1e-6 * size;
                continue;
            }
            worst = std::max(worst, off / (size + 1e-300));
            ASSERT_LE(off, 1e-10 * size) << "case " << i << ": " << source.described();
        }
        posed += outcome.well_posed;
        differ += !same;
    }
    std::printf("  %d well posed, largest difference %.2g; %d others differ\n", posed, worst,
                differ);
    EXPECT_GT(posed, 10000);
    EXPECT_GT(differ, 10000);
}

}  // namespace
}  // namespace osculo::support

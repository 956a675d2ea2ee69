#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random_clusters.hpp"
#include "sequential.hpp"
#include "support/scalars.hpp"

// Light balls between heavy ones and walls, struck to and fro very often.
namespace osculo::support {
namespace {

using impact::ClusterStatus;
using impact::SymmetricSolver;

template <class S>
class WedgeOf : public testing::Test {};
using Tested = testing::Types<double, long double, math::Quad, Digits50>;
TYPED_TEST_SUITE(WedgeOf, Tested, ScalarName);

/// The sums are those of one reflection after the other, to as many as there can be.
TEST(Wedge, SumsAreThoseOfTheRecursion) {
    using R = math::Quad;
    Random random(424701);
    impact::symmetric::Wedge<double> wedge;
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const double beta = random.magnitude<double>(-14, -4);
        const double phase = random.uniform(0, 3);
        // s(x) = -sin(phase + x), and the other contact where that has it at x = beta.
        const double versine = 2 * std::sin(beta / 2) * std::sin(beta / 2);
        const double closing = -std::sin(phase);
        const double next = -std::sin(phase + beta) - 2 * (1 - versine) * closing;
        const bool limited = random.coin();
        const double most =
            limited ? random.unit<double>() / beta : std::numeric_limits<double>::infinity();
        const auto found = wedge.reflections(closing, next, versine,
                                             [&](double first, double) { return first <= most; });
        R first(0), second(0), sums[3][2] = {};
        R s = R(closing);
        R after = R(next) + R(2) * (R(1) - R(versine)) * s;
        // Pairs of reflections; that before and that after the last one, too.
        for (bool ended = false; !ended;) {
            sums[0][0] = sums[1][0], sums[0][1] = sums[1][1];
            sums[1][0] = first, sums[1][1] = second;
            first -= R(2) * s;
            second -= R(2) * after;
            sums[2][0] = first, sums[2][1] = second;
            s = R(2) * (R(1) - R(versine)) * after - s;
            ended = !(after < R(0)) || !(s < R(0)) || !(first <= R(most));
            after = R(2) * (R(1) - R(versine)) * s - after;
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& sum : sums) {
            nearest = std::min(nearest, std::abs(found.first - math::to_double<R>(sum[0])) +
                                            std::abs(found.second - math::to_double<R>(sum[1])));
        }
        // Next to the end s is next to nothing, and so is what a pair more or less adds.
        const double share = nearest * beta / math::epsilon<double>() * beta;
        worst = std::max(worst, share);
        ASSERT_LE(share, 64) << i << " " << beta << " " << phase << " " << limited;
    }
    std::printf("  sums err by %.2f epsilon / beta of themselves\n", worst);
}

/// Galperin's billiard in one instant: a heavy ball comes to a light one that touches a wall. The
/// angle in the metric of the masses is theta = atan(sqrt(m / M)); after k blows between the balls
/// the heavy one has cos(2 k theta) of its speed.
TYPED_TEST(WedgeOf, HeavyBallOnALightOneAtAWall) {
    using S = TypeParam;
    using R = Digits100;
    Random random(424702);
    const R pi = boost::math::constants::pi<R>();
    double worst_heavy = 0, worst_light = 0;
    for (int i = 0; i < (math::Builtin<S> ? 2000 : 200); ++i) {
        const S heavy = random.magnitude<S>(0, 64);
        const S speed = random.magnitude<S>(-10, 10);
        auto stage = chain<S>({speed, S(0)}, S(1), {heavy, S(1)});
        stage.wall(1, {S(1), S(0)});
        const auto outcome = SymmetricSolver<S>().resolve(stage.cluster);
        ASSERT_EQ(outcome.status, ClusterStatus::separated) << bits<S>(heavy);
        ASSERT_TRUE(outcome.no_approach);
        ASSERT_LE(outcome.reflections, 100);
        const R theta = atan(1 / sqrt(exact<R>(heavy)));
        const R count = ceil(pi / theta) - 1;
        const R blows = ceil(count / 2);
        const R turned = 2 * blows * theta;
        const R light = (2 * blows > count ? 1 : -1) * sin(turned);
        const R got_heavy = exact<R>(stage.vx(0)) / exact<R>(speed);
        const R got_light = exact<R>(stage.vx(1)) / exact<R>(speed) / sqrt(exact<R>(heavy));
        const R eps = exact<R>(math::epsilon<S>());
        worst_heavy = std::max(worst_heavy, double(abs(got_heavy - cos(turned)) / eps));
        // Its place in the wedge is known to epsilon over the angle of that.
        worst_light = std::max(worst_light, double(abs(got_light - light) * theta / eps));
    }
    std::printf("  heavy: %.2f epsilon, light: %.2f epsilon / theta\n", worst_heavy, worst_light);
    EXPECT_LE(worst_heavy, 32);
    EXPECT_LE(worst_light, 32);
}

/// Any two contacts, in a row or not, of balls of 1e-9 to 1e9 kg: energy and momentum are kept, and
/// everything parts.
TYPED_TEST(WedgeOf, KeepsEnergyAndMomentum) {
    using S = TypeParam;
    Random random(424703);
    double energies = 0, momenta = 0;
    SymmetricSolver<S> solver;
    for (int i = 0; i < (math::Builtin<S> ? 20000 : 500); ++i) {
        Stage<S> stage;
        const bool row = random.coin();
        const S bend = row ? S(0) : S(random.magnitude<S>(-20, 0));
        stage.ball({S(-2), bend}, {random.unit<S>(), S(0)}, random.magnitude<S>(-30, 30));
        stage.ball({S(0), S(0)}, {S(0), S(0)}, random.magnitude<S>(-30, 30));
        stage.ball({S(2), S(0)}, {S(-random.unit<S>()), S(0)}, random.magnitude<S>(-30, 30));
        stage.touch(0, 1);
        const bool wall = random.below(3) == 0;
        if (wall) {
            stage.wall(1, {S(1), S(0)});
        } else {
            stage.touch(1, 2);
        }
        const auto before = stage.cluster;
        const auto outcome = solver.resolve(stage.cluster);
        ASSERT_EQ(outcome.status, ClusterStatus::separated) << i;
        ASSERT_TRUE(outcome.no_approach) << i;
        const auto eps = exact<Digits100>(math::epsilon<S>());
        const Digits100 start = energy<Digits100, S>(before);
        energies = std::max(energies,
                            double(abs(energy<Digits100, S>(stage.cluster) - start) / start / eps));
        if (wall) continue;
        Digits100 sum(0), size(0);
        for (std::size_t b = 0; b < 3; ++b) {
            const auto m = exact<Digits100>(before.balls[b].mass);
            const auto is = exact<Digits100>(stage.vx(b));
            const auto was = exact<Digits100>(before.balls[b].velocity.x());
            sum += m * (is - was);
            size += m * (abs(is) + abs(was));
        }
        momenta = std::max(momenta, double(abs(sum) / size / eps));
    }
    std::printf("  energy: %.2f epsilon, momentum: %.2f\n", energies, momenta);
    EXPECT_LE(energies, math::kClusterEnergy);
    EXPECT_LE(momenta, 64);
}

/// A heavy ball that turns round runs into what follows it: before the light one is back.
TEST(Wedge, EndsWhereAThirdContactBegins) {
    for (const double heavy : {1e3, 1e5}) {
        for (const double follows : {0.9, 0.5, -0.2, -0.7}) {
            auto stage = chain<math::Quad>(
                {math::Quad(follows), math::Quad(1), math::Quad(0)}, math::Quad(1),
                {math::Quad(heavy / 3), math::Quad(heavy), math::Quad(1)});
            stage.wall(2, {math::Quad(1), math::Quad(0)});
            auto turned = chain<double>({follows, 1, 0}, 1, {heavy / 3, heavy, 1});
            turned.wall(2, {1, 0});
            const int steps =
                resolve_sequentially<math::Quad>(stage.cluster, math::Quad(1e-25), Order::first);
            const auto outcome = SymmetricSolver<double>().resolve(turned.cluster);
            EXPECT_EQ(outcome.status, ClusterStatus::separated);
            // Until then, all at once.
            if (heavy > 1e4 && follows < 0) {
                EXPECT_LT(outcome.reflections, steps * 3 / 4);
            }
            for (std::size_t b = 0; b < 3; ++b) {
                EXPECT_NEAR(turned.vx(b), math::to_double<math::Quad>(stage.vx(b)), 1e-9)
                    << heavy << " " << follows << " " << b;
            }
        }
    }
}

/// What is 1e27 times as heavy as a ball that cannot yield is stopped by it, as rounding has it:
/// that is said.
TEST(Wedge, WhatRoundingHidesIsSaid) {
    auto stage = chain<double>({1, 0}, 1, {1e30, 1});
    stage.wall(1, {1, 0});
    const auto outcome = SymmetricSolver<double>().resolve(stage.cluster);
    EXPECT_TRUE(outcome.status == ClusterStatus::unresolved || !outcome.no_approach);
}

}  // namespace
}  // namespace osculo::support

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "random_clusters.hpp"
#include "support/scalars.hpp"

// Laws that hold of every cluster, over random ones.
namespace osculo::support {
namespace {

using impact::ClusterStatus;
using impact::SymmetricSolver;

template <class S>
inline constexpr int kCases = std::is_same_v<S, double> ? 100000
                              : math::Builtin<S>        ? 20000
                                                        : 1000;

/// Light balls between heavy ones are reflected to and fro as often as pi over the root of the
/// masses' ratio.
constexpr int kCap = 1000;

template <class S>
class RandomClusters : public testing::Test {};
using Tested = testing::Types<float, double, long double, math::Quad>;
TYPED_TEST_SUITE(RandomClusters, Tested, ScalarName);

TYPED_TEST(RandomClusters, LawsOfMechanics) {
    using S = TypeParam;
    using R = std::conditional_t<std::is_same_v<S, float> || std::is_same_v<S, double>, long double,
                                 ExactFor<S>>;
    using std::abs;
    const R eps = exact<R>(math::epsilon<S>());
    Random random(424201);
    SymmetricSolver<S> solver(kCap);
    double gain = 0, loss = 0, momentum = 0, approach = 0;
    int capped = 0, jammed = 0, left = 0, most = 0;
    double reflections = 0;
    for (int i = 0; i < kCases<S>; ++i) {
        const RandomCluster<S> before(random, std::is_same_v<S, float> ? 3 : 6);
        auto cluster = before.stage.cluster;
        const auto outcome = solver.resolve(cluster);
        const auto label = [&] { return "case " + std::to_string(i) + ": " + before.described(); };
        capped += outcome.status == ClusterStatus::capped;
        jammed += outcome.status == ClusterStatus::jammed;
        left += !outcome.no_approach;
        reflections += outcome.reflections;
        most = std::max(most, outcome.reflections);

        const R start = energy<R, S>(before.stage.cluster);
        if (start == 0) continue;
        const R steps = R(1 + outcome.reflections);
        const auto change = static_cast<double>(R((energy<R, S>(cluster) - start) / start / eps));
        gain = std::max(gain, change / static_cast<double>(steps));
        ASSERT_LE(change, 16 * static_cast<double>(steps)) << label();
        if (before.same_restitution && before.e == S(1) &&
            outcome.status == ClusterStatus::separated) {
            loss = std::max(loss, -change / static_cast<double>(steps));
            ASSERT_GE(change, -16 * static_cast<double>(steps)) << label();
        }
        R px(0), py(0), size(0);
        for (std::size_t b = 0; b < cluster.balls.size(); ++b) {
            const R m = exact<R>(cluster.balls[b].mass);
            const auto& v = before.stage.cluster.balls[b].velocity;
            const auto& w = cluster.balls[b].velocity;
            px += m * (exact<R>(w.x()) - exact<R>(v.x()));
            py += m * (exact<R>(w.y()) - exact<R>(v.y()));
            size += m * exact<R>(S(math::norm<S>(v) + math::norm<S>(w)));
        }
        if (!before.walls) {
            const auto error = static_cast<double>(R((abs(px) + abs(py)) / size / eps / steps));
            momentum = std::max(momentum, error);
            ASSERT_LE(error, 16) << label();
        }
        const math::Vec<S> rest(S(0), S(0));
        for (const auto& c : cluster.contacts) {
            ASSERT_GE(c.impulse, S(0)) << label();
            const auto& v = cluster.balls[c.one].velocity;
            const auto& w = c.other == impact::kFixed ? rest : cluster.balls[c.other].velocity;
            const S closing = math::dot<S>(v - w, c.normal) / math::norm<S>(c.normal);
            if (!(closing > S(0))) continue;
            const S noise = solver.noise(static_cast<std::size_t>(&c - &cluster.contacts[0]));
            const double share = math::to_double<S>(closing / noise);
            approach = std::max(approach, share);
            if (outcome.no_approach) {
                ASSERT_LE(share, 2) << label();
            }
        }
    }
    std::printf(
        "  %d clusters, %.2f reflections on average, at most %d; capped %d, jammed %d, left %d\n"
        "  in epsilons: gain %.2f and loss %.2f per step, momentum %.2f per step, approach %.2f of "
        "noise\n",
        kCases<S>, reflections / kCases<S>, most, capped, jammed, left, gain, loss, momentum,
        approach);
    EXPECT_EQ(left, 0);
    EXPECT_LE(capped, kCases<S> / 40);  // rows of balls from 1e-6 to 1e6
}

}  // namespace
}  // namespace osculo::support

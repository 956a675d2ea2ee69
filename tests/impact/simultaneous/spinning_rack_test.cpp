#include <algorithm>

#include <gtest/gtest.h>

#include "clusters.hpp"
#include "osculo/impact/symmetric/surface.hpp"
#include "support/scalars.hpp"

// A rack with friction between its balls.
namespace osculo::support {
namespace {

template <class S>
class SpinningRack : public testing::Test {};
TYPED_TEST_SUITE(SpinningRack, AllScalars, ScalarName);

template <math::Scalar S>
impact::SpinningCluster<S> spinning(const Rack<S>& rack, const impact::Friction<S>& friction) {
    impact::SpinningCluster<S> cluster;
    for (const auto& ball : rack.stage.cluster.balls) {
        cluster.balls.push_back(
            {ball.mass, S(1), fraction<S>(2, 5), ball.velocity, {S(0), S(0), S(0)}});
    }
    for (const auto& contact : rack.stage.cluster.contacts) {
        cluster.contacts.push_back(
            {contact.one, contact.other, contact.normal, contact.restitution, friction});
    }
    return cluster;
}

/// A straight break with a rolling cue ball: mirror pairs move and spin alike.
TYPED_TEST(SpinningRack, IsSymmetric) {
    using S = TypeParam;
    const Rack<S> rack({S(1), S(0)}, fraction<S>(19, 20));
    auto cluster = spinning<S>(rack, {fraction<S>(1, 20), S(0), S(0)});
    cluster.balls[0].spin = {S(0), S(1), S(0)};
    const auto outcome = impact::SymmetricSolver<S>().resolve(cluster);
    EXPECT_TRUE(outcome.no_approach);
    EXPECT_TRUE(outcome.friction_settled);
    S worst(0);
    const auto regard = [&](const S& x) { worst = std::max(worst, math::abs<S>(x)); };
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            const auto& a = cluster.balls[Rack<S>::index(row, place)];
            const auto& b = cluster.balls[Rack<S>::index(row, row - place)];
            regard(a.velocity.x() - b.velocity.x());
            regard(a.velocity.y() + b.velocity.y());
            regard(a.spin.x() + b.spin.x());
            regard(a.spin.y() - b.spin.y());
            regard(a.spin.z() + b.spin.z());
        }
    }
    // What the shares of balls that bear together, and the last sweep, leave.
    EXPECT_LE(math::to_double<S>(worst), 1e-11);
    // Friction turned the balls beside the axis, and not that at the tip.
    EXPECT_GT(math::abs<S>(cluster.balls[Rack<S>::index(1, 0)].spin.z()), S(1e-3));
    EXPECT_LE(math::to_double<S>(math::abs<S>(cluster.balls[1].spin.z())), 1e-11);
}

TYPED_TEST(SpinningRack, WithoutFrictionIsTheRackWithoutSpins) {
    using S = TypeParam;
    const Rack<S> rack({S(1), S(0.25)}, S(1));
    auto plain = rack.stage.cluster;
    auto cluster = spinning<S>(rack, {S(0), S(0), S(0)});
    impact::SymmetricSolver<S> solver;
    solver.resolve(plain);
    solver.resolve(cluster);
    for (std::size_t i = 0; i < plain.balls.size(); ++i) {
        EXPECT_EQ(plain.balls[i].velocity, cluster.balls[i].velocity);
        EXPECT_EQ(cluster.balls[i].spin, math::Vec3<S>(S(0), S(0), S(0)));
    }
}

/// A ball that presses a slowly turning one against an upright cushion. Both contacts hold, so with
/// the impulses Q between the balls and C at the cushion (k = 2/5, all in units of the spin w):
/// no slip at the cushion, 3/2 Q + 7/2 C = 1; none between, 7 Q + 3/2 C = 1. Q = 8/89, C = 22/89.
TYPED_TEST(SpinningRack, ABallAgainstACushionIsHeldByBoth) {
    using S = TypeParam;
    impact::SpinningCluster<S> cluster;
    const math::Vec<S> rest(S(0), S(0));
    cluster.balls.push_back({S(1), S(1), fraction<S>(2, 5), {S(1), S(0)}, {S(0), S(0), S(0)}});
    cluster.balls.push_back({S(1), S(1), fraction<S>(2, 5), rest, {S(0), S(0), S(0.001)}});
    const impact::Frictional<S> balls{S(0), {fraction<S>(1, 2), S(0), S(0)}};
    const impact::CushionSimple<S> cushion{S(0), fraction<S>(1, 2)};
    const math::Vec<S> n(S(1), S(0));
    cluster.contacts.push_back(impact::contact<S>(0, 1, n, impact::surface(balls)));
    cluster.contacts.push_back(
        impact::contact<S>(1, impact::kFixed, n, impact::surface(cushion, S(1))));
    const auto outcome = impact::SymmetricSolver<S>().resolve(cluster);
    EXPECT_TRUE(outcome.friction_settled);
    const S w = S(0.001) / S(89);
    const S expected[] = {S(-8) * w, S(-20) * w, S(-14) * w, S(14) * w};
    const S found[] = {cluster.balls[0].velocity.y(), cluster.balls[0].spin.z(),
                       cluster.balls[1].velocity.y(), cluster.balls[1].spin.z()};
    for (int i = 0; i < 4; ++i) {
        EXPECT_LE(in_epsilons<S>(math::abs<S>(found[i] - expected[i])), 4) << i;
    }
}

}  // namespace
}  // namespace osculo::support

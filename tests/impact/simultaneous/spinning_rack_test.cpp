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

/// A ball that presses one against an upright cushion, both spinning: the hands of a clock. Bounds
/// and signs by hand.
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
    // Everything sticks: no slip at either contact, so ball 1 neither moves along the cushion
    // without rolling on it nor turns against ball 0 without turning it.
    const auto& a = cluster.balls[0];
    const auto& b = cluster.balls[1];
    const double at_cushion = math::to_double<S>(b.velocity.y() + b.spin.z());
    const double between =
        math::to_double<S>(a.velocity.y() + a.spin.z() - (b.velocity.y() - b.spin.z()));
    EXPECT_NEAR(at_cushion, 0, 1e-17);
    EXPECT_NEAR(between, 0, 1e-17);
    // The least energy at that: with x = spin.z of ball 1 from w0, y = -x its velocity, p and q
    // those of ball 0, q = (2/5 p)... is 2/5 of what ball 0 has as velocity.
    EXPECT_GT(math::to_double<S>(b.spin.z()), 0.0);
    EXPECT_LT(math::to_double<S>(b.spin.z()), 0.001);
    EXPECT_LT(math::to_double<S>(a.velocity.y()), 0.0);
    EXPECT_LT(math::to_double<S>(a.spin.z()), 0.0);
}

}  // namespace
}  // namespace osculo::support

#include <gtest/gtest.h>

#include "clusters.hpp"
#include "engine/allocation/counting_new.hpp"
#include "support/scalars.hpp"

namespace osculo::support {
namespace {

template <class S>
class SymmetricMemory : public testing::Test {};
TYPED_TEST_SUITE(SymmetricMemory, AllScalars, ScalarName);

/// A solver that has seen a cluster allocates nothing for it or a smaller one.
TYPED_TEST(SymmetricMemory, NothingAfterTheFirst) {
    using S = TypeParam;
    impact::SymmetricSolver<S> solver;
    const Rack<S> rack({S(1), S(0.125)}, fraction<S>(19, 20));
    auto warm_up = rack.stage.cluster;
    auto again = rack.stage.cluster;
    auto smaller = chain<S>({S(1), S(0), S(-1), S(2)}, S(0.5));
    solver.resolve(warm_up);
    const std::uint64_t before = allocations();
    solver.resolve(again);
    solver.resolve(smaller.cluster);
    EXPECT_EQ(allocations(), before);
    for (std::size_t i = 0; i < again.balls.size(); ++i) {
        EXPECT_EQ(again.balls[i].velocity, warm_up.balls[i].velocity);
    }
}

TYPED_TEST(SymmetricMemory, NothingForFriction) {
    using S = TypeParam;
    const Rack<S> rack({S(1), S(0.125)}, fraction<S>(19, 20));
    impact::SpinningCluster<S> cluster;
    for (const auto& ball : rack.stage.cluster.balls) {
        cluster.balls.push_back(
            {ball.mass, S(1), fraction<S>(2, 5), ball.velocity, {S(0), S(0.25), S(1)}});
    }
    for (const auto& contact : rack.stage.cluster.contacts) {
        cluster.contacts.push_back({contact.one,
                                    contact.other,
                                    contact.normal,
                                    contact.restitution,
                                    {fraction<S>(1, 20), S(0), S(0)}});
    }
    impact::SymmetricSolver<S> solver;
    auto warm_up = cluster;
    auto again = cluster;
    solver.resolve(warm_up);
    const std::uint64_t before = allocations();
    solver.resolve(again);
    EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace osculo::support

#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

// Impacts that would follow each other without end: rows that collapse, balls squeezed between
// others and a wall, an inelastic gas. What closes too slowly does not bounce, so they all end.
namespace osculo::support {
namespace {

template <class S>
class Accumulating : public ::testing::Test {};
TYPED_TEST_SUITE(Accumulating, NativeScalars, ScalarName);

/// A ball comes from the left with speed 1 onto a row of others at rest with gaps between them.
template <math::Scalar S>
Builder<SymmetricTable<S>> row(int count, double restitution, double gap) {
    using Vec = math::Vec<S>;
    Builder<SymmetricTable<S>> builder;
    for (int k = 0; k < count; ++k) {
        builder.ball(Vec(S(k) * S(2 + gap) - S(k == 0 ? 3 : 0), S(0)),
                     Vec(S(k == 0 ? 1 : 0), S(0)));
    }
    builder.restitution(S(restitution), S(restitution));
    builder.scene.rest_speed = S(1e-6);
    return builder;
}

/// The run ends within so many events, keeps to the laws, and nothing that touches closes.
template <math::Scalar S>
Played<SymmetricTable<S>> expect_end(const Builder<SymmetricTable<S>>& builder, double time,
                                     std::uint64_t most_events, const std::string& name) {
    auto played = play<SymmetricTable<S>>(builder.scene, S(time), most_events + 1);
    EXPECT_NE(played.status, Status::event_limit) << name;
    EXPECT_NE(played.status, Status::zeno) << name;
    EXPECT_NE(played.status, Status::numeric) << name;
    const engine::RunAudit audit = played.audit();
    EXPECT_TRUE(audit.clean) << name << " " << describe(audit);
    EXPECT_LE(audit.energy_final, audit.energy_initial) << name;
    return played;
}

TYPED_TEST(Accumulating, RowsCollapse) {
    using S = TypeParam;
    for (const double restitution : {0.0, 0.1, 0.5, 0.9}) {
        for (const double gap : {0.0, 1e-12, 1e-3, 0.3}) {
            for (const int count : {3, 5, 8, 15, 20}) {
                const std::string name = std::to_string(count) +
                                         " balls, e = " + std::to_string(restitution) + ", gap " +
                                         std::to_string(gap);
                const auto played =
                    expect_end<S>(row<S>(count, restitution, gap), 1000, 4000, name);
                if (restitution == 0 && gap == 0) {  // one impact of all of them
                    EXPECT_EQ(played.events, static_cast<std::uint64_t>(count - 1)) << name;
                    EXPECT_EQ(played.record.events.back().cluster.number, count > 2 ? 1U : 0U);
                }
                S momentum(0);
                for (const auto& body : played.bodies) momentum += body.state.velocity.x();
                EXPECT_LT(in_epsilons<S>(math::abs<S>(momentum - S(1))), 2000) << name;
            }
        }
    }
}

// Ever smaller bounces go on until rounding ends them, and in wide types that takes long.
TYPED_TEST(Accumulating, WithoutACutOffTheyTakeTheirTime) {
    using S = TypeParam;
    auto builder = row<S>(15, 0.5, 1e-3);
    const auto cut = play<SymmetricTable<S>>(builder.scene, S(1000), 100000);
    builder.scene.rest_speed = S(0);
    const auto uncut = play<SymmetricTable<S>>(builder.scene, S(1000), 100000);
    EXPECT_GT(uncut.events, cut.events + cut.events / 4);
    // The collapse magnifies what it changes, a thousandfold here.
    for (std::size_t k = 0; k < cut.bodies.size(); ++k) {
        const S change = math::abs<S>(cut.velocity(k).x() - uncut.velocity(k).x());
        EXPECT_LT(math::to_double<S>(change), 2e-3) << k;
    }
}

/// Three balls that bounce between two walls until nothing moves any more.
TYPED_TEST(Accumulating, BetweenWallsTheyComeToRest) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (const double e : {0.0, 0.05, 0.1, 0.5}) {
        Builder<SymmetricTable<S>> builder;
        builder.wall(Vec(S(0), S(-9)), Vec(S(0), S(9)))
            .wall(Vec(S(8), S(-9)), Vec(S(8), S(9)))
            .ball(Vec(S(1.5), S(0)), Vec(S(-1), S(0)))
            .ball(Vec(S(4), S(0)), Vec(S(0.7), S(0)))
            .ball(Vec(S(6.5), S(0)), Vec(S(-0.3), S(0)))
            .restitution(S(e), S(e));
        builder.scene.rest_speed = S(1e-6);
        const auto played = expect_end<S>(builder, 1e9, 1000, "e = " + std::to_string(e));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LT(math::to_double<S>(math::abs<S>(played.velocity(k).x())), 1e-6) << e;
        }
    }
}

/// A ball between a wall and a heavy one that comes on: squeezed ever faster if elastic, stuck
/// between them if not.
TYPED_TEST(Accumulating, ASqueezedBallGetsStuckOrPushesBack) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (const double e : {0.0, 0.1, 0.5, 0.9}) {
        Builder<SymmetricTable<S>> builder;
        builder.wall(Vec(S(0), S(-9)), Vec(S(0), S(9)))
            .ball(Vec(S(1.5), S(0)), Vec(S(0), S(0)))
            .ball(Vec(S(6), S(0)), Vec(S(-1), S(0)), S(1), S(100))
            .restitution(S(e), S(e));
        builder.scene.rest_speed = S(1e-6);
        const auto played = expect_end<S>(builder, 1000, 1000, "e = " + std::to_string(e));
        EXPECT_GE(math::to_double<S>(played.velocity(1).x()), -1e-5) << e;
        EXPECT_GE(math::to_double<S>(played.position(0).x()), 1 - 1e-12) << e;
    }
}

TYPED_TEST(Accumulating, AnInelasticGasCoolsDown) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (const double e : {0.1, 0.5}) {
        Builder<SymmetricTable<S>> builder;
        Random random(7);
        for (int k = 0; k < 25; ++k) {
            builder.ball(Vec(S(1.3 + 2.4 * (k % 5)), S(1.3 + 2.4 * (k / 5))),
                         Vec(random.signed_unit<S>(), random.signed_unit<S>()));
        }
        builder.box(S(0), S(0), S(12.2), S(12.2)).restitution(S(e), S(e));
        builder.scene.rest_speed = S(1e-6);
        const auto played = expect_end<S>(builder, 200, 30000, "e = " + std::to_string(e));
        EXPECT_LT(played.audit().energy_final, 0.01 * played.audit().energy_initial) << e;
    }
}

}  // namespace
}  // namespace osculo::support

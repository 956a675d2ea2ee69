#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

// Impact parameters of (1 -+ 10^-k) (r1 + r2): the barely hits and the barely misses.
namespace osculo::support {
namespace {

template <class S>
class Grazing : public ::testing::Test {};
TYPED_TEST_SUITE(Grazing, AllScalars, ScalarName);

template <math::Scalar S>
engine::SceneData<TableScene<S>> graze(const S& impact_parameter) {
    using Vec = math::Vec<S>;
    Builder<TableScene<S>> builder;
    builder.ball(Vec(S(-4), S(0)), Vec(S(1), S(0)), S(1))
        .ball(Vec(S(4), S(0)), Vec(S(0), S(0)), S(1));
    // Below the resolution of S for the largest k: the place is wide.
    builder.scene.bodies[1].state.position.y =
        math::Wide<S>(S(2)) + math::Wide<S>(impact_parameter - S(2));
    return builder.scene;
}

TYPED_TEST(Grazing, HitsAreHitAndMissesAreMissed) {
    using S = TypeParam;
    for (int k = 1; k <= 16; ++k) {
        const S part = power_of_ten<S>(-k);
        const S inside = S(2) - S(2) * part;
        const S outside = S(2) + S(2) * part;
        // The last ones may round to the sum of radii itself, which is a touch without approach.
        if (inside < S(2)) {
            const auto hit = play<TableScene<S>>(graze<S>(inside), S(20));
            ASSERT_EQ(hit.events, 1u) << k;
            const engine::RunAudit audit = hit.audit();
            ASSERT_TRUE(audit.clean) << k << " " << describe(audit);
            // Equal masses swap normal speeds: the second ball gets cos^2 = 1 - (b / 2)^2 along x.
            const S expected = (S(2) - inside) * (S(2) + inside) / S(4);
            const S relative = math::abs<S>(hit.velocity(1).x() / expected - S(1));
            // The condition of the problem: a rounding of place counts 1 / part.
            ASSERT_LT(math::to_double<S>(relative * part / math::epsilon<S>()), 32) << k;
        }
        const auto miss = play<TableScene<S>>(graze<S>(outside), S(20));
        ASSERT_EQ(miss.events, 0u) << k;
        ASSERT_TRUE(miss.audit().clean) << k;
    }
    EXPECT_EQ(play<TableScene<S>>(graze<S>(S(2)), S(20)).events, 0u);
}

TYPED_TEST(Grazing, WallsThatEndWhereTheBallPasses) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    // Along a wall at the ball's radius, and at 10^-k more or less from its end point.
    for (int k = 1; k <= 16; ++k) {
        const S part = power_of_ten<S>(-k);
        for (const S& distance : {S(S(1) - part), S(1), S(S(1) + part)}) {
            Builder<TableScene<S>> builder;
            builder.wall(Vec(S(0), S(0)), Vec(S(0), S(-9)))
                .ball(Vec(S(-5), S(0)), Vec(S(1), S(0)), S(1));
            builder.scene.bodies[0].state.position.y = distance;
            const auto played = play<TableScene<S>>(builder.scene, S(20));
            ASSERT_EQ(played.events, distance < S(1) ? 1u : 0u) << k;
            ASSERT_TRUE(played.audit().clean) << k << " " << describe(played.audit());
        }
    }
}

}  // namespace
}  // namespace osculo::support

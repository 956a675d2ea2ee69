#include <gtest/gtest.h>

#include "support/laws.hpp"
#include "support/random.hpp"

// Newton's cradle, touching and with gaps down to far below the resolution of the balls' places.
namespace osculo::support {
namespace {

template <class U>
class Cradle : public ::testing::Test {};
TYPED_TEST_SUITE(Cradle, AllUnderBoth, UnderName);

/// [incoming] of [count] balls of radius 1 come from the left, the others wait with [gap] between.
template <class Type, class S = typename Type::Scalar>
engine::SceneData<Type> cradle(int count, int incoming, const S& gap) {
    using Vec = math::Vec<S>;
    Builder<Type> builder;
    for (int k = 0; k < count; ++k) {
        const bool comes = k < incoming;
        builder.ball(Vec(S(2 * k - (comes ? 5 : 0)), S(0)), Vec(S(comes ? 1 : 0), S(0)));
        auto& x = builder.scene.bodies.back().state.position.x;
        x = x + math::Wide<S>(S(k) * gap);
    }
    return builder.scene;
}

template <class Type, class S = typename Type::Scalar>
void expect_as_many_leave_as_come(int count, int incoming, const S& gap, bool first_ball_only) {
    const auto played = play<Type>(cradle<Type>(count, incoming, gap), S(8));
    const std::string name = std::to_string(count) + " balls, " + std::to_string(incoming) +
                             " come, gap " + std::to_string(math::to_double<S>(gap));
    ASSERT_EQ(played.status, Status::time_limit) << name;
    for (int k = 0; k < count; ++k) {
        const bool leaves = k >= count - incoming;
        const S error =
            math::abs<S>(played.velocity(static_cast<std::size_t>(k)).x() - S(leaves ? 1 : 0));
        ASSERT_LE(in_epsilons<S>(error), 16) << name << ", ball " << k;
    }
    if (first_ball_only) {
        ASSERT_EQ(played.events, static_cast<std::uint64_t>(count - 1)) << name;
    }
    const engine::RunAudit audit = played.audit();
    ASSERT_TRUE(audit.clean) << name << " " << describe(audit);
}

TYPED_TEST(Cradle, OneComesOneLeaves) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    for (int count = 3; count <= 15; ++count) {
        expect_as_many_leave_as_come<Type>(count, 1, S(0), true);
        for (int k = 3; k <= 15; ++k) {
            expect_as_many_leave_as_come<Type>(count, 1, power_of_ten<S>(-k), true);
        }
    }
}

TYPED_TEST(Cradle, AsManyLeaveAsCome) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    for (const int count : {3, 5, 8, 15}) {
        for (const int incoming : {2, count / 2, count - 1}) {
            expect_as_many_leave_as_come<Type>(count, incoming, S(0), false);
            for (int k = 3; k <= 15; k += 3) {
                expect_as_many_leave_as_come<Type>(count, incoming, power_of_ten<S>(-k), false);
            }
        }
    }
}

TYPED_TEST(Cradle, OfDifferentMassesKeepsMomentumAndEnergy) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    auto scene = cradle<Type>(3, 1, S(0));
    for (std::size_t k = 0; k < 3; ++k) scene.bodies[k].mass = S(static_cast<int>(k) + 1);
    const auto played = play<Type>(scene, S(8));
    // Masses 1, 2, 3, pair by pair: (-1/3, 2/3, 0), then (-1/3, -2/15, 8/15).
    const S expected[] = {S(-1) / S(3), S(-2) / S(15), S(8) / S(15)};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(in_epsilons<S>(math::abs<S>(played.velocity(k).x() - expected[k])), 4);
    }
}

template <class Type>
Played<Type> inelastic_row(int count, double restitution, double gap) {
    using S = typename Type::Scalar;
    auto scene = cradle<Type>(count, 1, S(gap));
    scene.ball_ball_restitution = S(restitution);
    auto played = play<Type>(scene, S(100), 50000);
    const engine::RunAudit audit = played.audit();
    EXPECT_TRUE(audit.clean) << restitution << " " << gap << " " << describe(audit);
    EXPECT_LE(audit.energy_final, audit.energy_initial);
    EXPECT_LT(audit.largest_energy_gain, math::to_double<S>(S(20) * math::epsilon<S>()));
    S momentum(0);
    for (const auto& body : played.bodies) momentum += body.state.velocity.x();
    EXPECT_LT(in_epsilons<S>(math::abs<S>(momentum - S(1))), 2000);
    return played;
}

TYPED_TEST(Cradle, ShortInelasticRowsEndUpApartOrTogether) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    for (const int count : {2, 3, 4, 5}) {
        for (const double restitution : {0.0, 0.1, 0.5, 0.9}) {
            // Pair by pair in the order of indices, the perfectly inelastic ones take too long.
            if (count > 3 && restitution < 0.5) continue;
            for (const double gap : {0.0, 1e-12, 1e-3}) {
                const auto played = inelastic_row<Type>(count, restitution, gap);
                ASSERT_EQ(played.status, Status::time_limit)
                    << count << " " << restitution << " " << gap;
                for (std::size_t k = 1; k < played.bodies.size(); ++k) {
                    const S room = played.position(k).x() - played.position(k - 1).x() - S(2);
                    const S closing = played.velocity(k - 1).x() - played.velocity(k).x();
                    // Those that touch move on together.
                    if (in_epsilons<S>(room) < 16) {
                        ASSERT_LT(in_epsilons<S>(closing), 64) << k;
                    }
                }
            }
        }
    }
}

TYPED_TEST(Cradle, LongInelasticRowsEnd) {
    using Type = typename TypeParam::Type;
    // Pair by pair in the order of indices takes a number of impacts that grows exponentially with
    // the row: reported as impacts that accumulate.
    for (const double restitution : {0.0, 0.5}) {
        for (const double gap : {0.0, 1e-12, 1e-3}) {
            EXPECT_LT(inelastic_row<Type>(15, restitution, gap).events, 10000u);
        }
    }
}

}  // namespace
}  // namespace osculo::support

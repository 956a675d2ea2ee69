#include "support/gas.hpp"

#include <gtest/gtest.h>

#include "support/scalars.hpp"

// Disks in a box, for long: energy, overlaps, and the way back.
namespace osculo::support {
namespace {

TEST(Gas, SixteenDisksForTenThousandEvents) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        for (const double density : {0.05, 0.3, 0.5}) {
            const auto played = play<TableScene<double>>(
                gas<TableScene<double>>(16, density, seed).scene, 1e9, 10'000);
            const engine::RunAudit audit = played.audit();
            EXPECT_EQ(played.status, Status::event_limit);
            EXPECT_TRUE(audit.clean) << describe(audit);
            EXPECT_LT(std::abs(audit.energy_final / audit.energy_initial - 1), 1e-12);
            EXPECT_GT(audit.worst_gap, -1e-14) << describe(audit);
        }
    }
}

TEST(Gas, AThousandDisks) {
    using Type =
        engine::UniformScene<double, engine::Walls, engine::PieceRecorder, engine::CellGrid>;
    const auto played = play<Type>(gas<Type>(1000, 0.4, 1).scene, 1e9, 50'000);
    const engine::RunAudit audit = played.audit();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_LT(std::abs(audit.energy_final / audit.energy_initial - 1), 1e-12);
    EXPECT_GT(audit.worst_gap, -1e-14) << describe(audit);
}

/// The bodies as a new scene, with their velocities turned round.
template <class Type>
engine::SceneData<Type> reversed(const Played<Type>& played) {
    engine::SceneData<Type> scene = played.scene;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        scene.bodies[i].state = played.bodies[i].state;
        scene.bodies[i].state.velocity *= typename Type::Scalar(-1);
    }
    return scene;
}

template <class S>
class Reversal : public ::testing::Test {};
TYPED_TEST_SUITE(Reversal, AllScalars, ScalarName);

TYPED_TEST(Reversal, ReturnsAsFarAsItsDigitsReach) {
    using S = TypeParam;
    using Type = engine::UniformScene<S, engine::Walls, engine::NoRecorder, engine::AllPairs>;
    const double digits = -std::log10(math::to_double<S>(math::epsilon<S>()));
    const auto events = static_cast<std::uint64_t>(6 * digits);
    double rate_sum = 0;
    constexpr int kSeeds = 3;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const auto scene = gas<Type>(16, 0.3, seed).scene;
        const S time = math::narrow(play<Type>(scene, S(1e9), events).end);
        const auto there = play<Type>(scene, time);
        const auto back = play<Type>(reversed(there), time);
        EXPECT_EQ(there.events, back.events) << seed;
        S error(0);
        for (std::size_t i = 0; i < 16; ++i) {
            const auto& start = scene.bodies[i].state;
            const math::Vec<S> place = back.position(i) - start.position.rounded();
            const math::Vec<S> velocity = back.velocity(i) + start.velocity;
            error = std::max<S>({error, math::norm<S>(place), math::norm<S>(velocity)});
        }
        const double lost = std::log10(in_epsilons<S>(error));
        EXPECT_LT(lost, 0.5 * digits) << seed;
        rate_sum += lost / static_cast<double>(there.events);
    }
    // What is lost per event does not depend on how many digits there are.
    const double rate = rate_sum / kSeeds;
    std::printf("    %.3f digits lost per event of 16 disks, there and back\n", rate);
    EXPECT_GT(rate, 0.02);
    EXPECT_LT(rate, 0.08);
}

}  // namespace
}  // namespace osculo::support

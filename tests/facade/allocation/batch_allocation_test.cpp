#include <algorithm>

#include <gtest/gtest.h>

#include "engine/allocation/counting_new.hpp"
#include "osculo/batch.hpp"
#include "support/batches.hpp"

namespace osculo {
namespace {

/// Allocations of a second run of the same kind.
template <class Shots>
std::uint64_t allocations_of(Batch& batch, const Shots& warm_up, const Shots& shots) {
    BatchResult result;
    batch.run(warm_up, result);
    const std::uint64_t before = support::allocations();
    batch.run(shots, result);
    const std::uint64_t count = support::allocations() - before;
    EXPECT_EQ(std::ranges::count(result.status, ShotStatus::invalid), 0);
    return count;
}

TEST(BatchAllocation, DoesNotGrowWithTheNumberOfShots) {
    Scene scene = test::pool_scene(9);
    scene.closed = true;
    const auto strikes = test::random_strikes(200, 1);
    const auto states = test::random_states(scene, 200, 1);
    const std::vector<std::uint8_t> present(states.size(), 1);
    for (const unsigned threads : {1U, 2U}) {
        Batch batch(scene, {.threads = threads, .chunk = 10});
        using Strikes = std::span<const Strike>;
        const auto of_strikes = [&](std::size_t shots) {
            return allocations_of(batch, Strikes(strikes), Strikes(strikes).first(shots));
        };
        const auto of_starts = [&](std::size_t shots) {
            const Starts all{states, present};
            const Starts some{all.states.first(shots * 10), all.present.first(shots * 10)};
            return allocations_of(batch, all, some);
        };
        // With two threads, the first batch may not have shown its longest shots to both.
        const std::uint64_t slack = threads == 1 ? 0 : 8;
        EXPECT_LE(of_strikes(200), of_strikes(10) + slack);
        EXPECT_LE(of_starts(200), of_starts(10) + slack);
        EXPECT_LE(of_strikes(10), 2U + slack);
    }
}

}  // namespace
}  // namespace osculo

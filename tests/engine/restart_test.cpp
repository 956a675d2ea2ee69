#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/gas.hpp"
#include "support/same_bits.hpp"

// An engine that starts again is a new engine.
namespace osculo {
namespace {

template <template <class> class BroadPhase>
void check_restart() {
    using Type = engine::UniformScene<double, engine::Walls, engine::PieceRecorder, BroadPhase>;
    const auto first = support::gas<Type>(20, 0.3, 1).scene;
    const auto second = support::gas<Type>(20, 0.3, 2).scene;
    const engine::RunLimits<double> limits{1e9, 500};

    engine::Engine<Type> fresh(second);
    const Status expected = fresh.run(limits);
    engine::Engine<Type> again(first);
    again.run({1e9, 137});  // in the middle of something
    again.restart(second.bodies);
    EXPECT_EQ(again.run(limits), expected);
    EXPECT_EQ(again.event_count(), fresh.event_count());
    EXPECT_EQ(again.prediction_count(), fresh.prediction_count());
    EXPECT_TRUE(support::same_final_bodies(again.bodies(), fresh.bodies()));
    const auto& events = again.recorder().events;
    const auto& expected_events = fresh.recorder().events;
    ASSERT_EQ(events.size(), expected_events.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
        EXPECT_TRUE(support::same_bits<double>(events[k], expected_events[k])) << k;
    }
    EXPECT_EQ(again.recorder().pieces.size(), fresh.recorder().pieces.size());
}

TEST(Restart, IsANewEngineWithAllPairs) {
    check_restart<engine::AllPairs>();
}
TEST(Restart, IsANewEngineWithACellGrid) {
    check_restart<engine::CellGrid>();
}

}  // namespace
}  // namespace osculo

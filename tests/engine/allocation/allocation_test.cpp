#include <gtest/gtest.h>

#include "counting_new.hpp"
#include "support/gas.hpp"
#include "support/scalars.hpp"

namespace {

using namespace osculo;

template <class S>
class Allocation : public testing::Test {};
TYPED_TEST_SUITE(Allocation, support::AllScalars, support::ScalarName);

/// Number of allocations while the engine runs.
template <class Type>
std::uint64_t while_running(int disks, std::uint64_t events) {
    engine::Engine<Type> engine(support::gas<Type>(disks, 0.3, 5).scene);
    const std::uint64_t before = support::allocations();
    engine.run({math::never<typename Type::Scalar>(), events});
    const std::uint64_t after = support::allocations();
    EXPECT_EQ(events, engine.event_count());
    return after - before;
}

TYPED_TEST(Allocation, NoneFromTheFirstEventOn) {
    using S = TypeParam;
    const std::uint64_t events = math::Builtin<S> ? 20000 : 300;
    using AllPairs = engine::UniformScene<S, engine::Table, engine::NoRecorder, engine::AllPairs>;
    using CellGrid = engine::UniformScene<S, engine::Walls, engine::NoRecorder, engine::CellGrid>;
    EXPECT_EQ(0U, (while_running<AllPairs>(12, events)));
    EXPECT_EQ(0U, (while_running<CellGrid>(60, events)));
}

/// The counter counts: a recorder has to allocate.
TEST(AllocationCounter, SeesARecorder) {
    using Recorded =
        engine::UniformScene<double, engine::Walls, engine::EventRecorder, engine::CellGrid>;
    EXPECT_GT(while_running<Recorded>(60, 1000), 0U);
}

}  // namespace

#include <algorithm>

#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/random_tables.hpp"
#include "support/same_bits.hpp"

// What a scene type does not list leaves no state, and does not change what is left.
namespace osculo::support {
namespace {

using engine::AllPairs;
using engine::CellGrid;
using engine::Engine;
using engine::EventRecorder;
using engine::NoObstacles;
using engine::NoRecorder;
using engine::PieceRecorder;
using engine::Table;
using engine::UniformScene;
using engine::Walls;

using Narrowest = UniformScene<double, NoObstacles, NoRecorder, AllPairs>;

TEST(LeaveOut, NothingIsEmpty) {
    EXPECT_TRUE(std::is_empty_v<NoRecorder<double>>);
    EXPECT_TRUE(std::is_empty_v<motion::Uniform>);
    EXPECT_TRUE(std::is_empty_v<impact::Restitution>);
    EXPECT_TRUE(std::is_empty_v<impact::Sequential>);
    EXPECT_TRUE(std::is_empty_v<typename Narrowest::ObstacleStorage>);
    EXPECT_TRUE(
        (std::is_empty_v<engine::ObstacleBoxes<double, typename Narrowest::ObstacleStorage>>));
}

TEST(LeaveOut, RecorderAndObstaclesCostWhatTheyHold) {
    constexpr std::size_t kVector = sizeof(std::vector<int>);
    constexpr std::size_t kNarrowest = sizeof(Engine<Narrowest>);
    using Recorded = UniformScene<double, NoObstacles, PieceRecorder, AllPairs>;
    EXPECT_EQ(sizeof(Engine<Recorded>), kNarrowest + 2 * kVector);
    using Walled = UniformScene<double, Walls, NoRecorder, AllPairs>;
    EXPECT_EQ(sizeof(typename Walled::ObstacleStorage), 2 * kVector);
    EXPECT_LE(sizeof(AllPairs<double>), 8u);
}

TEST(LeaveOut, ClustersCostNothingWhereTheyAreNotResolvedTogether) {
    EXPECT_TRUE((std::is_empty_v<engine::ClusterWorkspace<Narrowest>>));
    using Symmetric = UniformScene<double, NoObstacles, NoRecorder, AllPairs, impact::Symmetric>;
    EXPECT_LE(sizeof(engine::SceneData<Symmetric>),
              sizeof(engine::SceneData<Narrowest>) + sizeof(double));
    EXPECT_EQ(sizeof(engine::Body<Symmetric>), sizeof(engine::Body<Narrowest>));
    // Which cluster an event belongs to has room beside its balls.
    struct WithoutCluster {
        math::Instant<double> when;
        std::uint32_t what[3];
        math::Vec<double> normal;
        std::array<engine::Moment<double>, 4> of;
    };
    EXPECT_EQ(sizeof(engine::EventRecord<double>), sizeof(WithoutCluster));
}

TEST(LeaveOut, AnEngineWithoutRecorderIsNoLargerThanItsParts) {
    constexpr std::size_t kParts = sizeof(engine::SceneData<Narrowest>) +
                                   sizeof(engine::EventQueue<double>) + sizeof(AllPairs<double>) +
                                   sizeof(std::vector<geometry::Box<double>>) +
                                   sizeof(math::Instant<double>) + 2 * sizeof(std::uint64_t);
    EXPECT_LE(sizeof(Engine<Narrowest>), (kParts + 7) / 8 * 8);
}

template <class To>
Builder<To> walled_gas() {
    return gas<To>(20, 0.3, 11);
}

TEST(LeaveOut, RecordersDoNotChangeResults) {
    const auto none =
        play(walled_gas<UniformScene<double, Walls, NoRecorder, AllPairs>>().scene, 1e9, 2000);
    const auto events =
        play(walled_gas<UniformScene<double, Walls, EventRecorder, AllPairs>>().scene, 1e9, 2000);
    const auto pieces =
        play(walled_gas<UniformScene<double, Walls, PieceRecorder, AllPairs>>().scene, 1e9, 2000);
    EXPECT_TRUE(same_final_bodies(none.bodies, events.bodies));
    EXPECT_TRUE(same_final_bodies(none.bodies, pieces.bodies));
    EXPECT_EQ(none.end, pieces.end);
    ASSERT_EQ(events.record.events.size(), 2000u);
    ASSERT_EQ(pieces.record.events.size(), 2000u);
    for (std::size_t k = 0; k < 2000; ++k) {
        EXPECT_TRUE(same_bits<double>(events.record.events[k], pieces.record.events[k])) << k;
    }
}

/// The events but for their kinds, which are numbered by the list of obstacles.
template <class A, class B>
bool same_but_for_kinds(const Played<A>& a, const Played<B>& b) {
    if (a.record.events.size() != b.record.events.size()) return false;
    for (std::size_t k = 0; k < a.record.events.size(); ++k) {
        auto other = b.record.events[k];
        other.kind = a.record.events[k].kind;
        if (!same_bits<double>(a.record.events[k], other)) return false;
    }
    return same_final_bodies(a.bodies, b.bodies);
}

TEST(LeaveOut, NarrowAndWideListsOfObstaclesAgree) {
    TableOptions options;
    options.arcs = false;
    options.rims = false;
    std::uint64_t events = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        using Narrow = UniformScene<double, Walls, PieceRecorder, AllPairs>;
        using Wide = UniformScene<double, Table, PieceRecorder, AllPairs>;
        // The builder draws no random numbers for kinds that a scene type cannot hold, and none
        // for kinds that are switched off.
        const auto narrow = play(random_table<Narrow>(seed, options).scene, 20, 300);
        const auto wide = play(random_table<Wide>(seed, options).scene, 20, 300);
        EXPECT_TRUE(same_but_for_kinds(narrow, wide)) << "seed " << seed;
        events += narrow.events;
    }
    EXPECT_GT(events, 20000u);
}

TEST(LeaveOut, NoObstaclesAndUnusedOnesAgree) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto fill = [&](auto& builder) {
            Random random(seed);
            for (int k = 0; k < 10; ++k) {
                const math::Vec<double> at(3.0 * k, random.signed_unit<double>());
                builder.ball(at, math::Vec<double>(-0.1 * k * k, 0));
            }
        };
        Builder<UniformScene<double, NoObstacles, PieceRecorder, AllPairs>> narrow;
        Builder<UniformScene<double, Table, PieceRecorder, CellGrid>> wide;
        fill(narrow);
        fill(wide);
        EXPECT_TRUE(same_bits(play(narrow.scene, 100), play(wide.scene, 100))) << "seed " << seed;
    }
}

// Where nothing meets two things at once, both laws are the same, bit for bit.
TEST(LeaveOut, WithoutClustersTheLawForThemDoesNotMatter) {
    std::uint64_t events = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const auto sequential = play(random_table<TableScene<double>>(seed, {}).scene, 20, 300);
        const auto symmetric = play(random_table<SymmetricTable<double>>(seed, {}).scene, 20, 300);
        const auto& all = symmetric.record.events;
        if (!std::all_of(all.begin(), all.end(),
                         [](const auto& event) { return event.cluster.number == 0; })) {
            continue;
        }
        EXPECT_TRUE(same_bits(sequential, symmetric)) << "seed " << seed;
        events += symmetric.events;
    }
    EXPECT_GT(events, 20000u);
}

}  // namespace
}  // namespace osculo::support

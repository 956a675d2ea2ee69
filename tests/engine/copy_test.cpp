#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/cloth_tables.hpp"
#include "support/gas.hpp"
#include "support/random.hpp"
#include "support/same_bits.hpp"
#include "support/scalars.hpp"

// An engine that is stopped, copied and played on does what one does that is never stopped.
namespace osculo::support {
namespace {

template <class Type>
void expect_same(engine::Engine<Type>& a, engine::Engine<Type>& b) {
    using S = typename Type::Scalar;
    EXPECT_EQ(a.time(), b.time());
    EXPECT_EQ(a.event_count(), b.event_count());
    EXPECT_EQ(a.prediction_count(), b.prediction_count());
    EXPECT_TRUE(same_final_bodies(a.bodies(), b.bodies()));
    const auto& pieces = a.recorder().pieces;
    const auto& others = b.recorder().pieces;
    ASSERT_EQ(a.recorder().events.size(), b.recorder().events.size());
    ASSERT_EQ(pieces.size(), others.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        EXPECT_TRUE(pieces[k].ball == others[k].ball && pieces[k].from == others[k].from &&
                    pieces[k].to == others[k].to);
    }
    for (std::size_t k = 0; k < a.recorder().events.size(); ++k) {
        const auto& one = a.recorder().events[k];
        const auto& other = b.recorder().events[k];
        EXPECT_TRUE(one.when == other.when && one.kind == other.kind && one.first == other.first &&
                    one.second == other.second &&
                    same_bits<S>(one.after[0].position, other.after[0].position) &&
                    same_bits<S>(one.after[0].velocity, other.after[0].velocity));
    }
}

template <class Type>
void check_copies(const engine::SceneData<Type>& scene, double time, std::uint64_t events,
                  std::uint64_t seed) {
    using S = typename Type::Scalar;
    const engine::RunLimits<S> limits{S(time), events};
    engine::Engine<Type> whole(scene);
    const Status status = whole.run(limits);

    Random random(seed);
    engine::Engine<Type> engine(scene);
    engine::Pause pause;
    // A stop after each part, by time or by events; what is left behind goes elsewhere first.
    std::vector<std::pair<engine::Engine<Type>, engine::Pause>> left_behind;
    Status reached = Status::event_limit;
    for (int part = 0; part < 12; ++part) {
        engine::RunLimits<S> stop = limits;
        if (part % 2 == 0) {
            stop.time = S(time * random.unit<double>());
        } else {
            stop.events = std::min(events, engine.event_count() + events / 20);
        }
        reached = engine.play(stop, pause);
        engine::Engine<Type> copy(engine);
        copy.finish(reached, stop);  // disturbs only the copy
        left_behind.emplace_back(engine, pause);
        if (part % 3 == 0) {
            std::tie(engine, pause) = left_behind[static_cast<std::size_t>(part) / 2];
        }
    }
    reached = engine.play(limits, pause);
    EXPECT_EQ(engine.finish(reached, limits), status);
    expect_same(whole, engine);
    for (auto& [old, its_pause] : left_behind) {
        EXPECT_EQ(old.finish(old.play(limits, its_pause), limits), status);
        expect_same(whole, old);
    }
}

template <class S>
class Copies : public testing::Test {};
TYPED_TEST_SUITE(Copies, NativeScalars, ScalarName);

TYPED_TEST(Copies, PlayOnAsTheOriginal) {
    using S = TypeParam;
    constexpr bool kFast = math::Builtin<S>;
    using AllPairs =
        engine::UniformScene<S, engine::Walls, engine::PieceRecorder, engine::AllPairs>;
    using CellGrid =
        engine::UniformScene<S, engine::Walls, engine::PieceRecorder, engine::CellGrid>;
    for (std::uint64_t seed = 0; seed < (kFast ? 20 : 1); ++seed) {
        SCOPED_TRACE(seed);
        check_copies<AllPairs>(gas<AllPairs>(9, 0.3, seed).scene, 3, kFast ? 400 : 60, seed);
        check_copies<CellGrid>(gas<CellGrid>(30, 0.3, seed).scene, 3, kFast ? 400 : 60, seed);
        check_copies<RollingTable<S>>(rolling_table<S>(seed), 20, kFast ? 400 : 40, seed);
        check_copies<ClothTable<S>>(cloth_table<S>(seed), 20, kFast ? 400 : 40, seed);
    }
}

}  // namespace
}  // namespace osculo::support

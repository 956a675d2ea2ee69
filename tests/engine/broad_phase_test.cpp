#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/random_tables.hpp"
#include "support/same_bits.hpp"
#include "support/scalars.hpp"

// A grid changes what a run costs and nothing else.
namespace osculo::support {
namespace {

template <class S>
using Gridded = engine::UniformScene<S, engine::Table, engine::PieceRecorder, engine::CellGrid>;

/// The same scene for another scene type with the same scalar and obstacles.
template <class To, class From>
engine::SceneData<To> convert(const engine::SceneData<From>& from) {
    engine::SceneData<To> to;
    to.obstacles = from.obstacles;
    to.ball_ball_restitution = from.ball_ball_restitution;
    to.ball_cushion_restitution = from.ball_cushion_restitution;
    for (const auto& body : from.bodies) {
        engine::Body<To> copy;
        copy.state = body.state;
        copy.mass = body.mass;
        copy.radius = body.radius;
        to.bodies.push_back(copy);
    }
    return to;
}

template <class S>
void expect_grid_changes_nothing(const engine::SceneData<TableScene<S>>& scene, const S& time,
                                 std::uint64_t events, const std::string& name) {
    const auto plain = play<TableScene<S>>(scene, time, events);
    const auto gridded = play<Gridded<S>>(convert<Gridded<S>>(scene), time, events);
    EXPECT_TRUE(same_bits(plain, gridded)) << name;
}

template <class S>
class BroadPhase : public ::testing::Test {};
TYPED_TEST_SUITE(BroadPhase, NativeScalars, ScalarName);

TYPED_TEST(BroadPhase, GridEqualsAllPairsOnTables) {
    using S = TypeParam;
    const bool quick = std::is_same_v<S, double>;
    for (std::uint64_t seed = 0; seed < (quick ? 400 : 30); ++seed) {
        TableOptions options;
        options.most_balls = 30;
        options.restitution = seed % 3 == 0 ? 0.7 : 1;
        expect_grid_changes_nothing<S>(random_table<TableScene<S>>(seed, options).scene, S(10),
                                       quick ? 400 : 100, "seed " + std::to_string(seed));
    }
}

TYPED_TEST(BroadPhase, GridEqualsAllPairsInAGas) {
    using S = TypeParam;
    for (const double density : {0.45, 0.1, 0.001}) {
        expect_grid_changes_nothing<S>(gas<TableScene<S>>(150, density, 3).scene, S(100),
                                       std::is_same_v<S, double> ? 5000 : 500,
                                       "density " + std::to_string(density));
    }
}

TYPED_TEST(BroadPhase, GridEqualsAllPairsInTheOpen) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    // Balls of very different sizes, flying in from far away and out again.
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Random random(seed);
        Builder<TableScene<S>> builder;
        for (int k = 0; k < 40; ++k) {
            const Vec at(S(k % 8) * S(8) + random.signed_unit<S>(),
                         S(k / 8) * S(8) + random.signed_unit<S>());
            Vec velocity(random.signed_unit<S>(), random.signed_unit<S>());
            if (k % 3 == 0) velocity = (Vec(S(28), S(16)) - at) / S(10);
            if (k % 5 == 0) velocity *= S(0);
            builder.ball(at, velocity, k % 7 == 0 ? S(2.5) : random.magnitude<S>(-12, -1),
                         random.magnitude<S>(-5, 5));
        }
        expect_grid_changes_nothing<S>(builder.scene, S(1000), 1000,
                                       "seed " + std::to_string(seed));
    }
}

TYPED_TEST(BroadPhase, GridEqualsAllPairsOnCellBorders) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    // On a lattice, along its lines and diagonals: crossings and contacts at the same instants.
    Builder<TableScene<S>> builder;
    for (int k = 0; k < 64; ++k) {
        const Vec velocities[] = {Vec(S(1), S(0)),  Vec(S(0), S(1)),  Vec(S(1), S(1)),
                                  Vec(S(-1), S(0)), Vec(S(0), S(-1)), Vec(S(-1), S(1)),
                                  Vec(S(0), S(0))};
        builder.ball(Vec(S(4 * (k % 8)), S(4 * (k / 8))), velocities[k * 5 % 7], S(1));
    }
    builder.box(S(-2), S(-2), S(30), S(30));
    expect_grid_changes_nothing<S>(builder.scene, S(200), 2000, "lattice");
}

TYPED_TEST(BroadPhase, GridTakesOneBallAndNone) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Builder<TableScene<S>> builder;
    expect_grid_changes_nothing<S>(builder.scene, S(10), 100, "none");
    builder.ball(Vec(S(1), S(1)), Vec(S(3), S(4)), S(1));
    expect_grid_changes_nothing<S>(builder.scene, S(10), 100, "one");
    builder.ball(Vec(S(1), S(5)), Vec(S(3), S(4)), S(1));  // in one column
    expect_grid_changes_nothing<S>(builder.scene, S(10), 100, "two");
}

}  // namespace
}  // namespace osculo::support

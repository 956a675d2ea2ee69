#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/random_tables.hpp"
#include "support/same_bits.hpp"
#include "support/scalars.hpp"

// Very fast and very slow, very large and very small, very far away; and units that do not matter.
namespace osculo::support {
namespace {

template <class S>
class Extremes : public ::testing::Test {};
TYPED_TEST_SUITE(Extremes, NativeScalars, ScalarName);

/// Sizes and speeds from 1e-150 to 1e150 in one unit of time or another.
TYPED_TEST(Extremes, OneFastBallIsStoppedByAWallOnce) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (int exponent = -150; exponent <= 150; exponent += 10) {
        const S speed = power_of_ten<S>(exponent);
        Builder<TableScene<S>> builder;
        builder.wall(Vec(S(10), S(-9)), Vec(S(10), S(9)))
            .ball(Vec(S(0), S(0)), Vec(speed, S(0)), S(1));
        const auto played = play<TableScene<S>>(builder.scene, S(18) / speed);
        ASSERT_EQ(played.events, 1u) << "1e" << exponent;
        ASSERT_EQ(played.status, Status::time_limit);
        ASSERT_EQ(played.velocity(0), Vec(-speed, S(0)));
        ASSERT_LT(in_epsilons<S>(math::norm<S>(played.position(0))), 32);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << "1e" << exponent << " " << describe(audit);
    }
}

TYPED_TEST(Extremes, TwoBallsMeetAtAnySpeed) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (int exponent = -150; exponent <= 150; exponent += 10) {
        const S speed = power_of_ten<S>(exponent);
        Builder<TableScene<S>> builder;
        builder.ball(Vec(S(0), S(0)), Vec(speed, S(0)), S(1), S(2))
            .ball(Vec(S(10), S(1)), Vec(-speed, S(0)), S(1), S(1));
        const auto played = play<TableScene<S>>(builder.scene, S(10) / speed);
        ASSERT_EQ(played.events, 1u) << "1e" << exponent;
        ASSERT_EQ(played.status, Status::time_limit);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << "1e" << exponent << " " << describe(audit);
        // All that depends on the speed are the times: the directions afterwards are the same.
        const Vec direction = played.velocity(0) / speed;
        ASSERT_NEAR(math::to_double<S>(math::norm<S>(direction)), std::sqrt(1.0 / 3), 1e-12);
    }
}

TYPED_TEST(Extremes, FarFromTheOriginNothingChanges) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    // Multiples of 2^-12, so that moving them by 1e8 is exact.
    Random random(4);
    const auto grid = [&](double low, double high) {
        return S(std::floor(random.uniform<double>(low, high) * 4096) / 4096);
    };
    for (int trial = 0; trial < 20; ++trial) {
        Builder<TableScene<S>> here;
        Builder<TableScene<S>> there;
        const Vec offset(S(1e8), S(-3e8));
        here.box(S(0), S(0), S(8), S(8));
        there.box(offset.x(), offset.y(), offset.x() + S(8), offset.y() + S(8));
        for (int k = 0; k < 9; ++k) {
            const Vec at(S(1 + 2.5 * (k % 3)) + grid(-0.2, 0.2),
                         S(1 + 2.5 * (k / 3)) + grid(0, 0.2));
            const Vec velocity(grid(-1, 1), grid(-1, 1));
            here.ball(at, velocity, S(0.5));
            there.ball(at + offset, velocity, S(0.5));
        }
        const auto a = play<TableScene<S>>(here.scene, S(1e9), 40);
        const auto b = play<TableScene<S>>(there.scene, S(1e9), 40);
        ASSERT_TRUE(b.audit().clean) << describe(b.audit());
        ASSERT_EQ(a.events, b.events);
        for (std::size_t k = 0; k < a.events; ++k) {
            const auto& one = a.record.events[k];
            const auto& other = b.record.events[k];
            ASSERT_EQ(one.kind, other.kind) << k;
            ASSERT_EQ(one.first, other.first) << k;
            ASSERT_EQ(one.second, other.second) << k;
        }
        // Where places are wide they lose nothing: forty events later the balls are where they
        // would be here. Rounding to the grid at 3e8 would have cost 3e8 times more.
        if (!math::Builtin<S>) continue;
        const double lost = in_epsilons<S>(
            math::norm<S>(a.position(4) - math::difference<S>(b.bodies[4].state.position, offset)));
        ASSERT_LT(lost, 1e6) << trial;
    }
}

TYPED_TEST(Extremes, LateIsAsExactAsEarly) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    // A ball that has been bouncing for long: at 1e9 s it hits where it should.
    Builder<TableScene<S>> builder;
    builder.box(S(0), S(0), S(4), S(4)).ball(Vec(S(2), S(2)), Vec(S(0.0001220703125), S(0)), S(1));
    const auto played = play<TableScene<S>>(builder.scene, S(1073741824.0));  // 2^30 s
    EXPECT_EQ(played.events, 65536u);                                         // 2^30 2^-13 m / 2 m
    EXPECT_EQ(played.position(0), Vec(S(2), S(2)));
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

TYPED_TEST(Extremes, RadiiAndMassesMayDifferByAlot) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    for (const int radius_exponent : {-9, -6, 0, 9}) {
        for (const int mass_exponent : {-12, 0, 12}) {
            const S radius = power_of_ten<S>(radius_exponent);
            const S mass = power_of_ten<S>(mass_exponent);
            Builder<TableScene<S>> builder;
            // The second one is met off-centre by half of its radius.
            const S small = std::min<S>(radius, S(1));
            builder.ball(Vec(S(0), S(0)), Vec(S(1), S(0)), radius, mass)
                .ball(Vec(radius + S(3), small / S(2)), Vec(S(0), S(0)), S(1), S(1));
            const auto played = play<TableScene<S>>(builder.scene, S(10));
            const engine::RunAudit audit = played.audit();
            ASSERT_EQ(played.events, 1u) << radius_exponent << " " << mass_exponent;
            ASSERT_TRUE(audit.clean) << describe(audit);
            ASSERT_NEAR(audit.energy_final / audit.energy_initial, 1, 1e-13);
        }
    }
}

TYPED_TEST(Extremes, TinyBallsOnALargeTableAreRightOrNumeric) {
    using S = TypeParam;
    using Vec = math::Vec<S>;
    Random random(8);
    int met = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const S radius(1e-9);
        Builder<TableScene<S>> builder;
        builder.box(S(-1), S(-1), S(1), S(1));
        builder.ball(Vec(S(0), S(0)), Vec(S(0), S(0)), radius);
        const Vec heading = random.direction<S>();
        const Vec across(-heading.y(), heading.x());
        builder.ball(Vec(-S(0.5) * heading + random.signed_unit<S>() * radius * across), heading,
                     radius);
        const auto played = play<TableScene<S>>(builder.scene, S(1), 100);
        ASSERT_TRUE(played.status == Status::numeric || played.audit().clean)
            << trial << describe(played.audit());
        ASSERT_NE(played.status, Status::zeno);
        met += played.events > 0 && played.record.events[0].kind == engine::kBallBall;
    }
    EXPECT_EQ(met, 200);
}

/// Everything in units of 2^length m, 2^time s and 2^mass kg.
template <class Type>
engine::SceneData<Type> scaled(engine::SceneData<Type> scene, int length, int time, int mass) {
    using S = typename Type::Scalar;
    const S l = power_of_two<S>(length);
    const S v = power_of_two<S>(length - time);
    for (auto& body : scene.bodies) {
        body.state.position.x = body.state.position.x * math::Wide<S>(l);
        body.state.position.y = body.state.position.y * math::Wide<S>(l);
        body.state.velocity *= v;
        body.radius *= l;
        body.mass *= power_of_two<S>(mass);
    }
    std::apply(
        [&](auto&... kinds) {
            const auto scale = [&](auto& obstacle) {
                using Obstacle = std::decay_t<decltype(obstacle)>;
                if constexpr (std::is_same_v<Obstacle, geometry::Segment<S>>) {
                    obstacle.from *= l;
                    obstacle.length *= l;
                } else if constexpr (std::is_same_v<Obstacle, geometry::Point<S>>) {
                    obstacle.at *= l;
                } else {
                    obstacle.center *= l;
                    obstacle.radius *= l;
                }
            };
            (std::for_each(kinds.begin(), kinds.end(), scale), ...);
        },
        scene.obstacles);
    return scene;
}

template <class Type>
void expect_scaling_changes_nothing(const engine::SceneData<Type>& scene, int length, int time,
                                    int mass, const std::string& name) {
    using S = typename Type::Scalar;
    const auto plain = play<Type>(scene, S(50), 300);
    const auto other =
        play<Type>(scaled<Type>(scene, length, time, mass), S(50) * power_of_two<S>(time), 300);
    ASSERT_EQ(plain.status, other.status) << name;
    ASSERT_EQ(plain.events, other.events) << name;
    // The final bodies, scaled back, say all: they depend on every event.
    engine::SceneData<Type> last = other.scene;
    last.bodies = other.bodies;
    EXPECT_TRUE(same_final_bodies(plain.bodies, scaled<Type>(last, -length, -time, -mass).bodies))
        << name;
    EXPECT_EQ(plain.end, other.end * math::Wide<S>(power_of_two<S>(-time))) << name;
    EXPECT_GT(plain.events, 0u) << name;
}

TYPED_TEST(Extremes, PowersOfTwoInTheUnitsScaleTheRunBitForBit) {
    using S = TypeParam;
    const int units[][3] = {{1, 0, 0},   {0, 1, 0},    {0, 0, 1},     {-7, 5, 11},    {30, -20, 3},
                            {-40, 9, 0}, {150, 0, 40}, {0, -150, 40}, {-120, 150, 2}, {200, 60, 0}};
    for (const auto& unit : units) {
        const std::string name = std::to_string(unit[0]) + " " + std::to_string(unit[1]);
        expect_scaling_changes_nothing(gas<TableScene<S>>(9, 0.3, 2).scene, unit[0], unit[1],
                                       unit[2], "gas " + name);
        using Gridded =
            engine::UniformScene<S, engine::Walls, engine::NoRecorder, engine::CellGrid>;
        expect_scaling_changes_nothing(gas<Gridded>(16, 0.3, 2).scene, unit[0], unit[1], unit[2],
                                       "gridded gas " + name);
        expect_scaling_changes_nothing(random_table<TableScene<S>>(3, {}).scene, unit[0], unit[1],
                                       unit[2], "table " + name);
    }
}

}  // namespace
}  // namespace osculo::support

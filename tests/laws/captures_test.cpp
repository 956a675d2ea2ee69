#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

// Rims: a ball is gone when its centre crosses, and nothing meets it afterwards.
namespace osculo::support {
namespace {

using Scene = TableScene<double>;
using Vec = math::Vec<double>;
constexpr engine::Kind kRim = engine::kFirstObstacle;

template <class S>
class Captures : public ::testing::Test {};
TYPED_TEST_SUITE(Captures, NativeScalars, ScalarName);

TYPED_TEST(Captures, HappenWhereTheCentreCrosses) {
    using S = TypeParam;
    using Vec_ = math::Vec<S>;
    for (const double offset : {0.0, 0.3, -0.9, 0.999999, 1.0, 1.000001}) {
        Builder<TableScene<S>> builder;
        builder.rim(Vec_(S(0), S(0)), S(1)).ball(Vec_(S(-5), S(offset)), Vec_(S(2), S(0)), S(3));
        const auto played = play<TableScene<S>>(builder.scene, S(10));
        const bool inside = std::abs(offset) < 1;
        ASSERT_EQ(played.events, inside ? 1u : 0u) << offset;
        ASSERT_EQ(played.bodies[0].present, !inside);
        ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        if (inside) {
            EXPECT_EQ(played.status, Status::at_rest);
            EXPECT_LT(in_epsilons<S>(math::norm<S>(played.position(0)) - S(1)), 4);
            EXPECT_EQ(played.velocity(0), Vec_(S(2), S(0)));
        }
    }
}

TEST(Capture, OthersPassWhereTheBallWas) {
    Builder<Scene> builder;
    builder.rim({0, 0}, 0.5)
        .ball({-5, 0}, {1, 0}, 1)
        .ball({0, 30}, {0, -1}, 1)
        .ball({-0.5, 60}, {0, -1}, 1);
    const auto played = play<Scene>(builder.scene, 1000);
    // The second one is captured too; the third crosses the rim's edge only as a tangent.
    ASSERT_EQ(played.events, 2u);
    EXPECT_TRUE(played.bodies[2].present);
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

TEST(Capture, AtTheInstantOfAnotherEventOfTheBall) {
    // At 4 s the ball meets a wall, and its centre the rim: whichever the total order takes first.
    Builder<Scene> at_wall;
    at_wall.rim({6, 0}, 2).wall({5, -9}, {5, 9}).ball({0, 0}, {1, 0}, 1);
    const auto wall = play<Scene>(at_wall.scene, 100);
    ASSERT_EQ(wall.events, 1u);
    EXPECT_EQ(wall.record.events[0].kind, kRim);  // rims come first in this table's list
    EXPECT_EQ(wall.end, math::Instant<double>(4.0));
    EXPECT_TRUE(wall.audit().clean) << describe(wall.audit());

    // Two balls meet where one of them would be captured: the impact comes first and saves it.
    Builder<Scene> at_ball;
    at_ball.rim({6, 0}, 2).ball({0, 0}, {1, 0}, 1).ball({10, 0}, {-1, 0}, 1);
    const auto ball = play<Scene>(at_ball.scene, 100);
    ASSERT_GE(ball.events, 1u);
    EXPECT_TRUE(ball.audit().clean) << describe(ball.audit());
    EXPECT_FALSE(ball.bodies[1].present);

    Builder<Scene> both;
    both.rim({6, 0}, 2).ball({0, 0}, {1, 0}, 1).ball({12, 0}, {-1, 0}, 1);  // each at 2 m, at 4 s
    const auto two = play<Scene>(both.scene, 100);
    EXPECT_EQ(two.events, 2u);
    EXPECT_EQ(two.record.events[0].when, two.record.events[1].when);
    EXPECT_EQ(two.record.events[0].first, 0u);
    EXPECT_TRUE(two.audit().clean) << describe(two.audit());
}

TEST(Capture, ABallThatStartsInsideIsTakenOnlyWhenItMovesInwards) {
    const auto start = [](const Vec& velocity) {
        Builder<Scene> builder;
        builder.rim({0, 0}, 2).ball({1, 0}, velocity, 0.5);
        return play<Scene>(builder.scene, 100);
    };
    EXPECT_EQ(start({1, 0.1}).events, 0u);
    EXPECT_EQ(start({0, 1}).events, 0u);
    const auto inwards = start({-1, 0.1});
    ASSERT_EQ(inwards.events, 1u);
    EXPECT_EQ(inwards.end, math::Instant<double>(0.0));
    EXPECT_TRUE(inwards.audit().clean) << describe(inwards.audit());
}

TEST(Capture, TablesEmpty) {
    // With holes in the corners and no loss everything ends up in them sooner or later.
    std::uint64_t captured = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Random random(seed);
        Builder<Scene> builder;
        builder.box(0, 0, 2, 1);
        for (const double x : {0.0, 2.0}) {
            for (const double y : {0.0, 1.0}) builder.rim({x, y}, 0.15);
        }
        for (int k = 0; k < 10; ++k) {
            builder.ball({0.3 + 0.3 * (k % 5), 0.3 + 0.4 * (k / 5)}, random.direction<double>(),
                         0.05);
        }
        const auto played = play<Scene>(builder.scene, 1000);
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << "seed " << seed << " " << describe(audit);
        for (const auto& body : played.bodies) captured += !body.present;
        std::uint64_t events = 0;
        for (const auto& event : played.record.events) events += event.kind == kRim;
        std::uint64_t gone = 0;
        for (const auto& body : played.bodies) gone += !body.present;
        ASSERT_EQ(events, gone) << seed;
    }
    EXPECT_GT(captured, 280u);
}

}  // namespace
}  // namespace osculo::support

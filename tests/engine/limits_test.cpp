#include <limits>

#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/same_bits.hpp"
#include "support/scalars.hpp"

// How runs end, and the scenes with next to nothing in them.
namespace osculo::support {
namespace {

using Scene = TableScene<double>;
using Vec = math::Vec<double>;

TEST(Limits, NothingIsAtRest) {
    const auto played = play<Scene>(Builder<Scene>().scene, 10);
    EXPECT_EQ(played.status, Status::at_rest);
    EXPECT_EQ(played.events, 0u);
    EXPECT_EQ(played.end, math::Instant<double>(0.0));
    EXPECT_TRUE(played.audit().clean);
}

TEST(Limits, BallsAtRestAreAtRest) {
    Builder<Scene> builder;
    builder.box(-10, -10, 10, 10).ball({0, 0}, {0, 0}).ball({2, 0}, {0, 0}).ball({0, 9}, {-0.0, 0});
    const auto played = play<Scene>(builder.scene, 10);
    EXPECT_EQ(played.status, Status::at_rest);
    EXPECT_EQ(played.events, 0u);
}

TEST(Limits, OneBallFliesUntilTheTimeLimit) {
    Builder<Scene> builder;
    builder.ball({1, 2}, {3, -4});
    const auto played = play<Scene>(builder.scene, 8);
    EXPECT_EQ(played.status, Status::time_limit);
    EXPECT_EQ(played.position(0), Vec(25, -30));
    ASSERT_EQ(played.record.pieces.size(), 1u);
    EXPECT_EQ(played.record.pieces[0].to, math::Instant<double>(8.0));
}

TEST(Limits, ACapturedBallLeavesTheOthersAtRest) {
    Builder<Scene> builder;
    builder.rim({5, 0}, 1).ball({0, 0}, {1, 0}).ball({0, 5}, {0, 0}).ball({9, 0}, {0, 0});
    const auto played = play<Scene>(builder.scene, 100);
    EXPECT_EQ(played.status, Status::at_rest);
    EXPECT_EQ(played.events, 1u);
    EXPECT_FALSE(played.bodies[0].present);
    EXPECT_EQ(played.end, math::Instant<double>(4.0));
    EXPECT_EQ(played.position(0), Vec(4, 0));
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

TEST(Limits, AnEventThatWillNotHappenIsNoReasonToGoOn) {
    // Ball 1 would have met ball 0 after the time limit, but ball 0 is captured before.
    Builder<Scene> builder;
    builder.rim({5, 0}, 1).ball({0, 0}, {1, 0}).ball({100, 0}, {0, 0});
    const auto played = play<Scene>(builder.scene, 50);
    EXPECT_EQ(played.status, Status::at_rest);
    EXPECT_EQ(played.end, math::Instant<double>(4.0));
}

TEST(Limits, AnEventAtTheTimeLimitHappensAndALaterOneDoesNot) {
    Builder<Scene> builder;
    builder.wall({10, -9}, {10, 9}).ball({0, 0}, {1, 0});
    const auto at = play<Scene>(builder.scene, 9);
    EXPECT_EQ(at.status, Status::time_limit);
    EXPECT_EQ(at.events, 1u);
    EXPECT_EQ(at.position(0), Vec(9, 0));
    EXPECT_EQ(at.velocity(0), Vec(-1, 0));
    const auto before = play<Scene>(builder.scene, std::nextafter(9.0, 0.0));
    EXPECT_EQ(before.status, Status::time_limit);
    EXPECT_EQ(before.events, 0u);
    EXPECT_EQ(before.velocity(0), Vec(1, 0));
    EXPECT_TRUE(at.audit().clean && before.audit().clean);
}

TEST(Limits, TheEventLimitIsExact) {
    for (const std::uint64_t limit : {0u, 1u, 2u, 17u, 100u}) {
        const auto played = play<Scene>(gas<Scene>(9, 0.3, 1).scene, 1e9, limit);
        EXPECT_EQ(played.status, Status::event_limit);
        EXPECT_EQ(played.events, limit);
        EXPECT_EQ(played.record.events.size(), limit);
        if (limit > 0) {
            EXPECT_EQ(played.end, played.record.events.back().when);
        }
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    }
}

TEST(Limits, TheEventLimitDoesNotCountWhatDoesNotHappen) {
    Builder<Scene> builder;
    builder.ball({0, 0}, {1, 0}).ball({5, 0}, {0, 0});
    EXPECT_EQ(play<Scene>(builder.scene, 100, 1).status, Status::time_limit);
    EXPECT_EQ(play<Scene>(builder.scene, 100, 0).status, Status::event_limit);
}

TEST(Limits, AShorterRunIsTheBeginningOfALongerOne) {
    const auto whole = play<Scene>(gas<Scene>(9, 0.3, 1).scene, 1e9, 300);
    for (const std::uint64_t limit : {1u, 50u, 299u}) {
        const auto part = play<Scene>(gas<Scene>(9, 0.3, 1).scene, 1e9, limit);
        for (std::size_t k = 0; k < limit; ++k) {
            EXPECT_TRUE(same_bits<double>(part.record.events[k], whole.record.events[k])) << k;
        }
    }
}

TEST(Limits, ImpactsWithoutEndAreZeno) {
    // A ball that loses nine tenths of its normal speed at each bounce ends up sliding along the
    // inside of the circle.
    Builder<Scene> circle;
    circle.restitution(0.1, 0.1).circle({0, 0}, 10).ball({5, 0}, {0.3, 1});
    const auto sliding = play<Scene>(circle.scene, 1000);
    EXPECT_EQ(sliding.status, Status::zeno);
    EXPECT_LT(sliding.events, 2000u);
    EXPECT_TRUE(sliding.audit().clean) << describe(sliding.audit());
    EXPECT_NEAR(math::norm<double>(sliding.position(0)), 9, 1e-14);

    // And one that is driven into a narrow wedge.
    Builder<Scene> wedge;
    wedge.restitution(0, 0.1)
        .outline({Vec(0, 0), Vec(10, 0), Vec(0, 1)})
        .ball({1, 0.4}, {1, 0.1}, 0.2);
    const auto jammed = play<Scene>(wedge.scene, 1e6);
    EXPECT_EQ(jammed.status, Status::zeno);
    EXPECT_LT(jammed.events, 2000u);
    EXPECT_TRUE(jammed.audit().clean) << describe(jammed.audit());
}

/// A ball that rolls against one that is frozen to a cushion, straight.
template <class Type>
engine::SceneData<Type> squeezed(double restitution) {
    constexpr double kRadius = 0.028575;
    Builder<Type> builder;
    builder.wall({5, 0.5}, {-5, 0.5}, true)
        .ball({0, 0}, {0, 2}, kRadius, 0.17)
        .ball({0, 0.5 - kRadius}, {0, 0}, kRadius, 0.17);
    auto& scene = builder.scene;
    scene.motion = {0.2 * 9.81, 0.01 * 9.81, 0.0127 * 9.81};
    scene.contact_time = 1e-4;
    scene.friction.ball_ball = {restitution, {0, 0, 0}};
    scene.friction.ball_cushion = {restitution, 0};
    for (auto& body : scene.bodies) body.state.radius = body.radius;
    scene.bodies[0].state.spin = {-2 / kRadius, 0, 0};
    return scene;
}

// The slides of the ball at the cushion end sooner than the clock can tell, at 1e-33 m/s: hops
// double all the same, and there are at most eight events in each contact time of the slide.
TEST(Limits, WhatIsSqueezedComesToRest) {
    for (const double restitution : {0.0, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.9}) {
        using Type = engine::ClothScene<double, impact::CushionSimple, engine::ClothEvents,
                                        impact::Sequential>;
        engine::Engine<Type> engine(squeezed<Type>(restitution));
        EXPECT_EQ(engine.run({600, 100'000}), Status::at_rest) << restitution;
        EXPECT_LT(engine.event_count(), 8 * 0.3 / 1e-4) << restitution;
    }
}

TEST(Limits, InelasticCollapseEndsInRestOrZeno) {
    // Three balls in line stick together below e = 7 - 4 sqrt(3) = 0.0718 (McNamara & Young 1992).
    for (const double restitution : {0.0, 0.02, 0.05, 0.07}) {
        Builder<Scene> builder;
        builder.restitution(restitution, 1);
        builder.ball({0, 0}, {1, 0}).ball({3, 0}, {0, 0}).ball({7, 0}, {-1.25, 0});
        const auto played = play<Scene>(builder.scene, 100);
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
        EXPECT_LT(played.events, 2000u);
        EXPECT_NEAR(played.position(1).x() - played.position(0).x(), 2, 1e-13);
        EXPECT_NEAR(played.position(2).x() - played.position(1).x(), 2, 1e-13);
    }
}

TEST(Limits, WhatTheScalarCannotHoldIsNumeric) {
    Builder<Scene> builder;
    builder.ball({0, 0}, {1e300, 0});
    EXPECT_EQ(play<Scene>(builder.scene, 1e300).status, Status::numeric);

    // A ball that is smaller than the resolution of its place.
    Builder<Scene> tiny;
    tiny.ball({1e30, 0}, {1, 0}, 1e-9).ball({3e30, 1e-9}, {-1, 0}, 1e-9);
    const auto played = play<Scene>(tiny.scene, 1e31);
    EXPECT_TRUE(played.status == Status::numeric || played.audit().clean);
}

// A ball so small that it goes a part of its radius in the least time that the clock can tell.
TEST(Limits, WhereTheClockCannotTellIsNumeric) {
    using Type = TableScene<double>;
    for (const double share : {0.1, 0.9, 1.1, 10.0}) {
        Builder<Type> builder;
        builder.wall({1, -1}, {1, 1}, true).ball({0, 0}, {1, 0});
        auto& body = builder.scene.bodies[0];
        // It meets the wall at 1 s, where it may go that share of what it must not.
        body.radius = math::resolution<double>(1.0) / (share * math::kUnresolved);
        engine::Engine<Type> engine(builder.scene);
        EXPECT_EQ(engine.run({10, 10}), share < 1 ? Status::time_limit : Status::numeric) << share;
        EXPECT_EQ(engine.event_count(), share < 1 ? 1u : 0u) << share;
    }
}

TEST(Limits, TheSameSceneIsTheSameRun) {
    const auto scene = gas<Scene>(12, 0.4, 9).scene;
    EXPECT_TRUE(same_bits(play<Scene>(scene, 1e9, 1000), play<Scene>(scene, 1e9, 1000)));
}

}  // namespace
}  // namespace osculo::support

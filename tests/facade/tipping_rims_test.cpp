#include "pulling_rims.hpp"

/// Rims with the law tipping, as the facade offers them.
namespace osculo {
namespace {

using test::distance;
using test::first_of;

constexpr double kRadius = test::kBallRadius;
constexpr double kRim = 0.0571;

Scene hole(MotionLaw motion) {
    return test::hole_scene(std::move(motion), {"hole", {0, 0}, kRim, RimLaw::tipping, 0.6},
                            {0.5, 0.015});
}

/// A ball alone, straight at the hole.
Run alone(MotionLaw motion, double speed, double restitution = 0.6) {
    Scene scene = hole(motion);
    scene.balls.resize(1);
    scene.balls[0].position = {-kRim - 1e-3, 0};
    scene.balls[0].velocity = {speed, 0};
    scene.segments.clear();
    scene.arcs.clear();
    scene.rims[0].restitution = restitution;
    return simulate(scene, {.audit = true});
}

/// NUMERICS 3.5: it lifts off where cos(tilt) = (2 + v^2 / (g r)) / 3, rolling (10 + 7 ...) / 17.
TEST(TippingRims, LiftOffAtThePublishedTilt) {
    const double v = 0.3;
    const double square = v * v / (9.81 * kRadius);
    for (const bool rolls : {false, true}) {
        const auto run = alone(rolls ? MotionLaw(RollingMotion{0}) : MotionLaw(UniformMotion{}), v);
        EXPECT_EQ(run.status, Status::at_rest);
        const Event* lift = first_of(run, EventKind::transition, Phase::tipping);
        ASSERT_TRUE(lift);
        EXPECT_EQ(lift->to, Phase::flying);
        const double cosine = rolls ? (10 + 7 * square) / 17 : (2 + square) / 3;
        const double sine = (kRim - distance(lift->point, {0, 0})) / kRadius;
        EXPECT_NEAR(sine, std::sqrt(1 - cosine * cosine), 1e-14);
        // The edge pushes no more where gravity bends the way: speed^2 = g r cos.
        const double inwards = lift->before[0].velocity.x;
        EXPECT_NEAR(inwards, std::sqrt(9.81 * kRadius * cosine) * cosine, 1e-14);
        EXPECT_EQ(run.balls[0].fate, BallFate::captured);
        EXPECT_EQ(run.balls[0].rim, 0U);
        EXPECT_TRUE(run.audit->clean);
    }
}

/// From sqrt(g r) on it flies at once: it falls in, or hits the far edge, or gets over that.
TEST(TippingRims, FastBallsFly) {
    const double fly = std::sqrt(9.81 * kRadius);
    const auto falls = alone(UniformMotion{}, fly * 1.0001);
    ASSERT_GE(falls.events.size(), 2U);
    EXPECT_EQ(falls.events[1].kind, EventKind::capture);
    // A parabola: the centre falls by a radius.
    EXPECT_NEAR(falls.events[1].time - falls.events[0].time, std::sqrt(2 * kRadius / 9.81), 1e-15);

    const auto hits = alone(UniformMotion{}, 1.5, 0);
    const Event* hit = first_of(hits, EventKind::transition, Phase::flying);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hits.audit->unexplained, 0U);
    const double t = hit->time - hits.events[0].time;
    const double height = kRadius - 9.81 * t * t / 2;
    EXPECT_NEAR(std::hypot(kRim - distance(hit->point, {0, 0}), height), kRadius, 1e-15);

    const auto crosses = alone(UniformMotion{}, 6, 1);
    const Event* exit = first_of(crosses, EventKind::rim_exit);
    ASSERT_TRUE(exit);
    EXPECT_GT(exit->point.x, 0);
    EXPECT_NEAR(distance(exit->point, {0, 0}), kRim, 1e-15);
    EXPECT_LT(std::hypot(exit->after[0].velocity.x, exit->after[0].velocity.y), 6);
    for (const auto* run : {&falls, &hits, &crosses}) EXPECT_TRUE(run->audit->clean);
}

TEST(TippingRims, PiecesFollowEachOther) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        const auto run = simulate(hole(motion), {.audit = true});
        ASSERT_TRUE(run.audit);
        EXPECT_TRUE(run.audit->clean) << run.audit->worst_gap << " " << run.audit->unexplained;
        EXPECT_LT(std::abs(run.audit->worst_gap), 1e-13);  // something touched
        EXPECT_LE(run.audit->energy_final, run.audit->energy_initial);
        test::expect_continuous(run);
        int on_edge = 0;
        int in_flight = 0;
        for (const Piece& piece : run.pieces) {
            on_edge += piece.phase == Phase::tipping;
            in_flight += piece.phase == Phase::flying;
            if (piece.phase != Phase::tipping && piece.phase != Phase::flying) continue;
            EXPECT_EQ(piece.rim, 0U);
            EXPECT_GE(piece.height, 0);
            const double off = std::hypot(kRim - distance(piece.position, {0, 0}), piece.height);
            if (piece.phase == Phase::tipping) {
                EXPECT_NEAR(off, kRadius, 1e-16);
            } else {
                EXPECT_GE(off, kRadius - 1e-16);
            }
            const auto state = run.at(piece.ball, (piece.from + piece.to) / 2);
            ASSERT_TRUE(state);
            EXPECT_LE(distance(state->position, {0, 0}), kRim);
        }
        EXPECT_GE(on_edge, 1);
        EXPECT_GE(in_flight, 1);
        EXPECT_TRUE(first_of(run, EventKind::ball_ball));
    }
}

TEST(TippingRims, PrecisionsAgree) {
    test::expect_agreement_of_precisions(hole(RollingMotion{0.01}));
}

TEST(TippingRims, HaveEnginesOfTheirOwn) {
    Scene scene = hole(UniformMotion{});
    EXPECT_NE(choose_engine(scene).name.find("rolling+tipping-rims/"), std::string::npos);
    scene.rims[0].restitution = {};
    scene.rims[0].law = RimLaw::paper;
    EXPECT_NE(choose_engine(scene).name.find("rolling+rims/"), std::string::npos);
    scene.rims[0].law = RimLaw::capture;
    EXPECT_EQ(choose_engine(scene).name.find("rims/"), choose_engine(scene).name.rfind("rims/"));
    EXPECT_EQ(choose_engine(scene).name.find("tipping"), std::string::npos);
}

TEST(TippingRims, ScenesThatMakeNoSenseAreRefused) {
    auto all = test::spoilings(RimLaw::tipping);
    all.push_back({"rims[1].law", [](Scene& s) { s.rims[1].law = RimLaw::paper; }});
    all.push_back({"rims[0].restitution", [](Scene& s) { s.rims[0].restitution = 1.5; }});
    all.push_back({"rims[1].restitution", [](Scene& s) { s.rims[1].restitution = 0.5; }});
    test::expect_refusals(hole(UniformMotion{}), all);
}

/// Left out, the edge's restitution is that of cushions.
TEST(TippingRims, EdgesAreCushionsUnlessTheySay) {
    Scene scene = hole(UniformMotion{});
    scene.rims[0].restitution = 0.8;
    const auto given = simulate(scene);
    scene.rims[0].restitution = {};
    EXPECT_EQ(simulate(scene).events, given.events);
}

}  // namespace
}  // namespace osculo

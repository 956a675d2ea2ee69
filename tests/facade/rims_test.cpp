#include "pulling_rims.hpp"

/// Rims with the law paper, as the facade offers them.
namespace osculo {
namespace {

using test::distance;
using test::first_of;

Scene hole(MotionLaw motion) {
    return test::hole_scene(std::move(motion), {"hole", {0, 0}, 0.06, RimLaw::paper}, {0.7, 0.02});
}

TEST(PaperRims, BallsComeInFallAndLeave) {
    Scene scene = hole(UniformMotion{});
    scene.balls.resize(1);
    const auto run = simulate(scene);
    EXPECT_EQ(run.status, Status::at_rest);
    const Event* entry = first_of(run, EventKind::rim_entry);
    const Event* fall = first_of(run, EventKind::capture);
    ASSERT_TRUE(entry && fall);
    EXPECT_EQ(run.ids(*entry)[1], "hole");
    EXPECT_NEAR(distance(entry->point, {0, 0}), 0.06, 1e-16);
    EXPECT_NEAR(distance(fall->point, {0, 0}), 0.06 - 0.028575, 1e-16);
    EXPECT_EQ(run.balls[0].fate, BallFate::captured);
    EXPECT_EQ(run.balls[0].rim, 0U);

    scene.balls[0].position = {-0.06 - 0.1, 0.04};
    scene.balls[0].velocity = {1, 0};
    const auto pass = simulate(scene);
    const Event* exit = first_of(pass, EventKind::rim_exit);
    ASSERT_TRUE(exit);
    EXPECT_EQ(pass.ids(*exit)[1], "hole");
    EXPECT_NEAR(distance(exit->point, {0, 0}), 0.06, 1e-16);
    EXPECT_NEAR(std::hypot(exit->after[0].velocity.x, exit->after[0].velocity.y), 1, 1e-15);
}

TEST(PaperRims, PiecesFollowEachOther) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        const auto run = simulate(hole(motion));
        test::expect_continuous(run);
        int in_rims = 0;
        for (const Piece& piece : run.pieces) {
            in_rims += piece.phase == Phase::rim;
            const double middle = (piece.from + piece.to) / 2;
            const auto state = run.at(piece.ball, middle);
            ASSERT_TRUE(state);
            if (piece.phase == Phase::rim) {
                EXPECT_EQ(piece.rim, 0U);
                EXPECT_LE(distance(state->position, {0, 0}), 0.06 * (1 + 1e-15));
                EXPECT_GE(distance(state->position, {0, 0}), (0.06 - 0.028575) * (1 - 1e-15));
            }
        }
        EXPECT_GE(in_rims, 1);
        EXPECT_TRUE(first_of(run, EventKind::ball_ball));
    }
}

TEST(PaperRims, AreAuditedClean) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        const auto run = simulate(hole(motion), {.audit = true});
        ASSERT_TRUE(run.audit);
        EXPECT_TRUE(run.audit->clean) << run.audit->worst_gap << " " << run.audit->unexplained;
        EXPECT_LT(std::abs(run.audit->worst_gap), 1e-13);  // something touched
        EXPECT_LE(run.audit->energy_final, run.audit->energy_initial * (1 + 1e-14));
    }
}

TEST(PaperRims, PrecisionsAgree) {
    test::expect_agreement_of_precisions(hole(RollingMotion{0.01}));
}

TEST(PaperRims, EnginesAreAsNarrowAsWithoutThem) {
    Scene scene = hole(UniformMotion{});
    EXPECT_NE(choose_engine(scene).name.find("rolling+rims"), std::string::npos);
    scene.rims[0].law = RimLaw::capture;
    EXPECT_EQ(choose_engine(scene).name.find("+rims/"), std::string::npos);
}

TEST(PaperRims, ScenesThatMakeNoSenseAreRefused) {
    test::expect_refusals(hole(UniformMotion{}), test::spoilings(RimLaw::paper));
}

/// A rim that balls may cross closes nothing.
TEST(PaperRims, CloseNoOutline) {
    Scene scene = hole(UniformMotion{});
    scene.balls.resize(1);
    scene.balls[0].position = {0.5, 0.5};
    scene.arcs.clear();
    scene.segments = {{"1", {0, 0}, {0.9, 0}},
                      {"2", {1, 0.1}, {1, 1}},
                      {"3", {1, 1}, {0, 1}},
                      {"4", {0, 1}, {0, 0}}};
    scene.rims = {{"hole", {1, 0}, 0.11, RimLaw::capture}};
    scene.closed = true;
    EXPECT_NO_THROW(validate(scene));
    scene.rims[0].law = RimLaw::paper;
    EXPECT_THROW(validate(scene), SceneError);
}

}  // namespace
}  // namespace osculo

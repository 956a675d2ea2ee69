#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo::io {
namespace {

Scene scene_with_drag() {
    Scene scene;
    test::add_box(scene, 4, 4);
    scene.motion = ResistedMotion{0.1, 0.02, 0.03, Medium{1.2, 1.8e-5, 0.47, true}};
    scene.balls = {test::ball("a", {1, 1.5}, {2, 0.7}, 0.25), test::ball("b", {3, 2}, {}, 0.25)};
    return scene;
}

TEST(DragJson, ASceneComesBackAsItWas) {
    Scene scene = scene_with_drag();
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
    std::get<ResistedMotion>(scene.motion).medium.reset();
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
    scene.impacts.ball_cushion = {CushionLaw::frictional, 0.8, 0.2};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.9, {0.1, 0, 0}};
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
}

TEST(DragJson, LeftOutCoefficientsAreZero) {
    const Scene scene = scene_from_json(
        R"({"schema": "osculo/scene-1", "motion": {"law": "resisted", "quadratic": 0.5},
            "balls": []})");
    EXPECT_EQ(std::get<ResistedMotion>(scene.motion), (ResistedMotion{0, 0, 0.5, {}}));
}

TEST(DragJson, ARunComesBackAsItWas) {
    const auto run = simulate(scene_with_drag(), {.audit = true});
    const auto back = run_from_json(run_to_json(run));
    EXPECT_EQ(back.pieces, run.pieces);
    EXPECT_EQ(back.events, run.events);
    EXPECT_EQ(back.scene, run.scene);
    EXPECT_EQ(run_to_json(back), run_to_json(run));
}

/// The ways are straight: one line for each piece, to where the ball is at its end.
TEST(DragJson, APictureHasTheWays) {
    const auto run = simulate(scene_with_drag());
    const std::string svg = to_svg(run);
    EXPECT_NE(svg.find("<path"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    std::size_t moves = 0;
    for (const Piece& piece : run.pieces) {
        if (piece.phase != Phase::resisted) continue;
        ++moves;
        const double wait = piece.to - piece.from;
        const auto end = state_in(piece, 0.25, wait).position;
        const auto at = run.at(piece.ball, piece.to)->position;
        EXPECT_NEAR(end.x, at.x, 1e-14);
        EXPECT_NEAR(end.y, at.y, 1e-14);
    }
    EXPECT_GT(moves, 2U);
}

}  // namespace
}  // namespace osculo::io

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

Scene two_balls() {
    Scene scene;
    scene.balls = {test::ball("b", {3, 0}), test::ball("a", {0, 0}, {1, 0})};
    scene.limits.time = 5;
    return scene;
}

TEST(Run, AtFollowsThePieces) {
    const auto run = simulate(two_balls());
    ASSERT_EQ(run.events.size(), 1U);
    EXPECT_EQ(run.events[0].time, 2);
    EXPECT_EQ(run.at(1, 0)->position, (Point{0, 0}));
    EXPECT_EQ(run.at(1, 1.25)->position, (Point{1.25, 0}));
    EXPECT_EQ(run.at(1, 4)->position, (Point{2, 0}));
    EXPECT_EQ(run.at(0, 1)->position, (Point{3, 0}));
    EXPECT_EQ(run.at(0, 4.5)->position, (Point{5.5, 0}));
    EXPECT_EQ(run.at(0, 4.5)->velocity, (Point{1, 0}));
    EXPECT_FALSE(run.at(0, 5.5));
    EXPECT_FALSE(run.at(0, -1));
}

TEST(Run, AtOnAPieceIsAtOfItsBall) {
    const auto run = simulate(two_balls());
    ASSERT_EQ(run.pieces.size(), 4U);
    for (const Piece& piece : run.pieces) {
        const double middle = (piece.from + piece.to) / 2;
        EXPECT_EQ(run.at(piece, middle), run.at(piece.ball, middle));
    }
}

TEST(Run, AtKnowsNothingAfterACapture) {
    Scene scene = two_balls();
    scene.rims = {{"hole", {6, 0}, 0.5}};
    const auto run = simulate(scene);
    ASSERT_EQ(run.balls[0].fate, BallFate::captured);
    EXPECT_EQ(run.balls[0].rim, 0U);
    EXPECT_TRUE(run.at(0, 4.4));
    EXPECT_FALSE(run.at(0, 4.6));
    EXPECT_EQ(run.events.back().kind, EventKind::capture);
    EXPECT_EQ(run.events.back().time, 4.5);
    EXPECT_EQ(run.events.back().point, (Point{5.5, 0}));
}

TEST(Run, IdsNameWhatTakesPart) {
    Scene scene;
    test::add_box(scene, 4, 4);
    scene.arcs = {{"post", {2, 2}, 0.25}};
    scene.rims = {{"hole", {3, 3}, 0.25}};
    scene.balls = {test::ball("q", {1, 2}, {1, 0}, 0.25), test::ball("c", {1, 1}, {1, 1}, 0.25),
                   test::ball("d", {2, 0.5}, {0, -0.25}, 0.25)};
    scene.balls[1].position = {3, 1};
    scene.balls[1].velocity = {0, 1};
    scene.segments.push_back({"bar", {-3, 0.5}, {-2, 0.5}});
    scene.balls.push_back(test::ball("e", {-3.5, 0.5}, {1, 0}, 0.25));
    scene.limits.time = 2;
    scene.limits.events = 4;
    const auto run = simulate(scene);
    ASSERT_EQ(run.events.size(), 4U);
    using Ids = std::array<std::string, 2>;
    for (const Event& event : run.events) {
        switch (event.kind) {
            case EventKind::ball_segment: EXPECT_EQ(run.ids(event), (Ids{"d", "bottom"})); break;
            case EventKind::ball_point: EXPECT_EQ(run.ids(event), (Ids{"e", "bar.from"})); break;
            case EventKind::ball_arc: EXPECT_EQ(run.ids(event), (Ids{"q", "post"})); break;
            case EventKind::capture: EXPECT_EQ(run.ids(event), (Ids{"c", "hole"})); break;
            default: FAIL(); break;
        }
    }
}

}  // namespace
}  // namespace osculo

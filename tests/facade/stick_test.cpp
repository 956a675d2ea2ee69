#include "stick.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace osculo {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kNose = 0.036576;

/// A cloth of 2 m x 1 m whose cue ball is shot along x.
Scene shot(Point cue_ball) {
    Scene scene;
    test::add_box(scene, 2, 1);
    scene.balls = {test::ball("cue", cue_ball, {}, kRadius)};
    scene.motion = ClothMotion{};
    scene.impacts.ball_cushion = {CushionLaw::han_2005, 0.85, 0.2, kNose};
    scene.cue = Cue{.speed = 2};
    return scene;
}

double least(const Scene& scene) {
    return least_elevation(scene).value();
}

std::string error_of(const Scene& scene) {
    try {
        validate(scene);
        return "no error";
    } catch (const SceneError& error) {
        return error.what();
    }
}

TEST(Stick, PassesOverTheRailBehindTheBall) {
    // The tip is at (-r cos e, r + r sin e); at the rail its underside must be at the nose.
    for (const double x : {0.1, 0.3, 1.0}) {
        const Scene scene = shot({x, 0.5});
        const double e = least(scene);
        const auto underside = [&](double elevation) {
            return kRadius + x * std::tan(elevation) - facade::kStickRadius / std::cos(elevation);
        };
        EXPECT_GE(underside(e), kNose) << x;
        EXPECT_LT(underside(e - 0.001), kNose) << x;
    }
}

TEST(Stick, IsFreeFarFromRails) {
    EXPECT_EQ(least(shot({1.6, 0.5})), 0);  // longer than the stick
    Scene scene = shot({1, 0.5});
    scene.segments.clear();
    EXPECT_EQ(least(scene), 0);
    EXPECT_EQ(error_of(scene), "no error");
}

// Shot away from a rail that it touches, a ball can only be struck from above; struck above its
// middle, from less far above.
TEST(Stick, RisesSteeplyFromARailThatTheBallTouches) {
    Scene scene = shot({kRadius, 0.5});
    const double e = least(scene);
    EXPECT_NEAR(e, 0.49, 0.01);  // r + r sin e + r (1 - cos e) tan e - stick / cos e = nose
    scene.cue->offset = {0, 0.5};
    EXPECT_LT(least(scene), 0.8 * e);
    scene.cue->offset = {};
    EXPECT_EQ(error_of(scene).substr(0, 32), "cue.elevation: must be at least ");
    EXPECT_NE(error_of(scene).find("segments[3] (\"left\")"), std::string::npos) << error_of(scene);
    scene.cue->elevation = e;
    EXPECT_EQ(error_of(scene), "no error");
    // Along the rail and towards it nothing is in the way.
    scene.cue->azimuth = std::numbers::pi / 2;
    EXPECT_LT(least(scene), 0.05);
    scene.cue->azimuth = std::numbers::pi;
    EXPECT_LT(least(scene), 0.02);
}

TEST(Stick, PassesOverABallBehindTheBall) {
    for (const double behind : {2 * kRadius, 3 * kRadius, 0.3}) {
        Scene scene = shot({1.6, 0.5});
        scene.balls.push_back(test::ball("8", {1.6 - behind, 0.5}, {}, kRadius));
        const double e = least(scene);
        // The axis, a radius above the cloth at the ball's middle, must pass that far from the
        // other's middle.
        const double clearance = behind * std::sin(e);
        EXPECT_GE(clearance, kRadius + facade::kStickRadius) << behind;
        EXPECT_LT(behind * std::sin(e - 0.001), kRadius + facade::kStickRadius) << behind;
        EXPECT_NE(error_of(scene).find("to pass over balls[1] (\"8\")"), std::string::npos);
        // Beside the stick it is not in its way.
        scene.balls[1].position.y += kRadius + facade::kStickRadius + 1e-9;
        EXPECT_EQ(least(scene), 0) << behind;
        scene.balls[1].position.y -= 2e-9;
        EXPECT_GT(least(scene), 0) << behind;
    }
}

TEST(Stick, ABallInFrontIsNotInItsWay) {
    Scene scene = shot({1.6, 0.5});
    scene.balls.push_back(test::ball("1", {1.6 + 2 * kRadius, 0.5}, {}, kRadius));
    EXPECT_EQ(least(scene), 0);
}

TEST(Stick, PassesOverArcs) {
    Scene scene = shot({1.6, 0.5});
    scene.segments.clear();
    scene.arcs = {{"post", {1, 0.5}, 0.1}};
    const double e = least(scene);
    EXPECT_GT(e, 0);
    EXPECT_NE(error_of(scene).find("arcs[0] (\"post\")"), std::string::npos);
    scene.arcs[0].from_angle = 1;  // only the far side of the circle is left of the way
    scene.arcs[0].to_angle = 2;
    EXPECT_EQ(least(scene), 0);
    scene.arcs[0].from_angle = 3;
    scene.arcs[0].to_angle = 3.3;
    EXPECT_GT(least(scene), 0);
    EXPECT_LT(least(scene), e);
}

TEST(Stick, WithoutAHeightTheNoseIsAt64PercentOfTheBall) {
    Scene scene = shot({0.3, 0.5});
    const double e = least(scene);
    scene.impacts.ball_cushion = {};
    EXPECT_EQ(least(scene), e);
}

TEST(Stick, MayBeAllowedThroughEverything) {
    Scene scene = shot({0.3, 0.5});
    EXPECT_NE(error_of(scene), "no error");
    scene.cue->allow_obstructed = true;
    EXPECT_EQ(error_of(scene), "no error");
}

TEST(Stick, SaysNothingAboutStrikesThatAreOtherwiseImpossible) {
    Scene scene = shot({0.3, 0.5});
    scene.cue->offset = {0.8, 0.8};
    EXPECT_EQ(least(scene), 0);
    EXPECT_EQ(error_of(scene).substr(0, 11), "cue.offset:");
    scene.cue->offset = {};
    scene.cue->ball = "none";
    EXPECT_EQ(least(scene), 0);
    EXPECT_EQ(error_of(scene).substr(0, 9), "cue.ball:");
    scene.cue.reset();
    EXPECT_EQ(least(scene), 0);
}

}  // namespace
}  // namespace osculo

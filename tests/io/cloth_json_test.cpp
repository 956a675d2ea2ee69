#include <vector>

#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

namespace osculo::io {
namespace {

/// A short shot with everything that a cloth brings along.
Scene shot() {
    Scene scene;
    presets::add_table(scene, "pool-7ft");
    scene.balls = {{"cue", 0.17, 0.028575, {0.5, 0.5}, {}, {}},
                   {"1", 0.17, 0.028575, {0.52, 1.2}, {}, {}, 0.35}};
    scene.motion = ClothMotion{0.21, 0.011, 0.013};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.95, {0.009951, 0.108, 1.088}};
    scene.impacts.ball_cushion = {CushionLaw::han_2005, 0.85, 0.2, 0.036576};
    scene.impacts.contact_time = 2e-4;
    scene.impacts.rest_speed = 1e-5;
    Cue cue;
    cue.ball = "cue";
    cue.speed = 2.5;
    cue.azimuth = 1.57;
    cue.elevation = 0.1;
    cue.offset = {0.2, -0.3};
    scene.cue = cue;
    return scene;
}

TEST(ClothJson, ASceneComesBackAsItWas) {
    const Scene scene = shot();
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
    Scene through = shot();
    through.cue->elevation = 0;
    through.cue->allow_obstructed = true;
    EXPECT_EQ(scene_from_json(scene_to_json(through)), through);
    Scene rolling = shot();
    rolling.motion = RollingMotion{0.02};
    rolling.impacts = {};
    rolling.cue.reset();
    EXPECT_EQ(scene_from_json(scene_to_json(rolling)), rolling);
}

TEST(ClothJson, ACueWithoutElevationIsAsLevelAsCanBe) {
    const auto elevation = [](const std::string& cue) {
        return scene_from_json(R"({"schema": "osculo/scene-1", "table": "pool-9ft",
            "rack": "nine-ball", "cue": {"speed": 5, "azimuth": 1.5707963267948966)" +
                               cue + "}}")
            .cue->elevation;
    };
    EXPECT_EQ(elevation(""), 0.023);
    EXPECT_EQ(elevation(R"(, "elevation": 0.3)"), 0.3);
    EXPECT_EQ(elevation(R"(, "allow_obstructed": true)"), 0);
    EXPECT_EQ(elevation(R"(, "allow_obstructed": false)"), 0.023);
    try {
        static_cast<void>(elevation(R"(, "elevation": 0.0)"));
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(),
                     "cue.elevation: must be at least 0.023 (1.4 degrees) for the stick to pass "
                     "over segments[1] (\"bottom\") (or set allow_obstructed), but it is 0");
    }
    // Broken scenes say what is broken.
    try {
        static_cast<void>(elevation(R"(, "ball": "white")"));
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(), "cue.ball: must be the id of a ball, but it is \"white\"");
    }
}

/// The cushion laws with friction, with and without what only they have.
TEST(ClothJson, EveryCushionComesBackAsItWas) {
    std::vector<CushionImpact> cushions(4, shot().impacts.ball_cushion);
    cushions[0].law = CushionLaw::stronge;
    cushions[1].law = CushionLaw::stronge;
    cushions[1].frequency_ratio = 1.7;
    cushions[2].law = CushionLaw::mathavan_2010;
    cushions[3].law = CushionLaw::mathavan_2010;
    cushions[3].cloth_friction = 0.15;
    for (const CushionImpact& cushion : cushions) {
        Scene scene = shot();
        scene.impacts.ball_cushion = cushion;
        const std::string json = scene_to_json(scene);
        EXPECT_EQ(scene_from_json(json), scene);
        EXPECT_EQ(scene_from_msgpack(msgpack_from_json(json)), scene);
    }
    EXPECT_NE(cushions[2], cushions[3]);
}

TEST(ClothJson, ARunComesBackAsItWas) {
    const auto run = simulate(shot());
    EXPECT_EQ(run.status, Status::at_rest);
    const auto again = run_from_json(run_to_json(run));
    EXPECT_EQ(again.scene, run.scene);
    EXPECT_EQ(again.events, run.events);
    EXPECT_EQ(again.pieces, run.pieces);
    EXPECT_EQ(again.balls, run.balls);
    int transitions = 0;
    for (const Event& event : run.events) transitions += event.kind == EventKind::transition;
    EXPECT_GT(transitions, 2);
}

TEST(ClothJson, APictureShowsCurvesAndNoTransitions) {
    const std::string svg = to_svg(simulate(shot()));
    EXPECT_NE(svg.find("cue meets"), std::string::npos);
    EXPECT_EQ(svg.find("transition"), std::string::npos);
}

}  // namespace
}  // namespace osculo::io

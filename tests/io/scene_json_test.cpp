#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "random_scene.hpp"

namespace osculo::io {
namespace {

TEST(SceneJson, RoundTripIsTheIdentity) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const Scene scene = test::random_scene(seed);
        const std::string text = scene_to_json(scene);
        ASSERT_EQ(scene_from_json(text), scene) << text;
        // Equality takes -0 for 0; the text does not.
        ASSERT_EQ(scene_to_json(scene_from_json(text)), text);
    }
}

TEST(SceneJson, GivesBackWhatMeansNothingToIt) {
    Scene scene;  // no force presses anything
    scene.impacts.contact_time = 0.5;
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
}

TEST(SceneJson, RoundTripOfPresets) {
    for (const presets::Info& info : presets::list()) {
        const Scene scene = presets::make(info.name);
        EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene) << info.name;
    }
}

TEST(SceneJson, ShortPresetsAreTheWholeScene) {
    int count = 0;
    for (const presets::Info& info : presets::list()) {
        const auto text = presets::short_text(info.name);
        if (!text) continue;
        EXPECT_EQ(scene_from_json(*text), presets::make(info.name)) << *text;
        EXPECT_LT(text->size(), 250U);
        ++count;
    }
    EXPECT_EQ(count, 4);
    const presets::Parameters parameters{.gap = 3e-4, .speed = 6.5, .seed = 12};
    EXPECT_EQ(scene_from_json(*presets::short_text("nine-ball", parameters)),
              presets::make("nine-ball", parameters));
}

TEST(SceneJson, ATableBringsItsLaws) {
    const auto read = [](const std::string& members) {
        return scene_from_json(R"({"schema": "osculo/scene-1", "table": "pool-9ft")" + members +
                               "}");
    };
    Scene laws;
    presets::set_table_laws(laws, "pool-9ft");
    EXPECT_EQ(read("").motion, laws.motion);
    EXPECT_EQ(read("").impacts, laws.impacts);

    // What is given stands; the rest is the table's.
    const Scene other_cloth = read(R"(, "motion": {"law": "cloth", "rolling_friction": 0.02})");
    EXPECT_EQ(std::get<ClothMotion>(other_cloth.motion).rolling_friction, 0.02);
    EXPECT_EQ(other_cloth.impacts, laws.impacts);
    const Scene other_balls =
        read(R"(, "impacts": {"ball_ball": {"law": "restitution", "restitution": 0.9}})");
    EXPECT_EQ(other_balls.impacts.ball_ball.law, BallBallLaw::restitution);
    EXPECT_EQ(other_balls.impacts.ball_cushion, laws.impacts.ball_cushion);

    // The friction of a table's impacts needs its cloth.
    EXPECT_EQ(read(R"(, "motion": {"law": "uniform"})").impacts, Impacts{});
}

TEST(SceneJson, TheCueStrikesTheCueBall) {
    const Scene scene = scene_from_json(
        R"({"schema": "osculo/scene-1", "table": "pool-9ft", "rack": "eight-ball",
            "cue": {"speed": 8, "azimuth": 1.5707963267948966}})");
    EXPECT_EQ(scene.cue->ball, "cue");
    EXPECT_EQ(scene.cue->azimuth, 1.5707963267948966);
    EXPECT_EQ(scene.balls.back().id, "cue");
}

TEST(SceneJson, IsWrittenAsDocumented) {
    Scene scene;
    scene.balls.push_back({"cue", 0.17, 0.5, {0.1, -0.0}, {1e-7, 1e22}, {0, 0, -2}});
    scene.balls.push_back({"1", 1, 0.25, {3, 2}, {}, {}});
    scene.segments.push_back({"wall", {0, -1}, {9, -1}, Side::left});
    scene.arcs.push_back({"peg", {5, 5}, 0.3, 0, 1.5});
    scene.rims.push_back({"hole", {-4, 0}, 1, RimLaw::capture});
    scene.impacts.ball_cushion.restitution = 0.85;
    scene.limits = {2.5, 100};
    EXPECT_EQ(scene_to_json(scene), R"({
  "schema": "osculo/scene-1",
  "motion": {"law": "uniform"},
  "gravity": 9.81,
  "balls": [
    {"id": "cue", "mass": 0.17, "radius": 0.5, "position": [0.1, -0.0], "velocity": [1e-07, 1e+22], "spin": [0, 0, -2]},
    {"id": "1", "mass": 1, "radius": 0.25, "position": [3, 2], "velocity": [0, 0]}
  ],
  "segments": [
    {"id": "wall", "from": [0, -1], "to": [9, -1], "side": "left"}
  ],
  "arcs": [
    {"id": "peg", "center": [5, 5], "radius": 0.3, "from_angle": 0, "to_angle": 1.5}
  ],
  "rims": [
    {"id": "hole", "center": [-4, 0], "radius": 1, "law": "capture"}
  ],
  "impacts": {"ball_ball": {"law": "restitution", "restitution": 1}, "ball_cushion": {"law": "restitution", "restitution": 0.85}, "simultaneous": "symmetric"},
  "closed": false,
  "limits": {"time": 2.5, "events": 100}
}
)");
}

TEST(SceneJson, LeavesDefaultsToTheReader) {
    const Scene scene = scene_from_json(R"({"schema": "osculo/scene-1",
        "balls": [{"id": "a", "mass": 2, "radius": 1, "position": [0, 0]}],
        "segments": [{"id": "s", "from": [5, 0], "to": [5, 5]}],
        "arcs": [{"id": "c", "center": [-5, 0], "radius": 1}],
        "rims": [{"id": "r", "center": [0, -9], "radius": 1}]})");
    Scene expected;
    expected.balls.push_back({"a", 2, 1, {0, 0}, {}, {}});
    expected.segments.push_back({"s", {5, 0}, {5, 5}, Side::both});
    expected.arcs.push_back({"c", {-5, 0}, 1});
    expected.rims.push_back({"r", {0, -9}, 1, RimLaw::capture});
    EXPECT_EQ(scene, expected);
}

TEST(SceneJson, WholeNumbersMayHaveExponents) {
    const Scene scene = scene_from_json(
        R"({"schema": "osculo/scene-1", "limits": {"events": 1e6},
            "balls": [{"id": "a", "mass": 1, "radius": 1, "position": [0, 0]}]})");
    EXPECT_EQ(scene.limits.events, 1'000'000U);
}

TEST(SceneJson, ExpandsTableAndRackAfterTheBallsThatAreListed) {
    const Scene scene = scene_from_json(R"({"schema": "osculo/scene-1",
        "table": "pool-7ft", "rack": {"name": "eight-ball", "gap": 0.001},
        "balls": [{"id": "cue", "mass": 0.17, "radius": 0.028, "position": [0.5, 0.5]}]})");
    Scene expected;
    presets::add_table(expected, "pool-7ft");
    presets::add_rack(expected, "eight-ball", {.gap = 0.001});
    ASSERT_EQ(scene.balls.size(), 16U);
    EXPECT_EQ(scene.balls[0].id, "cue");
    EXPECT_EQ(scene.balls[0].position, (Point{0.5, 0.5}));
    EXPECT_EQ(scene.balls[4], expected.balls[3]);
    EXPECT_EQ(scene.segments, expected.segments);
    EXPECT_TRUE(scene.closed);

    const Scene tight = scene_from_json(
        R"({"schema": "osculo/scene-1", "table": "pool-7ft",
            "rack": {"name": "eight-ball", "gap": 0}, "closed": false})");
    EXPECT_EQ(tight.balls[1].position.x, expected.balls[0].position.x - 0.028575);
    EXPECT_EQ(tight.balls[15].id, "cue");
    EXPECT_FALSE(tight.closed);
}

TEST(SceneJson, RacksHaveSeeds) {
    const Scene scene = scene_from_json(R"({"schema": "osculo/scene-1", "table": "pool-9ft",
        "rack": {"name": "nine-ball", "gap": 2e-4, "seed": 18446744073709551615}})");
    Scene expected;
    presets::add_table(expected, "pool-9ft");
    presets::add_rack(expected, "nine-ball", {.gap = 2e-4, .seed = 18446744073709551615U});
    EXPECT_EQ(scene.balls, expected.balls);
}

}  // namespace
}  // namespace osculo::io

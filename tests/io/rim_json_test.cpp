#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/simulate.hpp"

/// Files of scenes and runs with rims that pull.
namespace osculo::io {
namespace {

constexpr const char* kScene = R"({
  "schema": "osculo/scene-1",
  "motion": {"law": "rolling", "friction": 0.01},
  "balls": [{"id": "a", "mass": 0.17, "radius": 0.03, "position": [-0.2, 0], "velocity": [1, 0]},
            {"id": "b", "mass": 0.17, "radius": 0.03, "position": [-0.2, 0.2], "velocity": [0.8, -0.65]}],
  "rims": [{"id": "hole", "center": [0, 0], "radius": 0.07, "law": "paper"}]
})";

TEST(RimFiles, RunsComeBackAsTheyWere) {
    const Scene scene = scene_from_json(kScene);
    EXPECT_EQ(scene.rims[0].law, RimLaw::paper);
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);

    const osculo::Run run = simulate(scene);
    const std::string text = run_to_json(run);
    EXPECT_NE(text.find("\"kind\": \"rim_entry\""), std::string::npos);
    EXPECT_NE(text.find("\"law\": \"rim\", \"rim\": \"hole\""), std::string::npos);
    const osculo::Run back = run_from_json(text);
    EXPECT_EQ(back.events, run.events);
    EXPECT_EQ(back.pieces, run.pieces);
    EXPECT_EQ(back.balls, run.balls);
    EXPECT_EQ(run_to_json(back), text);
}

TEST(RimFiles, AreRefusedWithoutTheirRim) {
    std::string text = run_to_json(simulate(scene_from_json(kScene)));
    const std::string rim = ", \"rim\": \"hole\", \"position\"";
    const auto at = text.find(rim);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, rim.size(), ", \"position\"");
    EXPECT_THROW((void)run_from_json(text), SceneError);
}

/// The curve in the rim is drawn with its bends.
TEST(RimFiles, PicturesShowTheCurve) {
    osculo::Run run = simulate(scene_from_json(kScene));
    const std::string with = to_svg(run);
    std::erase_if(run.pieces, [](const Piece& piece) { return piece.phase == Phase::rim; });
    EXPECT_GT(with.size(), to_svg(run).size() + 100);
}

}  // namespace
}  // namespace osculo::io

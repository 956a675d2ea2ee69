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

constexpr const char* kTipping = R"({
  "schema": "osculo/scene-1",
  "motion": {"law": "rolling", "friction": 0.01},
  "balls": [{"id": "a", "mass": 0.17, "radius": 0.03, "position": [-0.2, 0], "velocity": [0.4, 0.1]},
            {"id": "b", "mass": 0.17, "radius": 0.03, "position": [0.2, 0], "velocity": [-0.3, 0]}],
  "rims": [{"id": "hole", "center": [0, 0], "radius": 0.07, "law": "tipping", "restitution": 0.4}]
})";

TEST(TippingRimFiles, RunsComeBackAsTheyWere) {
    const Scene scene = scene_from_json(kTipping);
    EXPECT_EQ(scene.rims[0].law, RimLaw::tipping);
    EXPECT_EQ(scene.rims[0].restitution, 0.4);
    EXPECT_EQ(scene_from_json(scene_to_json(scene)), scene);
    Scene plain = scene;
    plain.rims[0].restitution = {};
    EXPECT_EQ(scene_to_json(plain).find("\"restitution\": 0.4"), std::string::npos);
    EXPECT_EQ(scene_from_json(scene_to_json(plain)), plain);

    const osculo::Run run = simulate(scene);
    const std::string text = run_to_json(run);
    for (const char* part : {"\"law\": \"tipping\", \"rim\": \"hole\", \"height\": 0.03",
                             "\"law\": \"flying\", \"rim\": \"hole\", \"height\": ",
                             "\"inertia\": 0.4", "\"from\": \"tipping\", \"to\": \"flying\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    const osculo::Run back = run_from_json(text);
    EXPECT_EQ(back.events, run.events);
    EXPECT_EQ(back.pieces, run.pieces);
    EXPECT_EQ(back.balls, run.balls);
    EXPECT_EQ(run_to_json(back), text);
    EXPECT_NE(to_svg(run).find("<path"), std::string::npos);
    EXPECT_NE(to_html(run).find("<html"), std::string::npos);
}

TEST(TippingRimFiles, AreRefusedWithoutTheirHeight) {
    const std::string text = run_to_json(simulate(scene_from_json(kTipping)));
    for (const char* name : {", \"height\": ", ", \"climb\": ", ", \"inertia\": "}) {
        std::string spoilt = text;
        const auto at = spoilt.find(name, spoilt.find("\"pieces\""));
        ASSERT_NE(at, std::string::npos);
        spoilt.erase(at, spoilt.find(',', at + 1) - at);
        EXPECT_THROW((void)run_from_json(spoilt), SceneError) << name;
    }
    // On the table, a ball has none.
    std::string spoilt = text;
    const std::string rolling = "\"law\": \"rolling\"";
    const auto at = spoilt.find(rolling, spoilt.find("\"pieces\""));
    spoilt.insert(at + rolling.size(), ", \"height\": 1");
    EXPECT_THROW((void)run_from_json(spoilt), SceneError);
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

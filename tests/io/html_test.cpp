#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

namespace osculo::io {
namespace {

using nlohmann::json;

constexpr std::string_view kDataBegins = "<script type=\"application/json\" id=\"run\">";

/// What the page's script reads.
json data_of(const std::string& page) {
    const std::size_t from = page.find(kDataBegins) + kDataBegins.size();
    return json::parse(page.substr(from, page.find("</script>", from) - from));
}

// What the page's script does to find a ball.
Point shown(const json& data, std::size_t ball, double t) {
    const json& pieces = data["pieces"][ball];
    std::size_t at = 0;
    while (at + 1 < pieces.size() && pieces[at + 1][0] <= t) ++at;
    const auto number = [&](std::size_t i) { return pieces[at][i].get<double>(); };
    const double wait = std::min(std::max(t - number(0), 0.0), number(1) - number(0));
    return {number(2) + wait * (number(4) + wait * number(6) / 2),
            number(3) + wait * (number(5) + wait * number(7) / 2)};
}

/// Of the places that the page shows, over the run [m].
double largest_error(const Run& run, const json& data) {
    double worst = 0;
    for (int step = 0; step <= 200; ++step) {
        const double t = run.time * step / 200;
        for (std::uint32_t b = 0; b < run.balls.size(); ++b) {
            const auto state = run.at(b, t);
            if (!state) continue;
            const Point place = shown(data, b, t);
            worst = std::max({worst, std::abs(place.x - state->position.x),
                              std::abs(place.y - state->position.y)});
        }
    }
    return worst;
}

TEST(Html, ShowsEveryBallWhereItIs) {
    for (const char* name : {"break", "carom", "frictionless-break"}) {
        const osculo::Run run = simulate(presets::make(name));
        const json data = data_of(to_html(run));
        ASSERT_EQ(data["pieces"].size(), run.balls.size());
        EXPECT_EQ(data["end"].get<double>(), run.time);
        const double worst = largest_error(run, data);
        EXPECT_LT(worst, 1e-12) << name;
        ASSERT_EQ(data["events"].size(), run.events.size());
        EXPECT_EQ(data["events"].back()[0].get<double>(), run.events.back().time);
    }
}

TEST(Html, ShowsOtherPathsByQuadratics) {
    Scene scene = presets::make("carom");
    scene.motion = ResistedMotion{0.05, 0.3, 0.4, {}};
    const osculo::Run run = simulate(scene);
    const json data = data_of(to_html(run));
    ASSERT_GT(run.event_count, 3U);
    const double worst = largest_error(run, data);
    EXPECT_LT(worst, 1e-4);  // a tenth of a pixel of a table drawn 1200 pixels wide
}

TEST(Html, HasANodeForEveryBallAndSaysItsScale) {
    const osculo::Run run = simulate(presets::make("carom"));
    const std::string page = to_html(run, 800);
    for (std::size_t b = 0; b < run.balls.size(); ++b) {
        const std::string node = "<g id=\"ball-" + std::to_string(b) + "\"";
        EXPECT_NE(page.find(node), std::string::npos);
    }
    const double scale = data_of(page)["scale"];
    const std::size_t at = page.find("<small>1 m = ") + 13;
    EXPECT_NEAR(std::stod(page.substr(at)), scale, 1e-5 * scale);
    EXPECT_NE(page.find(" px in a picture of 800 px"), std::string::npos);
    // The picture is as wide as it says: 800 px for what 800 / scale metres show.
    EXPECT_NE(page.find("viewBox=\"0 0 800 "), std::string::npos);
    EXPECT_EQ(to_html(run, 800), page);
}

TEST(Html, NamesCannotBreakOut) {
    Scene scene;
    scene.balls.push_back({"</script><b>&\"'", 1, 0.5, {0, 0}, {1, 0}});
    scene.balls.push_back({"b", 1, 0.5, {3, 0}, {}});
    const std::string page = to_html(simulate(scene));
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_EQ(data_of(page)["events"][0][1], "</script><b>&\"' meets b");
}

TEST(Html, OfRunsWithNothingInThem) {
    const json empty = data_of(to_html(simulate(Scene{})));
    EXPECT_TRUE(empty["events"].empty());
    EXPECT_EQ(empty["end"], 0.0);
    osculo::Run bare = simulate(presets::make("carom"), {.record = Record::none});
    EXPECT_TRUE(data_of(to_html(bare))["pieces"][0].empty());
    bare.pieces.push_back({});
    bare.pieces[0].velocity.x = std::nan("");
    bare.time = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(data_of(to_html(bare))["pieces"][0].empty());
}

}  // namespace
}  // namespace osculo::io

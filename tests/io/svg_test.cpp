#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "random_scene.hpp"

namespace osculo::io {
namespace {

// Why the text is not well-formed XML of the kind we write, or nothing.
std::string fault_in_xml(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '&') {
            const std::string entity = text.substr(at, text.find(';', at) - at + 1);
            if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;") return "bad " + entity;
            at += entity.size();
        } else if (c == '<') {
            const std::size_t end = text.find('>', at);
            if (end == std::string::npos) return "tag without end";
            const std::string tag = text.substr(at + 1, end - at - 1);
            if (tag.find('<') != std::string::npos) return "< in " + tag;
            const std::string name = tag.substr(0, tag.find(' '));
            if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "quotes in " + tag;
            if (tag[0] == '/') {
                if (open.empty() || open.back() != tag.substr(1)) return "misplaced " + tag;
                open.pop_back();
            } else if (tag.back() != '/') {
                open.push_back(name);
            }
            at = end + 1;
        } else if (static_cast<unsigned char>(c) < 0x20 && c != '\n') {
            return "control character";
        } else {
            ++at;
        }
    }
    return open.empty() ? "" : "open " + open.back();
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

void expect_good(const std::string& svg, const std::string& name) {
    EXPECT_EQ(fault_in_xml(svg), "") << name;
    EXPECT_EQ(svg.substr(0, 5), "<svg ") << name;
    for (const char* bad : {"\"nan", "\"inf", "\"-nan", " nan", " inf", "1000000000"}) {
        EXPECT_EQ(svg.find(bad), std::string::npos) << name << bad;
    }
}

TEST(Svg, OfEveryPresetIsWellFormed) {
    for (const presets::Info& info : presets::list()) {
        const Scene scene = presets::make(info.name);
        expect_good(to_svg(scene), std::string(info.name));
        for (const Record record : {Record::none, Record::events, Record::pieces}) {
            const osculo::Run run = simulate(scene, {.record = record});
            const std::string svg = to_svg(run);
            expect_good(svg, std::string(info.name));
            EXPECT_EQ(svg, to_svg(run));
            EXPECT_LT(svg.size(), 400'000U);
        }
    }
}

TEST(Svg, OfScenesOfAnySizeIsWellFormed) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Scene scene = test::random_scene(seed);
        expect_good(to_svg(scene), std::to_string(seed));
    }
    for (const double size : {1e-60, 1e-9, 1.0, 1e9, 1e60}) {
        for (const double offset : {0.0, 1e8, 1e90}) {
            Scene scene;
            scene.balls.push_back({"a", 1, size, {offset, offset}, {size, 0}, {}});
            scene.balls.push_back({"b", 1, size, {offset + 5 * size, offset}, {}, {}});
            expect_good(to_svg(scene), std::to_string(size));
        }
    }
    expect_good(to_svg(Scene{}), "empty");
}

TEST(Svg, EscapesIds) {
    Scene scene = presets::make("pi");
    scene.balls[0].id = "<a href=\"x\">&'\x01\xff";
    const std::string svg = to_svg(simulate(scene));
    expect_good(svg, "ids");

    Scene tall = presets::make("carom");
    tall.balls[0].id = "<&>\x02";
    const std::string with_events = to_svg(simulate(tall));
    expect_good(with_events, "ids in the list of events");
    EXPECT_NE(with_events.find("&lt;&amp;&gt;\xEF\xBF\xBD meets"), std::string::npos);
}

TEST(Svg, NumbersContactsInOrder) {
    const osculo::Run run = simulate(presets::make("cradle"));
    ASSERT_EQ(run.events.size(), 4U);
    const std::string svg = to_svg(run);
    for (const char* label : {">1<", ">2<", ">3<", ">4<"}) EXPECT_EQ(count(svg, label), 1U);
    EXPECT_EQ(count(svg, ">5<"), 0U);
    const std::string without = to_svg(run, {.numbers = false});
    EXPECT_EQ(count(without, ">1<"), 0U);
    EXPECT_EQ(without.find("Numbers:"), std::string::npos);
}

TEST(Svg, ManyEventsAreThinnedOutAndSaidSo) {
    const std::string svg = to_svg(simulate(presets::make("gas")));
    EXPECT_NE(svg.find("Paths left out"), std::string::npos);
    EXPECT_NE(svg.find("the first 40 contacts"), std::string::npos);
    EXPECT_EQ(count(svg, ">41<"), 0U);
}

TEST(Svg, StaysSmallWithAMillionBalls) {
    const std::string svg = to_svg(presets::make("gas", {.balls = 1'000'000}));
    expect_good(svg, "a million");
    EXPECT_LT(svg.size(), 3'000'000U);
    EXPECT_NE(svg.find("One ball in 50 is drawn."), std::string::npos);
}

TEST(Svg, DrawsPathsInTheColoursOfTheBalls) {
    const std::string svg = to_svg(simulate(presets::make("carom")));
    EXPECT_EQ(count(svg, "<path stroke=\"#f7f4ea\""), 1U);  // white
    EXPECT_EQ(count(svg, "<path stroke=\"#d6302b\""), 1U);  // red
    EXPECT_EQ(count(svg, "stroke-dasharray"), 3U);          // three balls at the start
}

// A ball that flies off leaves the rest of the picture as it is.
TEST(Svg, EveryGameHasItsClothAndColours) {
    for (const char* name : {"break", "nine-ball", "snooker-break", "three-cushion"}) {
        const std::string svg = to_svg(presets::make(name));
        EXPECT_NE(svg.find("#1b6f4d"), std::string::npos) << name;
    }
    const std::string svg = to_svg(presets::make("snooker-break"));
    for (const char* color : {"#d6302b", "#f2c230", "#1f9d55", "#7a4a21", "#2456b8", "#f29bb2"}) {
        EXPECT_NE(svg.find(color), std::string::npos) << color;
    }
}

TEST(Svg, StaysWithTheScene) {
    Scene scene;
    scene.balls.push_back({"a", 1, 1, {0, 0}, {1, 0}, {}});
    scene.balls.push_back({"b", 1, 1, {3, 0}, {}, {}});
    scene.limits.time = 1e6;
    const osculo::Run run = simulate(scene);
    EXPECT_GT(run.balls[1].state.position.x, 9e5);
    const std::string svg = to_svg(run);
    expect_good(svg, "far");
    const std::size_t radius = svg.find("r=\"");
    ASSERT_NE(radius, std::string::npos);
    EXPECT_GT(std::stod(svg.substr(radius + 3)), 50);  // not shrunk to a dot
}

TEST(Svg, SaysItsScale) {
    // A square metre, with 2 % around it, is as wide as the drawing without its margins.
    Scene scene;
    scene.segments.push_back({"s", {0, 0}, {1, 1}, Side::both});
    EXPECT_NE(to_svg(scene, {1200}).find("(1 m is 1107.69 px)"), std::string::npos);
    EXPECT_NE(to_svg(scene, {600}).find("(1 m is 553.846 px)"), std::string::npos);
}

TEST(Svg, WidthIsAsAsked) {
    const Scene scene = presets::make("break");
    EXPECT_NE(to_svg(scene).find("width=\"1200\""), std::string::npos);
    EXPECT_NE(to_svg(scene, {.width = 777.5}).find("width=\"777.5\""), std::string::npos);
}

}  // namespace
}  // namespace osculo::io

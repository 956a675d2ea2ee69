#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "osculo/presets.hpp"

namespace osculo::presets {
namespace {

nlohmann::json reference() {
    std::ifstream file(OSCULO_REFERENCE_DIR "/pool_7ft.json");
    return nlohmann::json::parse(file);
}

Point point(const nlohmann::json& value) {
    return {value[0].get<double>(), value[1].get<double>()};
}

// A mirrored number may be rounded once more than the original.
bool equal_to_1_ulp(double a, double b) {
    const double infinity = std::numeric_limits<double>::infinity();
    return a == b || std::nextafter(a, b > a ? infinity : -infinity) == b;
}

bool same(Point a, Point b) {
    return equal_to_1_ulp(a.x, b.x) && equal_to_1_ulp(a.y, b.y);
}

Scene table() {
    Scene scene;
    add_table(scene, "pool-7ft");
    return scene;
}

Ball pool_ball(Point position) {
    return {"cue", 0.170097, 0.028575, position, {}, {}};
}

TEST(Pool7ft, HasTheSegmentsOfTheReference) {
    const auto segments = reference()["segments"];
    const Scene scene = table();
    ASSERT_EQ(scene.segments.size(), segments.size());
    for (const auto& expected : segments) {
        const Point p1 = point(expected["p1"]);
        const Point p2 = point(expected["p2"]);
        const auto found = std::ranges::find_if(scene.segments, [&](const Segment& s) {
            return (same(s.from, p1) && same(s.to, p2)) || (same(s.from, p2) && same(s.to, p1));
        });
        ASSERT_NE(found, scene.segments.end()) << expected;
        EXPECT_EQ(found->side, Side::left);
        // The left of from -> to is the side that the reference stops balls on.
        Point normal = point(expected["normal"]);
        if (!expected["stops_along_normal"].get<bool>()) normal = {-normal.x, -normal.y};
        const Point left{found->from.y - found->to.y, found->to.x - found->from.x};
        EXPECT_GT(left.x * normal.x + left.y * normal.y, 0) << found->id;
    }
}

TEST(Pool7ft, HasTheArcsOfTheReference) {
    const auto arcs = reference()["arcs"];
    const Scene scene = table();
    ASSERT_EQ(scene.arcs.size(), arcs.size());
    for (const auto& expected : arcs) {
        EXPECT_TRUE(std::ranges::any_of(scene.arcs, [&](const Arc& arc) {
            return same(arc.center, point(expected["center"])) &&
                   arc.radius == expected["radius"].get<double>();
        })) << expected;
    }
}

TEST(Pool7ft, HasThePocketsOfTheReference) {
    const auto pockets = reference()["pockets"];
    const Scene scene = table();
    ASSERT_EQ(scene.rims.size(), pockets.size());
    for (const auto& expected : pockets) {
        EXPECT_TRUE(std::ranges::any_of(scene.rims, [&](const Rim& rim) {
            return same(rim.center, point(expected["center"])) &&
                   rim.radius == expected["radius"].get<double>();
        })) << expected;
    }
}

// Each arc begins where one segment ends, and ends where another begins.
TEST(Pool7ft, ArcsJoinSegments) {
    const Scene scene = table();
    for (const Arc& arc : scene.arcs) {
        for (const double angle : {arc.from_angle, arc.to_angle}) {
            const Point end{arc.center.x + arc.radius * std::cos(angle),
                            arc.center.y + arc.radius * std::sin(angle)};
            double nearest = 1;
            for (const Segment& s : scene.segments) {
                nearest = std::min({nearest, std::hypot(s.from.x - end.x, s.from.y - end.y),
                                    std::hypot(s.to.x - end.x, s.to.y - end.y)});
            }
            EXPECT_LT(nearest, 1e-15) << arc.id;
        }
        EXPECT_GT(arc.to_angle, arc.from_angle) << arc.id;
        EXPECT_LT(arc.to_angle, arc.from_angle + 1.5) << arc.id;
    }
}

TEST(Pool7ft, IsClosedForItsBalls) {
    Scene scene = table();
    EXPECT_TRUE(scene.closed);
    scene.balls.push_back(pool_ball({0.4953, 0.9906}));
    EXPECT_NO_THROW(validate(scene));

    scene.balls[0].position = {0.4953, -0.2};  // behind the bottom cushion
    EXPECT_THROW(validate(scene), SceneError);
}

TEST(Pool7ft, IsOpenWithoutAnyOneCushionOrPocket) {
    Scene whole = table();
    whole.balls.push_back(pool_ball({0.4953, 0.9906}));
    for (std::size_t i = 0; i < whole.rims.size(); ++i) {
        Scene scene = whole;
        scene.rims.erase(scene.rims.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_THROW(validate(scene), SceneError) << whole.rims[i].id;
    }
    for (std::size_t i = 0; i < whole.segments.size(); ++i) {
        const Segment& segment = whole.segments[i];
        const double length =
            std::hypot(segment.to.x - segment.from.x, segment.to.y - segment.from.y);
        if (length < 0.1) continue;  // a jaw: too short for a ball to pass
        Scene scene = whole;
        scene.segments.erase(scene.segments.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_THROW(validate(scene), SceneError) << segment.id;
    }
}

TEST(Tables, UnknownNamesAreRefused) {
    Scene scene;
    try {
        add_table(scene, "pool-7tf");
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(),
                     "table: must be \"pool-7ft\", \"pool-8ft\", \"pool-9ft\", \"snooker-12ft\" or "
                     "\"carom-10ft\", did you mean pool-7ft?, but it is \"pool-7tf\"");
    }
}

TEST(Tables, CaromIsClosed) {
    Scene scene;
    add_table(scene, "carom-10ft");
    scene.balls.push_back(pool_ball({0.7, 1.4}));
    EXPECT_NO_THROW(validate(scene));
    scene.balls[0].position = {1.6, 1.4};
    EXPECT_THROW(validate(scene), SceneError);
    EXPECT_EQ(scene.segments.size(), 4U);
    EXPECT_TRUE(scene.rims.empty());
}

}  // namespace
}  // namespace osculo::presets

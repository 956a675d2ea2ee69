#include "outline.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace osculo::facade {
namespace {

bool closed_around(const Scene& scene, const Point& p, double radius) {
    Outline outline(scene, radius);
    const bool once = outline.encloses(p);
    EXPECT_EQ(outline.encloses(p), once) << "the second answer differs";
    return once;
}

TEST(Outline, ABoxEnclosesWhatIsInIt) {
    Scene scene;
    test::add_box(scene, 4, 3);
    EXPECT_TRUE(closed_around(scene, {2, 1}, 0.1));
    EXPECT_FALSE(closed_around(scene, {5, 1}, 0.1));
    EXPECT_FALSE(closed_around(scene, {2, -1}, 0.1));
}

TEST(Outline, AGapIsClosedForBallsThatAreTooLargeForIt) {
    Scene scene;
    test::add_box(scene, 4, 3);
    scene.segments[0].to.x = 3.8;  // leaves 0.2
    EXPECT_TRUE(closed_around(scene, {2, 1}, 0.1001));
    EXPECT_FALSE(closed_around(scene, {2, 1}, 0.0999));
}

TEST(Outline, ARimPlugsAGapForTheCentre) {
    Scene scene;
    test::add_box(scene, 4, 3);
    scene.segments[0].from.x = 0.5;
    scene.segments[3].to.y = 0.5;  // the corner at the origin is open by 0.7
    EXPECT_FALSE(closed_around(scene, {2, 1}, 0.1));
    scene.rims = {{"pocket", {0, 0}, 0.41}};  // leaves 0.09 on both sides
    EXPECT_TRUE(closed_around(scene, {2, 1}, 0.1));
    scene.rims[0].radius = 0.39;
    EXPECT_FALSE(closed_around(scene, {2, 1}, 0.1));
}

TEST(Outline, CirclesAndArcsEnclose) {
    Scene scene;
    scene.arcs = {{"arena", {1, 1}, 2}};
    EXPECT_TRUE(closed_around(scene, {1.5, 0}, 0.1));
    EXPECT_TRUE(closed_around(scene, {1, 1}, 0.1));
    EXPECT_FALSE(closed_around(scene, {4, 0}, 0.1));
    // Two half circles joined by segments: a stadium.
    scene.arcs = {{"right", {2, 0}, 1, -std::numbers::pi / 2, std::numbers::pi / 2},
                  {"left", {-2, 0}, 1, std::numbers::pi / 2, 3 * std::numbers::pi / 2}};
    EXPECT_FALSE(closed_around(scene, {0, 0}, 0.1));
    scene.segments = {{"top", {2, 1}, {-2, 1}}, {"bottom", {-2, -1}, {2, -1}}};
    EXPECT_TRUE(closed_around(scene, {0, 0}, 0.1));
    EXPECT_TRUE(closed_around(scene, {2.8, 0}, 0.1));
    EXPECT_FALSE(closed_around(scene, {3.2, 0}, 0.1));
    scene.arcs[0].to_angle -= 0.3;  // opens 0.3 rad
    EXPECT_FALSE(closed_around(scene, {0, 0}, 0.1));
    EXPECT_TRUE(closed_around(scene, {0, 0}, 0.16));
}

TEST(Outline, ChambersAreToldApart) {
    Scene scene;
    test::add_box(scene, 4, 3);
    scene.segments.push_back({"middle", {2, 0}, {2, 3}});
    scene.segments.erase(scene.segments.begin() + 1);  // the right wall
    EXPECT_TRUE(closed_around(scene, {1, 1}, 0.1));
    EXPECT_FALSE(closed_around(scene, {3, 1}, 0.1));
}

TEST(Outline, ScalesWithTheScene) {
    for (const double scale : {1e-30, 1e-6, 1e8, 1e40}) {
        Scene scene;
        test::add_box(scene, 4 * scale, 3 * scale);
        EXPECT_TRUE(closed_around(scene, {2 * scale, scale}, 0.1 * scale)) << scale;
        EXPECT_FALSE(closed_around(scene, {5 * scale, scale}, 0.1 * scale)) << scale;
    }
}

}  // namespace
}  // namespace osculo::facade

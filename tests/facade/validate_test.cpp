#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "osculo/scene.hpp"
#include "support/scenes.hpp"

namespace osculo {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A valid scene with one of everything.
Scene valid_scene() {
    Scene scene;
    test::add_box(scene, 10, 10);
    scene.balls = {test::ball("a", {2, 2}, {1, 0}), test::ball("b", {5, 5})};
    scene.arcs = {{"post", {8, 8}, 0.5}};
    scene.rims = {{"hole", {8, 2}, 0.6}};
    scene.closed = true;
    return scene;
}

struct Case {
    const char* path;
    const char* rule;
    std::function<void(Scene&)> spoil;
};

void expect_error(const Case& c) {
    Scene scene = valid_scene();
    c.spoil(scene);
    try {
        validate(scene);
        FAIL() << "accepted: " << c.path << " " << c.rule;
    } catch (const SceneError& error) {
        EXPECT_EQ(error.path(), c.path);
        EXPECT_NE(error.rule().find(c.rule), std::string::npos) << error.what();
        EXPECT_FALSE(error.value().empty()) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

// Found by a fuzzer: at a gravity of 1e-65 m/s^2 a ball went through a cushion.
TEST(Validate, ForcesMustBeMoreThanNothing) {
    Scene scene;
    scene.balls.push_back({"a", 1, 0.03, {0, 0}, {8, 0}, {}});
    const auto message = [&scene] {
        try {
            validate(scene);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    scene.motion = RollingMotion{0.01};
    scene.gravity = 1e-60;
    EXPECT_TRUE(message().starts_with(
        "motion: must slow balls down by nothing, or by at least 1e-50 v^2 / radius at the "
        "largest speed that they can reach, 8 m/s, but it is "))
        << message();
    scene.gravity = 1e-40;
    EXPECT_EQ(message(), "");
    scene.gravity = 0;
    EXPECT_EQ(message(), "");
    scene.gravity = 9.81;
    scene.balls[0].velocity = {1e30, 0};
    EXPECT_NE(message(), "");
    scene.balls[0].velocity = {0, 0};
    scene.gravity = 1e-300;
    EXPECT_EQ(message(), "");  // nothing moves
    scene.balls[0].velocity = {1e-120, 0};
    EXPECT_TRUE(
        message().starts_with("motion: must slow balls down by nothing, or by 1e-80 to 1e80"))
        << message();
    scene.gravity = 1e100;
    EXPECT_TRUE(message().ends_with(", but it is 1e+98 m/s^2")) << message();
    scene.gravity = 1e-60;
    EXPECT_EQ(message(), "");
    scene.balls[0].velocity = {0, 0};
    scene.motion = ClothMotion{};
    scene.balls[0].spin = {0, 0, 5};
    EXPECT_NE(message(), "");
}

TEST(Validate, AcceptsAValidScene) {
    EXPECT_NO_THROW(validate(valid_scene()));
}

TEST(Validate, AcceptsAnEmptyScene) {
    EXPECT_NO_THROW(validate(Scene{}));
}

TEST(Validate, NamesFieldRuleAndValue) {
    const Case cases[] = {
        {"balls[1].id", "unique", [](Scene& s) { s.balls[1].id = "a"; }},
        {"segments[0].id", "unique, and balls[0] has it", [](Scene& s) { s.segments[0].id = "a"; }},
        {"balls[0].id", "empty", [](Scene& s) { s.balls[0].id = ""; }},
        {"impacts.rest_speed", "finite", [](Scene& s) { s.impacts.rest_speed = kInfinity; }},
        {"impacts.rest_speed", "not negative", [](Scene& s) { s.impacts.rest_speed = -1e-9; }},
        {"impacts.rest_speed", "symmetric",
         [](Scene& s) {
             s.impacts.rest_speed = 1e-6;
             s.impacts.simultaneous = Simultaneous::sequential;
         }},
        {"balls[0].mass", "> 0", [](Scene& s) { s.balls[0].mass = -1; }},
        {"balls[0].mass", "> 0", [](Scene& s) { s.balls[0].mass = kNan; }},
        {"balls[0].mass", "1e100", [](Scene& s) { s.balls[0].mass = 1e300; }},
        {"balls[1].radius", "> 0", [](Scene& s) { s.balls[1].radius = 0; }},
        {"balls[1].radius", "1e-100", [](Scene& s) { s.balls[1].radius = 1e-300; }},
        {"balls[0].position", "at most", [](Scene& s) { s.balls[0].position.x = kNan; }},
        {"balls[0].velocity", "at most", [](Scene& s) { s.balls[0].velocity.y = kInfinity; }},
        {"balls[0].spin", "at most", [](Scene& s) { s.balls[0].spin[2] = kNan; }},
        {"balls[0].velocity", "at most 1e302 J",
         [](Scene& s) {
             s.balls[0].mass = 1e12;
             s.balls[0].velocity = {1e148, 0};
         }},
        {"balls[0].spin", "at most 1e302 J",
         [](Scene& s) {
             s.balls[0].mass = 1e12;
             s.balls[0].radius = 10;
             s.balls[0].spin = {1e145, 0, 0};
         }},
        {"segments[1].to", "differ", [](Scene& s) { s.segments[1].to = s.segments[1].from; }},
        {"segments[1].to", "1e12 times the smallest ball's radius",
         [](Scene& s) {
             s.segments[1].to = {s.segments[1].from.x, 1e13};
         }},
        {"segments[1].from", "at most", [](Scene& s) { s.segments[1].from.x = -kInfinity; }},
        {"arcs[0].radius", "> 0", [](Scene& s) { s.arcs[0].radius = -2; }},
        {"arcs[0].to_angle", "greater", [](Scene& s) { s.arcs[0].to_angle = 0; }},
        {"arcs[0].to_angle", "full turn", [](Scene& s) { s.arcs[0].to_angle = 7; }},
        {"arcs[0].from_angle", "from -100", [](Scene& s) { s.arcs[0].from_angle = kNan; }},
        {"rims[0].radius", "> 0", [](Scene& s) { s.rims[0].radius = 0; }},
        {"impacts.ball_ball.restitution", "from 0 to 1",
         [](Scene& s) { s.impacts.ball_ball.restitution = 1.5; }},
        {"impacts.ball_cushion.restitution", "from 0 to 1",
         [](Scene& s) { s.impacts.ball_cushion.restitution = kNan; }},
        {"limits.time", "> 0", [](Scene& s) { s.limits.time = 0; }},
        {"limits.time", "finite", [](Scene& s) { s.limits.time = kInfinity; }},
        {"limits.events", "> 0", [](Scene& s) { s.limits.events = 0; }},
        {"gravity", "finite", [](Scene& s) { s.gravity = kNan; }},
        {"balls[1].position", "overlap balls[0]",
         [](Scene& s) {
             s.balls[1].position = {2.9999, 2};
         }},
        {"balls[0].position", "overlap segments[3]",
         [](Scene& s) { s.balls[0].position.x = 0.4999; }},
        {"balls[0].position", "overlap arcs[0]",
         [](Scene& s) {
             s.balls[0].position = {7.1, 8};
         }},
        {"balls[0].radius", "must be < that of arcs[0]",
         [](Scene& s) {
             s.balls[0].position = s.arcs[0].center;
             s.balls[0].radius = s.arcs[0].radius;
         }},
        {"balls[0].position", "inside rims[0]",
         [](Scene& s) {
             s.balls[0].position = {7.5, 2};
         }},
        {"balls[1].position", "closed outline",
         [](Scene& s) {
             s.balls[1].position = {50, 5};
         }},
        {"balls[0].position", "closed outline", [](Scene& s) { s.segments[2].from.x = 8.5; }},
    };
    for (const Case& c : cases) expect_error(c);
}

TEST(Validate, NamesTheRuleThatACushionOnClothBreaks) {
    const auto broken = [](const char* path, const char* rule, auto breaks) {
        return Case{path, rule, [breaks](Scene& s) {
                        s.motion = ClothMotion{};
                        s.impacts.ball_cushion = {CushionLaw::stronge, 0.85, 0.2, 0.6};
                        validate(s);
                        breaks(s.impacts.ball_cushion);
                    }};
    };
    const Case cases[] = {
        broken("impacts.ball_cushion.friction", ">= 0",
               [](CushionImpact& c) { c.friction = -0.1; }),
        broken("impacts.ball_cushion.height", "below every ball's top",
               [](CushionImpact& c) { c.height = 1; }),
        broken("impacts.ball_cushion.cloth_friction", ">= 0",
               [](CushionImpact& c) { c.cloth_friction = kNan; }),
        broken("impacts.ball_cushion.frequency_ratio", "below 2",
               [](CushionImpact& c) { c.frequency_ratio = 2; }),
    };
    for (const Case& c : cases) expect_error(c);
}

TEST(Validate, AllowsOverlapsOfTypedData) {
    Scene scene = valid_scene();
    scene.balls[1].position = {3 - 0.9e-7 * 0.5, 2};
    EXPECT_NO_THROW(validate(scene));
    scene.balls[1].position = {3 - 1.1e-7 * 0.5, 2};
    EXPECT_THROW(validate(scene), SceneError);
}

TEST(Validate, ABallBehindAOneSidedSegmentDoesNotTouchIt) {
    Scene scene;
    scene.segments = {{"wall", {0, 0}, {0, 1}, Side::left}};  // stops what is at x < 0
    scene.balls = {test::ball("a", {0.1, 0.5}, {}, 0.2)};
    EXPECT_NO_THROW(validate(scene));
    scene.segments[0].side = Side::both;
    EXPECT_THROW(validate(scene), SceneError);
}

TEST(Validate, AllowsAFullTurnWrittenInAnyWay) {
    Scene scene = valid_scene();
    scene.arcs[0].from_angle = -1;
    scene.arcs[0].to_angle = -1 + 2 * std::numbers::pi;
    EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace osculo

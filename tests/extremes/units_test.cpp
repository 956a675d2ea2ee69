#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/extreme_scenes.hpp"
#include "support/random.hpp"

// Nothing depends on the units that a scene is given in: with powers of two for metre, second and
// kilogram (powers of four, for the symmetric law takes the root of masses) every run is the same
// to the last bit, under every law of motion and impact.
namespace osculo::support {
namespace {

/// 2^length m, 2^time s, 2^mass kg.
struct Units {
    int length, time, mass;
};

Scene in_units(Scene scene, const Units& unit) {
    const auto two_to = [](int exponent) { return std::ldexp(1.0, exponent); };
    const double l = two_to(unit.length);
    const double t = two_to(unit.time);
    const double m = two_to(unit.mass);
    const double v = two_to(unit.length - unit.time);
    const double a = two_to(unit.length - 2 * unit.time);
    const auto place = [l](Point& p) { p = {l * p.x, l * p.y}; };
    for (Ball& ball : scene.balls) {
        place(ball.position);
        ball.velocity = {v * ball.velocity.x, v * ball.velocity.y};
        ball.radius *= l;
        ball.mass *= m;
        for (double& spin : ball.spin) spin /= t;
    }
    for (Segment& segment : scene.segments) {
        place(segment.from);
        place(segment.to);
    }
    for (Arc& arc : scene.arcs) {
        place(arc.center);
        arc.radius *= l;
    }
    for (Rim& rim : scene.rims) {
        place(rim.center);
        rim.radius *= l;
    }
    scene.gravity *= a;
    scene.limits.time *= t;
    scene.impacts.contact_time *= t;
    scene.impacts.ball_cushion.height *= l;
    scene.impacts.ball_ball.friction[2] /= v;
    if (auto* drag = std::get_if<ResistedMotion>(&scene.motion)) {
        drag->constant *= a;
        drag->linear /= t;
        drag->quadratic /= l;
    }
    return scene;
}

/// Six balls between walls, around a post, with a hole.
Scene random_scene(Random& random, const MotionLaw& motion) {
    Scene scene;
    scene.motion = motion;
    scene.segments = {{"bottom", {-3, -3}, {3, -3}, Side::left},
                      {"right", {3, -3}, {3, 3}, Side::left},
                      {"top", {3, 3}, {-3, 3}, Side::left},
                      {"left", {-3, 3}, {-3, -3}, Side::left},
                      {"across", {-0.5, -2.5}, {0.5, -2}, Side::both}};
    scene.arcs = {{"post", {0, 0}, 0.4}};
    scene.rims = {{"hole", {2.5, 2.5}, 0.4}};
    for (int k = 0; k < 6; ++k) {
        Ball ball =
            disk(std::to_string(k),
                 {-2 + 2 * (k % 3) + 0.4 * random.signed_unit<double>(), k < 3 ? 1.2 : -1.2},
                 {3 * random.signed_unit<double>(), 3 * random.signed_unit<double>()},
                 1 + random.below(3), 0.2 + 0.05 * random.below(3));
        if (k == 5) ball.velocity = {0, 0};
        scene.balls.push_back(ball);
    }
    Impacts& impacts = scene.impacts;
    impacts.ball_ball.restitution = 1 - 0.25 * random.below(3);
    impacts.ball_cushion.restitution = 1 - 0.25 * random.below(3);
    impacts.simultaneous = random.coin() ? Simultaneous::symmetric : Simultaneous::sequential;
    const bool cloth = std::holds_alternative<ClothMotion>(motion);
    if (random.coin()) {
        impacts.ball_ball.law = BallBallLaw::frictional;
        impacts.ball_ball.friction = {0.01, 0.1, 1};
        impacts.ball_cushion.friction = 0.2;
        impacts.ball_cushion.law = cloth ? CushionLaw::han_2005 : CushionLaw::frictional;
        if (cloth) impacts.ball_cushion.height = 0.25;
        for (Ball& ball : scene.balls) {
            ball.spin = {cloth ? 5 * random.signed_unit<double>() : 0.0, 0,
                         5 * random.signed_unit<double>()};
        }
    }
    scene.limits = {20, 100};
    return scene;
}

void expect_the_same(const Scene& scene, const Units& unit, const std::string& where) {
    const Run usual = simulate(scene, {.record = Record::events});
    const Run other = simulate(in_units(scene, unit), {.record = Record::events});
    ASSERT_EQ(usual.status, other.status) << where;
    ASSERT_EQ(usual.event_count, other.event_count) << where;
    EXPECT_GE(usual.event_count, 3U) << where;
    // The final states depend on every event.
    const double l = std::ldexp(1.0, unit.length);
    const double t = std::ldexp(1.0, unit.time);
    EXPECT_EQ(usual.time * t, other.time) << where;
    for (std::size_t k = 0; k < usual.balls.size(); ++k) {
        const BallState& here = usual.balls[k].state;
        const BallState& there = other.balls[k].state;
        EXPECT_EQ(here.position.x * l, there.position.x) << where;
        EXPECT_EQ(here.position.y * l, there.position.y) << where;
        EXPECT_EQ(here.velocity.x * (l / t), there.velocity.x) << where;
        EXPECT_EQ(here.velocity.y * (l / t), there.velocity.y) << where;
        EXPECT_EQ(here.spin[2] / t, there.spin[2]) << where;
    }
}

/// Decelerations and what friction falls with would be refused.
bool beyond_forces(const Units& unit) {
    return std::abs(unit.time) > 300;
}

/// No number that says how drag slows balls may be above 1e30.
bool covers(const MotionLaw& law, const Units& unit) {
    const int largest =
        std::max({unit.length - 2 * unit.time, unit.length - unit.time, -unit.time, -unit.length});
    if (std::holds_alternative<ResistedMotion>(law) && largest > 90) return false;
    return !beyond_forces(unit) || std::holds_alternative<UniformMotion>(law);
}

TEST(Units, ChangeNoBit) {
    const std::pair<const char*, MotionLaw> laws[] = {
        {"uniform", UniformMotion{}},
        {"rolling", RollingMotion{0.02}},
        {"cloth", ClothMotion{}},
        {"drag", ResistedMotion{0.05, 0.1, 0.05, {}}},
        {"linear drag", ResistedMotion{0, 0.2, 0, {}}},
        {"quadratic drag", ResistedMotion{0, 0, 0.2, {}}}};
    const Units units[] = {{3, -2, 4},    {-20, 10, 0},   {60, 0, -20},  {-90, 0, 60},
                           {0, -90, 0},   {-50, -120, 2}, {200, 130, 8}, {-90, 13, 100},
                           {-80, -40, 0}, {40, -20, 0},   {0, 900, 0},   {2, -480, 0}};
    for (const auto& [name, law] : laws) {
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            Random random(seed);
            const Scene scene = random_scene(random, law);
            for (const Units& unit : units) {
                if (!covers(law, unit)) continue;
                Scene here = scene;
                if (unit.time > 13) here.impacts.contact_time = 0;  // at most 1 s
                if (beyond_forces(unit)) here.impacts.ball_ball.friction = {0.1, 0, 0};
                expect_the_same(here, unit,
                                std::string(name) + ", seed " + std::to_string(seed) + ", 2^" +
                                    std::to_string(unit.length) + " m, 2^" +
                                    std::to_string(unit.time) + " s");
            }
        }
    }
}

}  // namespace
}  // namespace osculo::support

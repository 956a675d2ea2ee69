#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "presets/pocketed_table.hpp"

namespace osculo::presets {
namespace {

constexpr double kInch = 0.0254;
constexpr double kDegree = std::numbers::pi / 180;

struct Stated {
    const char* name;
    double width, length;
    double corner_mouth, side_mouth;
    double corner_cut, side_cut;  // angle between the nose line and the line of the jaw [degrees]
    double ball_radius;
};

constexpr Stated kPool[]{
    {"pool-8ft", 46 * kInch, 92 * kInch, 4.5625 * kInch, 5.0625 * kInch, 142, 104, kPoolBallRadius},
    {"pool-9ft", 50 * kInch, 100 * kInch, 4.5625 * kInch, 5.0625 * kInch, 142, 104,
     kPoolBallRadius},
};
constexpr Stated kSnooker{"snooker-12ft", 1.778, 3.569, 0.083, 0.075, 135, 90, kSnookerBallRadius};

std::vector<Stated> all() {
    return {kPool[0], kPool[1], kSnooker};
}

Scene table(const Stated& stated) {
    Scene scene;
    add_table(scene, stated.name);
    return scene;
}

Ball ball_of(const Stated& stated, Point position, Point velocity = {}) {
    return {"ball", 0.17, stated.ball_radius, position, velocity, {}};
}

const Segment& segment(const Scene& scene, const std::string& id) {
    return *std::ranges::find(scene.segments, id, &Segment::id);
}

const Arc& arc(const Scene& scene, const std::string& id) {
    return *std::ranges::find(scene.arcs, id, &Arc::id);
}

double distance(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

// Where the lines through two segments meet.
Point crossing(const Segment& s, const Segment& t) {
    const Point u{s.to.x - s.from.x, s.to.y - s.from.y};
    const Point v{t.to.x - t.from.x, t.to.y - t.from.y};
    const double along =
        ((t.from.x - s.from.x) * v.y - (t.from.y - s.from.y) * v.x) / (u.x * v.y - u.y * v.x);
    return {s.from.x + along * u.x, s.from.y + along * u.y};
}

// Angle between a cushion and its jaw, inside the rubber [degrees].
double cut_angle(const Segment& rail, const Segment& jaw) {
    const Point u{rail.to.x - rail.from.x, rail.to.y - rail.from.y};
    const Point v{jaw.to.x - jaw.from.x, jaw.to.y - jaw.from.y};
    return 180 - std::acos((u.x * v.x + u.y * v.y) / std::hypot(u.x, u.y) / std::hypot(v.x, v.y)) /
                     kDegree;
}

TEST(PocketedTables, HaveTheBedThatIsStated) {
    for (const Stated& stated : all()) {
        const Scene scene = table(stated);
        EXPECT_EQ(segment(scene, "bottom").from.y, 0);
        EXPECT_EQ(segment(scene, "left-lower").from.x, 0);
        EXPECT_DOUBLE_EQ(segment(scene, "top").from.y, stated.length) << stated.name;
        EXPECT_DOUBLE_EQ(segment(scene, "right-lower").from.x, stated.width) << stated.name;
    }
}

TEST(PocketedTables, MouthsAndCutAnglesAreAsStated) {
    for (const Stated& stated : kPool) {
        const Scene scene = table(stated);
        const Segment& bottom = segment(scene, "bottom");
        const Segment& left = segment(scene, "left-lower");
        const Segment& corner_jaw = segment(scene, "bottom-jaw-1");
        EXPECT_NEAR(cut_angle(bottom, corner_jaw), stated.corner_cut, 1e-9);
        EXPECT_NEAR(distance(crossing(bottom, corner_jaw),
                             crossing(left, segment(scene, "left-lower-jaw-2"))),
                    stated.corner_mouth, 1e-12);
        const Segment& side_jaw = segment(scene, "left-lower-jaw-1");
        EXPECT_NEAR(cut_angle(left, side_jaw), stated.side_cut, 1e-9);
        EXPECT_NEAR(
            distance(crossing(left, side_jaw),
                     crossing(segment(scene, "left-upper"), segment(scene, "left-upper-jaw-2"))),
            stated.side_mouth, 1e-12);
    }
    // Snooker: parallel corner jaws that far apart, and side noses that end at the cushion's back.
    const Scene scene = table(kSnooker);
    const Segment& jaw = segment(scene, "bottom-jaw-1");
    EXPECT_NEAR(cut_angle(segment(scene, "bottom"), jaw), 135, 1e-9);
    EXPECT_NEAR(std::sqrt(2.0) * std::abs(jaw.from.x - jaw.from.y), kSnooker.corner_mouth, 1e-12);
    const Arc& nose = arc(scene, "left-lower-nose-1");
    EXPECT_NEAR(nose.center.x + nose.radius * std::cos(nose.to_angle), -1.55 * kInch, 1e-12);
    EXPECT_NEAR(nose.center.y, (kSnooker.length - kSnooker.side_mouth) / 2 - nose.radius, 1e-12);
    EXPECT_EQ(scene.segments.size(), 14U);
}

// The shelf is from the middle of the mouth to the edge of the hole.
TEST(PocketedTables, ShelvesAreAsStated) {
    for (const Stated& stated : kPool) {
        const Scene scene = table(stated);
        const Rim& corner = scene.rims[0];
        const double middle = stated.corner_mouth / std::sqrt(2.0) / 2;
        EXPECT_NEAR(distance(corner.center, {middle, middle}) - corner.radius, 1.625 * kInch,
                    1e-12);
        const Rim& side = scene.rims[5];
        EXPECT_NEAR(-side.center.x - side.radius, 0.1875 * kInch, 1e-12);
        EXPECT_DOUBLE_EQ(side.center.y, stated.length / 2);
    }
}

// The measured table has the same construction: its parameters give its numbers.
TEST(PocketedTables, ConstructionGivesTheMeasuredTable) {
    Scene built;
    add_pocketed_table(built, cut_pockets(kPool7ft, 0.0508,
                                          {.mouth = 0.118,
                                           .turn = 39.7 * kDegree,
                                           .nose_radius = 0.02095,
                                           .shelf = 0.118 / 2 + 0.0417 - 0.062,
                                           .pocket_radius = 0.062},
                                          {.mouth = 0.137,
                                           .turn = 82.86 * kDegree,
                                           .nose_radius = 0.00795,
                                           .shelf = 0.0685 - 0.0645,
                                           .pocket_radius = 0.0645}));
    Scene measured;
    add_table(measured, "pool-7ft");
    ASSERT_EQ(built.segments.size(), measured.segments.size());
    for (std::size_t i = 0; i < built.segments.size(); ++i) {
        EXPECT_EQ(built.segments[i].id, measured.segments[i].id);
        // Its side jaws end 0.05 mm beside the tangent of their arcs.
        const bool is_side = std::abs(measured.segments[i].from.y - 0.9906) < 0.07;
        const double tolerance = is_side ? 5e-5 : 1e-14;
        EXPECT_LT(distance(built.segments[i].from, measured.segments[i].from), tolerance);
        EXPECT_LT(distance(built.segments[i].to, measured.segments[i].to), tolerance);
    }
    for (std::size_t i = 0; i < built.arcs.size(); ++i) {
        EXPECT_LT(distance(built.arcs[i].center, measured.arcs[i].center), 1e-14);
        EXPECT_NEAR(built.arcs[i].from_angle, measured.arcs[i].from_angle, 1e-15);
        EXPECT_NEAR(built.arcs[i].to_angle, measured.arcs[i].to_angle, 1e-15);
    }
    for (std::size_t i = 0; i < built.rims.size(); ++i) {
        EXPECT_LT(distance(built.rims[i].center, measured.rims[i].center), 1e-14);
        EXPECT_EQ(built.rims[i].radius, measured.rims[i].radius);
    }
}

TEST(PocketedTables, AreMirrorImagesOfThemselves) {
    for (const Stated& stated : all()) {
        const Scene scene = table(stated);
        const auto has = [&](Point from, Point to) {
            return std::ranges::any_of(scene.segments, [&](const Segment& s) {
                return distance(s.from, from) + distance(s.to, to) < 4e-15;
            });
        };
        for (const Segment& s : scene.segments) {
            // A mirrored cushion runs the other way, so that the bed stays on its left.
            EXPECT_TRUE(has({stated.width - s.to.x, s.to.y}, {stated.width - s.from.x, s.from.y}))
                << s.id;
            EXPECT_TRUE(has({s.to.x, stated.length - s.to.y}, {s.from.x, stated.length - s.from.y}))
                << s.id;
        }
    }
}

// Tangent arcs: each begins where one segment ends, and the cushion bends there without a corner.
TEST(PocketedTables, ArcsJoinSegmentsSmoothly) {
    for (const Stated& stated : all()) {
        const Scene scene = table(stated);
        for (const Arc& nose : scene.arcs) {
            int joined = 0;
            for (const double angle : {nose.from_angle, nose.to_angle}) {
                const Point out{std::cos(angle), std::sin(angle)};
                const Point end{nose.center.x + nose.radius * out.x,
                                nose.center.y + nose.radius * out.y};
                for (const Segment& s : scene.segments) {
                    if (std::min(distance(s.from, end), distance(s.to, end)) > 2e-15) continue;
                    const Point along{s.to.x - s.from.x, s.to.y - s.from.y};
                    EXPECT_LT(std::abs(along.x * out.x + along.y * out.y),
                              1e-13 * distance(s.from, s.to) + 2e-15)
                        << nose.id << ' ' << s.id;
                    ++joined;
                }
            }
            const bool rounded_to_the_back =
                stated.length == kSnooker.length && std::abs(nose.center.y - 1.7845) < 0.2;
            EXPECT_EQ(joined, rounded_to_the_back ? 1 : 2) << stated.name << ' ' << nose.id;
        }
    }
}

TEST(PocketedTables, AreClosedForTheirBalls) {
    for (const Stated& stated : all()) {
        Scene scene = table(stated);
        EXPECT_TRUE(scene.closed);
        scene.balls.push_back(ball_of(stated, {stated.width / 2, stated.length / 2}));
        EXPECT_NO_THROW(validate(scene)) << stated.name;
        for (std::size_t i = 0; i < scene.rims.size(); ++i) {
            Scene open = scene;
            open.rims.erase(open.rims.begin() + static_cast<std::ptrdiff_t>(i));
            EXPECT_THROW(validate(open), SceneError) << stated.name << ' ' << scene.rims[i].id;
        }
    }
}

TEST(PocketedTables, ABallRolledStraightIntoAPocketFalls) {
    for (const Stated& stated : all()) {
        const Scene bare = table(stated);
        for (std::uint32_t k = 0; k < bare.rims.size(); ++k) {
            const Rim& rim = bare.rims[k];
            const double left_or_right = rim.center.x < 0 ? 1 : -1;
            const bool is_side = std::abs(rim.center.y - stated.length / 2) < 0.1;
            const double up_or_down = is_side ? 0 : rim.center.y < 0 ? 1 : -1;
            Scene scene = bare;
            scene.balls.push_back(ball_of(
                stated, {rim.center.x + 0.4 * left_or_right, rim.center.y + 0.4 * up_or_down},
                {-left_or_right, -up_or_down}));
            const osculo::Run run = simulate(scene);
            ASSERT_EQ(run.events.size(), 1U) << stated.name << ' ' << rim.id;
            EXPECT_EQ(run.events[0].kind, EventKind::capture);
            EXPECT_EQ(run.balls[0].rim, k);
        }
    }
}

// From the middle of the table at every jaw, nose and tip: a ball falls or stays on the table.
TEST(PocketedTables, NoBallGetsLostAtAJaw) {
    for (const Stated& stated : all()) {
        const Scene bare = table(stated);
        const Point middle{stated.width / 2, 0.45 * stated.length};
        int fallen = 0;
        for (const Rim& rim : bare.rims) {
            for (int aim = -20; aim <= 20; ++aim) {
                const double angle =
                    std::atan2(rim.center.y - middle.y, rim.center.x - middle.x) + 0.01 * aim;
                Scene scene = bare;
                scene.balls.push_back(
                    ball_of(stated, middle, {5 * std::cos(angle), 5 * std::sin(angle)}));
                scene.limits.time = 10;
                const osculo::Run run = simulate(scene, {.audit = true});
                EXPECT_TRUE(run.audit->clean) << stated.name << ' ' << rim.id << ' ' << aim;
                const Point& p = run.balls[0].state.position;
                EXPECT_TRUE(p.x > -0.06 && p.x < stated.width + 0.06);
                EXPECT_TRUE(p.y > -0.06 && p.y < stated.length + 0.06);
                fallen += run.balls[0].fate == BallFate::captured;
            }
        }
        EXPECT_GT(fallen, 40) << stated.name;
    }
}

}  // namespace
}  // namespace osculo::presets

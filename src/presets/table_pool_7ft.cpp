#include <numbers>

#include "presets/tables.hpp"

// Noses, jaws and pockets of the 7 ft table of pooltool, commit 9a8abfe, whose makers measured a
// Showood table. The bed is 0.9906 m x 1.9812 m (39 in x 78 in), the cushions are 0.0508 m (2 in)
// deep. Numbers below are for the quarter at the origin; the others are its mirror images.

namespace osculo::presets {
namespace {

constexpr double kPi = std::numbers::pi;

// Where a cushion ends at a pocket: its nose line bends around an arc, the jaw's nose, into the
// straight jaw, which ends at the back of the cushion.
struct Jaw {
    Point rail_end;  // where the straight cushion passes into the arc
    Point center;    // of the arc
    double radius;
    double rail_angle;  // of the arc's end at the straight cushion
    double jaw_angle;   // of the arc's end at the jaw
    Point jaw_end;      // where the arc passes into the jaw
    Point tip;          // where the jaw ends
};

// The jaws turn by 90 degrees less 45 + 5.3 at corners, and by 90 less 7.14 at the sides.
constexpr double kCornerTurn = 39.7 * kPi / 180;
constexpr double kSideTurn = 82.86 * kPi / 180;

constexpr Jaw kCornerJaw{.rail_end = {0.09100172278778172, 0},
                         .center = {0.09100172278778172, -0.02095},
                         .radius = 0.02095,
                         .rail_angle = kPi / 2,
                         .jaw_angle = kPi / 2 + kCornerTurn,
                         .jaw_end = {0.07761953701082995, -0.00483107932176755},
                         .tip = {0.022249704426935857, -0.0508}};

constexpr Jaw kSideJaw{.rail_end = {0, 0.91508373076875},
                       .center = {-0.00795, 0.91508373076875},
                       .radius = 0.00795,
                       .rail_angle = 0,
                       .jaw_angle = kSideTurn,
                       .jaw_end = {-0.00696186091167262, 0.9229720817461166},
                       .tip = {-0.0508, 0.9284141466272995}};

constexpr Point kCornerPocket{-0.029486352775479032, -0.029486352775479032};
constexpr double kCornerPocketRadius = 0.062;
constexpr Point kSidePocket{-0.0685, 0.9906};
constexpr double kSidePocketRadius = 0.0645;

// What maps a point and an angle of the first quarter to another place.
struct Swap {
    constexpr Point operator()(Point p) const { return {p.y, p.x}; }
    constexpr double operator()(double angle) const { return kPi / 2 - angle; }
};
struct MirrorX {
    constexpr Point operator()(Point p) const { return {kPool7ft.width - p.x, p.y}; }
    constexpr double operator()(double angle) const { return kPi - angle; }
};
struct MirrorY {
    constexpr Point operator()(Point p) const { return {p.x, kPool7ft.length - p.y}; }
    constexpr double operator()(double angle) const { return -angle; }
};

template <class Map>
constexpr Jaw mapped(const Jaw& jaw, Map map) {
    return {map(jaw.rail_end),  map(jaw.center),  jaw.radius,  map(jaw.rail_angle),
            map(jaw.jaw_angle), map(jaw.jaw_end), map(jaw.tip)};
}

// A cushion from one pocket to the next, counter-clockwise around the table, so that the bed is on
// its left. Arcs bulge towards the bed: counter-clockwise about their own centres they run back.
void add_cushion(Scene& scene, const std::string& name, const Jaw& first, const Jaw& second) {
    scene.segments.push_back({name + "-jaw-1", first.tip, first.jaw_end, Side::left});
    scene.arcs.push_back(
        {name + "-nose-1", first.center, first.radius, first.rail_angle, first.jaw_angle});
    scene.segments.push_back({name, first.rail_end, second.rail_end, Side::left});
    scene.arcs.push_back(
        {name + "-nose-2", second.center, second.radius, second.jaw_angle, second.rail_angle});
    scene.segments.push_back({name + "-jaw-2", second.jaw_end, second.tip, Side::left});
}

}  // namespace

void add_pool_7ft(Scene& scene) {
    constexpr MirrorX mirror_x;
    constexpr MirrorY mirror_y;
    constexpr Jaw bottom = kCornerJaw;
    constexpr Jaw left = mapped(kCornerJaw, Swap{});
    constexpr Jaw right = mapped(left, mirror_x);
    constexpr Jaw right_side = mapped(kSideJaw, mirror_x);
    constexpr Jaw top = mapped(bottom, mirror_y);

    add_cushion(scene, "bottom", bottom, mapped(bottom, mirror_x));
    add_cushion(scene, "right-lower", right, right_side);
    add_cushion(scene, "right-upper", mapped(right_side, mirror_y), mapped(right, mirror_y));
    add_cushion(scene, "top", mapped(top, mirror_x), top);
    add_cushion(scene, "left-upper", mapped(left, mirror_y), mapped(kSideJaw, mirror_y));
    add_cushion(scene, "left-lower", kSideJaw, left);

    const auto add_pocket = [&scene](const char* name, Point center, double radius) {
        scene.rims.push_back({name, center, radius, RimLaw::capture});
    };
    add_pocket("pocket-bottom-left", kCornerPocket, kCornerPocketRadius);
    add_pocket("pocket-bottom-right", mirror_x(kCornerPocket), kCornerPocketRadius);
    add_pocket("pocket-right", mirror_x(kSidePocket), kSidePocketRadius);
    add_pocket("pocket-top-right", mirror_y(mirror_x(kCornerPocket)), kCornerPocketRadius);
    add_pocket("pocket-top-left", mirror_y(kCornerPocket), kCornerPocketRadius);
    add_pocket("pocket-left", kSidePocket, kSidePocketRadius);
}

}  // namespace osculo::presets

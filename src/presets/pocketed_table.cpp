#include "presets/pocketed_table.hpp"

#include <cmath>
#include <numbers>

#include "osculo/math/trigonometry.hpp"

namespace osculo::presets {
namespace {

constexpr double kPi = std::numbers::pi;

struct Turn {
    double angle;
    double sine;
    double cosine;
};

Turn turn_by(double angle) {
    const auto [sine, cosine] = math::sin_cos<double>(angle);
    return {angle, sine, cosine};
}

// By how much the nose turns: by the whole angle of the cut, unless it comes to the back of the
// cushion before.
Turn turn_of_nose(const PocketCut& cut, double cushion_depth) {
    const Turn whole = turn_by(cut.turn);
    const double cosine = 1 - cushion_depth / cut.nose_radius;
    if (whole.cosine >= cosine) return whole;
    // The angle of that cosine, by bisection: the library's acos is not the same everywhere.
    double low = 0;
    double high = cut.turn;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (turn_by(middle).cosine > cosine ? low : high) = middle;
    }
    return {high, std::sqrt(1 - cosine * cosine), cosine};
}

// The jaw of a cushion whose nose line runs along the x axis towards smaller x, and turns away from
// the bed at y > 0. `lip` is where the lines of nose and jaw meet.
Jaw cut_jaw(double lip, const PocketCut& cut, double cushion_depth) {
    const Turn whole = turn_by(cut.turn);
    const Turn nose = turn_of_nose(cut, cushion_depth);
    const double radius = cut.nose_radius;
    Jaw jaw{};
    jaw.rail_end = {lip + radius * (whole.sine / (1 + whole.cosine)), 0};
    jaw.center = {jaw.rail_end.x, -radius};
    jaw.radius = radius;
    jaw.rail_angle = kPi / 2;
    jaw.jaw_angle = kPi / 2 + nose.angle;
    jaw.jaw_end = {jaw.center.x - radius * nose.sine, -radius * (1 - nose.cosine)};
    const bool is_straight = nose.angle == whole.angle;
    jaw.tip = is_straight ? Point{lip - cushion_depth * (whole.cosine / whole.sine), -cushion_depth}
                          : jaw.jaw_end;
    return jaw;
}

// What maps a point and an angle of the first quarter to another place.
struct Swap {
    Point operator()(Point p) const { return {p.y, p.x}; }
    double operator()(double angle) const { return kPi / 2 - angle; }
};
struct MirrorX {
    double width;
    Point operator()(Point p) const { return {width - p.x, p.y}; }
    double operator()(double angle) const { return kPi - angle; }
};
struct MirrorY {
    double length;
    Point operator()(Point p) const { return {p.x, length - p.y}; }
    double operator()(double angle) const { return -angle; }
};

template <class Map>
Jaw mapped(const Jaw& jaw, Map map) {
    return {map(jaw.rail_end),  map(jaw.center),  jaw.radius,  map(jaw.rail_angle),
            map(jaw.jaw_angle), map(jaw.jaw_end), map(jaw.tip)};
}

// A cushion from one pocket to the next, counter-clockwise around the table, so that the bed is on
// its left. Arcs bulge towards the bed: counter-clockwise about their own centres they run back.
void add_cushion(Scene& scene, const std::string& name, const Jaw& first, const Jaw& second) {
    const auto add_jaw = [&](const char* suffix, Point from, Point to) {
        if (from != to) scene.segments.push_back({name + suffix, from, to, Side::left});
    };
    add_jaw("-jaw-1", first.tip, first.jaw_end);
    scene.arcs.push_back(
        {name + "-nose-1", first.center, first.radius, first.rail_angle, first.jaw_angle});
    scene.segments.push_back({name, first.rail_end, second.rail_end, Side::left});
    scene.arcs.push_back(
        {name + "-nose-2", second.center, second.radius, second.jaw_angle, second.rail_angle});
    add_jaw("-jaw-2", second.jaw_end, second.tip);
}

}  // namespace

PocketedTable cut_pockets(const Bed& bed, double cushion_depth, const PocketCut& corner,
                          const PocketCut& side) {
    PocketedTable table{};
    table.bed = bed;
    // The mouth of a corner is the diagonal of a square, and its middle half a diagonal away.
    table.corner = cut_jaw(corner.mouth / std::numbers::sqrt2, corner, cushion_depth);
    const double behind = corner.shelf + corner.pocket_radius - corner.mouth / 2;
    table.corner_pocket = {-behind / std::numbers::sqrt2, -behind / std::numbers::sqrt2};
    table.corner_pocket_radius = corner.pocket_radius;

    // The side's cushion runs along y towards the middle of the table.
    const double middle = bed.length / 2;
    const Jaw jaw = cut_jaw(side.mouth / 2, side, cushion_depth);
    table.side = mapped(mapped(jaw, Swap{}), MirrorY{middle});
    table.side_pocket = {-(side.shelf + side.pocket_radius), middle};
    table.side_pocket_radius = side.pocket_radius;
    return table;
}

void add_pocketed_table(Scene& scene, const PocketedTable& table) {
    const MirrorX mirror_x{table.bed.width};
    const MirrorY mirror_y{table.bed.length};
    const Jaw& bottom = table.corner;
    const Jaw left = mapped(table.corner, Swap{});
    const Jaw right = mapped(left, mirror_x);
    const Jaw right_side = mapped(table.side, mirror_x);
    const Jaw top = mapped(bottom, mirror_y);

    add_cushion(scene, "bottom", bottom, mapped(bottom, mirror_x));
    add_cushion(scene, "right-lower", right, right_side);
    add_cushion(scene, "right-upper", mapped(right_side, mirror_y), mapped(right, mirror_y));
    add_cushion(scene, "top", mapped(top, mirror_x), top);
    add_cushion(scene, "left-upper", mapped(left, mirror_y), mapped(table.side, mirror_y));
    add_cushion(scene, "left-lower", table.side, left);

    const auto add_pocket = [&scene](const char* name, Point center, double radius) {
        scene.rims.push_back({name, center, radius, RimLaw::capture});
    };
    const Point corner = table.corner_pocket;
    add_pocket("pocket-bottom-left", corner, table.corner_pocket_radius);
    add_pocket("pocket-bottom-right", mirror_x(corner), table.corner_pocket_radius);
    add_pocket("pocket-right", mirror_x(table.side_pocket), table.side_pocket_radius);
    add_pocket("pocket-top-right", mirror_y(mirror_x(corner)), table.corner_pocket_radius);
    add_pocket("pocket-top-left", mirror_y(corner), table.corner_pocket_radius);
    add_pocket("pocket-left", table.side_pocket, table.side_pocket_radius);
}

}  // namespace osculo::presets

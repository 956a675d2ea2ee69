#pragma once

#include "osculo/presets.hpp"
#include "presets/tables.hpp"

// Tables with six pockets. Everything is given for the quarter at the origin, at the corner of the
// nose lines at the bottom left; the other quarters are its mirror images.
namespace osculo::presets {

/// Where a cushion ends at a pocket: its nose line bends around an arc, the jaw's nose, into the
/// straight jaw, which ends at the back of the cushion.
struct Jaw {
    Point rail_end;     ///< where the straight cushion passes into the arc
    Point center;       ///< of the arc
    double radius;      ///< of the arc [m]
    double rail_angle;  ///< of the arc's end at the straight cushion [rad]
    double jaw_angle;   ///< of the arc's other end [rad]
    Point jaw_end;      ///< where the arc passes into the jaw
    Point tip;          ///< where the jaw ends; jaw_end if there is no straight jaw
};

/// A table by its jaws and pockets.
struct PocketedTable {
    Bed bed;
    Jaw corner;  ///< of the bottom cushion, at the corner of the origin
    Jaw side;    ///< of the left cushion, below its side pocket
    Point corner_pocket;
    double corner_pocket_radius;  ///< [m]
    Point side_pocket;
    double side_pocket_radius;  ///< [m]
};

/// How cushions are cut at a pocket, in the terms of those who build tables.
struct PocketCut {
    double mouth;  ///< between the points where nose lines and the lines of the jaws meet [m]
    double turn;   ///< from the nose line to the jaw: pi less the cut angle [rad], in (0, pi/2]
    double nose_radius;    ///< of the arc that touches both lines [m]
    double shelf;          ///< from the middle of the mouth to the edge of the hole [m]; negative
                           ///< where the hole reaches into the bed
    double pocket_radius;  ///< of the hole in the slate [m]
};

/// The table with these pockets. `cushion_depth` is from the noses to the backs of the cushions
/// [m], where the jaws end; an arc that reaches it before it has turned by the whole angle ends
/// there. By
/// + - * / and square roots alone: the same bits everywhere.
[[nodiscard]] PocketedTable cut_pockets(const Bed& bed, double cushion_depth,
                                        const PocketCut& corner, const PocketCut& side);

/// Adds six cushions with their jaws, counter-clockwise from the bottom, and six rims that capture.
void add_pocketed_table(Scene& scene, const PocketedTable& table);

}  // namespace osculo::presets

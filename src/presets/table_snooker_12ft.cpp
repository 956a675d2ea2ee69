#include <numbers>

#include "presets/pocketed_table.hpp"

// The bed of the rules of snooker, 3569 mm x 1778 mm between the faces of the cushions [WPBSA
// rules, section 1]. Its pockets follow templates that are not published; these are the measures of
// the snooker table of pooltool (snooker_generic, commit 13a571d): cushions of 1.55 in, corner jaws
// 83 mm apart, parallel and rounded with 3.6 in, side jaws rounded with 2.5 in towards lines 75 mm
// apart at right angles to the cushion, holes of 43 mm radius 36 mm outside of the corner and
// of 1.68 in radius 0.95 in behind the side's nose line.

namespace osculo::presets {
namespace {

constexpr double kInch = 0.0254;
constexpr double kPi = std::numbers::pi;

constexpr double kCushionDepth = 1.55 * kInch;
constexpr PocketCut kCorner{.mouth = 0.083,
                            .turn = kPi / 4,
                            .nose_radius = 3.6 * kInch,
                            .shelf = 0.083 / 2 + 0.036 - 0.043,
                            .pocket_radius = 0.043};
// The noses reach the back of the cushion before they have turned by a right angle. The holes reach
// into the bed, as the falls of middle pockets do.
constexpr PocketCut kSide{.mouth = 0.075,
                          .turn = kPi / 2,
                          .nose_radius = 2.5 * kInch,
                          .shelf = (0.95 - 1.68) * kInch,
                          .pocket_radius = 1.68 * kInch};

}  // namespace

void add_snooker_12ft(Scene& scene) {
    add_pocketed_table(scene, cut_pockets(kSnooker12ft, kCushionDepth, kCorner, kSide));
}

}  // namespace osculo::presets

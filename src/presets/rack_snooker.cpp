#include "presets/racks.hpp"

namespace osculo::presets {

// The spots of the rules [WPBSA rules, sections 1 and 3]: the baulk line is 737 mm from the bottom
// cushion, the D is a half circle of 292 mm about its middle; brown is there, green and yellow are
// in the corners of the D, yellow to the right as seen from baulk; blue is in the middle of the
// table, pink halfway from there to the top cushion, black 324 mm from that. The reds are in a
// triangle behind the pink, as near to it as can be without touching: the gap away, like each
// other.
void add_snooker(Scene& scene, const Bed& bed, const RackOptions& options) {
    constexpr double kBaulkLine = 0.737;
    constexpr double kRadiusOfD = 0.292;
    const double middle = bed.width / 2;
    const Point pink{middle, 0.75 * bed.length};
    Racker racker(scene, bed, kSnookerBallMass, kSnookerBallRadius, options);

    racker.add("yellow", {middle + kRadiusOfD, kBaulkLine});
    racker.add("green", {middle - kRadiusOfD, kBaulkLine});
    racker.add("brown", {middle, kBaulkLine});
    racker.add("blue", {middle, bed.length / 2});
    racker.add("pink", pink);
    racker.add("black", {middle, bed.length - 0.324});
    int number = 0;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column <= row; ++column) {
            racker.add_shaken("red-" + std::to_string(++number),
                              {pink.x + (column - row / 2.0) * racker.spacing(),
                               pink.y + racker.spacing() + row * racker.row_height()});
        }
    }
    // On the baulk line between brown and yellow, where most players break from.
    racker.add_cue({middle + 0.2, kBaulkLine});
}

}  // namespace osculo::presets

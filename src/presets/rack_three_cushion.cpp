#include "presets/racks.hpp"

namespace osculo::presets {

// Red on the foot spot, the opponent's ball on the head spot, the ball of the one who begins 182.5
// mm beside it [UMB rules: the starting position]; here it is to the right, and the ball that is
// struck is called "cue" as in the other games.
void add_three_cushion(Scene& scene, const Bed& bed, const RackOptions& options) {
    const double middle = bed.width / 2;
    Racker racker(scene, bed, kCaromBallMass, kCaromBallRadius, options);
    racker.add("yellow", {middle, bed.length / 4});
    racker.add("red", {middle, 0.75 * bed.length});
    racker.add_cue({middle + 0.1825, bed.length / 4});
}

}  // namespace osculo::presets

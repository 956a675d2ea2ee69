#include "presets/parameters.hpp"
#include "presets/scenes.hpp"
#include "presets/tables.hpp"

namespace osculo::presets {

Scene make_frictionless_break(const Parameters& parameters) {
    Scene scene;
    add_table(scene, "pool-7ft");
    scene.impacts = impacts_of(parameters);
    scene.limits.time = 10;

    // 9 m/s is a firm break. From the head string (a quarter of the length), a little to the right,
    // past the axis: the cue ball meets the first ball 2 mm off its centre.
    const double speed = speed_of(parameters, 9);
    Ball cue;
    cue.id = "cue";
    cue.mass = kPoolBallMass;
    cue.radius = kPoolBallRadius;
    cue.position = {kPool7ft.width / 2 + 0.002, kPool7ft.length / 4};
    cue.velocity = {0, speed};
    scene.balls.push_back(cue);

    add_rack(scene, "eight-ball", {.gap = parameters.gap.value_or(1e-4)});
    return scene;
}

}  // namespace osculo::presets

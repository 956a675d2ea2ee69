#include "presets/parameters.hpp"
#include "presets/scenes.hpp"
#include "presets/stage.hpp"

namespace osculo::presets {

// A hall of 1.8 m that narrows towards its only hole, with three posts in the way.
Scene make_stage_funnel(const Parameters& parameters) {
    const double speed = speed_of(parameters, 3);
    Scene scene = stage(in_range("restitution", parameters.restitution, 0.85, 0.0, 1.0));
    add_room(
        scene, "wall",
        {{0, 0}, {1.1, 0}, {1.5, 0.3}, {1.8, 0.3}, {1.8, 0.6}, {1.5, 0.6}, {1.1, 0.9}, {0, 0.9}});
    add_post(scene, "post-1", {0.8, 0.25}, 0.04);
    add_post(scene, "post-2", {0.8, 0.65}, 0.04);
    add_post(scene, "post-3", {1.1, 0.45}, 0.06);
    add_hole(scene, "hole", {1.68, 0.45}, 0.055);
    add_ball(scene, "player", {0.2, 0.45}, 0.028, {speed, 0.05 * speed});
    add_ball(scene, "red", {0.55, 0.45}, 0.028);
    add_ball(scene, "blue", {0.62, 0.5}, 0.028);
    add_ball(scene, "big", {0.95, 0.72}, 0.045);
    add_ball(scene, "small", {0.95, 0.18}, 0.018);
    return scene;
}

}  // namespace osculo::presets

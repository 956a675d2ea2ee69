#include "presets/parameters.hpp"
#include "presets/scenes.hpp"
#include "presets/stage.hpp"

namespace osculo::presets {

// A room with a bent corridor around islands, and a hole at the end of each way.
Scene make_stage_islands(const Parameters& parameters) {
    const double speed = speed_of(parameters, 4);
    Scene scene = stage(in_range("restitution", parameters.restitution, 0.85, 0.0, 1.0));
    add_room(
        scene, "wall",
        {{0, 0}, {1.6, 0}, {1.6, 0.7}, {1, 0.7}, {0.9, 0.8}, {0.9, 1.4}, {0.2, 1.4}, {0, 1.2}});
    add_island(scene, "square", {{0.35, 0.3}, {0.5, 0.25}, {0.55, 0.4}, {0.4, 0.45}});
    add_island(scene, "wedge", {{1, 0.2}, {1.25, 0.28}, {1, 0.36}});
    add_island(scene, "bar", {{0.3, 0.85}, {0.6, 0.8}, {0.61, 0.84}, {0.31, 0.89}});
    add_post(scene, "post", {0.7, 0.62}, 0.05);
    add_hole(scene, "east", {1.48, 0.58}, 0.06);
    add_hole(scene, "north", {0.78, 1.28}, 0.06);
    add_hole(scene, "west", {0.12, 1.1}, 0.06);
    add_ball(scene, "player", {0.15, 0.15}, 0.03, {0.8 * speed, 0.6 * speed});
    add_ball(scene, "red", {0.75, 0.25}, 0.03);
    add_ball(scene, "green", {0.2, 0.6}, 0.03);
    add_ball(scene, "blue", {0.5, 1.05}, 0.03);
    add_ball(scene, "heavy", {1.35, 0.15}, 0.05);
    add_ball(scene, "light", {0.85, 0.52}, 0.02);
    return scene;
}

}  // namespace osculo::presets

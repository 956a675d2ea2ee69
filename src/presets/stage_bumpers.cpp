#include "presets/parameters.hpp"
#include "presets/scenes.hpp"
#include "presets/stage.hpp"

namespace osculo::presets {

// An octagon of bumpers: four holes, five posts, two leaning walls, and a ball ten times as heavy
// as the others.
Scene make_stage_bumpers(const Parameters& parameters) {
    const double speed = speed_of(parameters, 5);
    Scene scene = stage(in_range("restitution", parameters.restitution, 0.9, 0.0, 1.0));
    add_room(
        scene, "wall",
        {{0.4, 0}, {1.2, 0}, {1.6, 0.4}, {1.6, 1.2}, {1.2, 1.6}, {0.4, 1.6}, {0, 1.2}, {0, 0.4}});
    add_post(scene, "middle", {0.8, 0.8}, 0.09);
    add_post(scene, "post-1", {0.5, 0.55}, 0.05);
    add_post(scene, "post-2", {1.1, 0.55}, 0.05);
    add_post(scene, "post-3", {1.1, 1.05}, 0.05);
    add_post(scene, "post-4", {0.5, 1.05}, 0.05);
    scene.segments.push_back({"slant-1", {0.25, 0.7}, {0.35, 0.9}, Side::both});
    scene.segments.push_back({"slant-2", {1.35, 0.7}, {1.25, 0.9}, Side::both});
    add_hole(scene, "south-west", {0.3, 0.3}, 0.07);
    add_hole(scene, "south-east", {1.3, 0.3}, 0.07);
    add_hole(scene, "north-east", {1.3, 1.3}, 0.07);
    add_hole(scene, "north-west", {0.3, 1.3}, 0.07);
    add_ball(scene, "player", {0.8, 0.15}, 0.028, {0.28 * speed, 0.96 * speed});
    add_ball(scene, "red", {0.8, 0.5}, 0.028);
    add_ball(scene, "blue", {0.5, 0.8}, 0.028);
    add_ball(scene, "green", {1.1, 0.8}, 0.028);
    add_ball(scene, "yellow", {0.8, 1.1}, 0.028);
    add_ball(scene, "ten", {0.8, 1.4}, 0.0603);  // 10^(1/3) times the radius
    return scene;
}

}  // namespace osculo::presets

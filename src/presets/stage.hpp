#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "osculo/scene.hpp"

// What stages are built from: walls at any angle, islands, posts, holes, balls of any size.
namespace osculo::presets {

/// Walls along corners in counter-clockwise order that keep balls inside; ids "name-1", ...
void add_room(Scene& scene, const std::string& name, std::initializer_list<Point> corners);

/// The same from outside, corners counter-clockwise.
void add_island(Scene& scene, const std::string& name, std::initializer_list<Point> corners);

/// A round obstacle.
void add_post(Scene& scene, const std::string& id, Point center, double radius);

/// A hole, over whose rim gravity pulls balls.
void add_hole(Scene& scene, const std::string& id, Point center, double radius);

/// A solid ball of phenolic resin, 1700 kg/m^3: its mass follows from its radius [m].
void add_ball(Scene& scene, const std::string& id, Point position, double radius,
              Point velocity = {});

/// What the stages have in common: the laws, the limits, and that no ball can leave.
[[nodiscard]] Scene stage(double restitution);

}  // namespace osculo::presets

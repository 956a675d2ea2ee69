#pragma once

#include <string>

#include "osculo/scene.hpp"

namespace osculo::test {

/// A ball of mass 1 and radius r.
inline Ball ball(std::string id, Point position, Point velocity = {}, double radius = 0.5) {
    return {std::move(id), 1, radius, position, velocity, {}};
}

/// Four one-sided walls around [0, width] x [0, height].
inline void add_box(Scene& scene, double width, double height) {
    scene.segments.push_back({"bottom", {0, 0}, {width, 0}, Side::left});
    scene.segments.push_back({"right", {width, 0}, {width, height}, Side::left});
    scene.segments.push_back({"top", {width, height}, {0, height}, Side::left});
    scene.segments.push_back({"left", {0, height}, {0, 0}, Side::left});
}

}  // namespace osculo::test

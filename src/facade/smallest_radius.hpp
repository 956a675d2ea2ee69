#pragma once

#include <algorithm>
#include <limits>

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Of all balls of the scene [m]; infinite if there are none.
[[nodiscard]] inline double smallest_radius(const Scene& scene) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : scene.balls) smallest = std::min(smallest, ball.radius);
    return smallest;
}

}  // namespace osculo::facade

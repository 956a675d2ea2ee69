#pragma once

#include <optional>
#include <vector>

#include "osculo/scene.hpp"

/// Balls that all but touch, and what comes out where they do.
namespace osculo::bench::spacing {

struct Spaced {
    const char* name;
    /// [gap] between neighbours, in radii, all of them 1 m. The first ball comes with 1 m/s; its
    /// way ends in touch with what it hits.
    Scene (*make)(double gap);
    /// Velocities at the gap 0 under the law `symmetric`, in the order of the balls, as far as they
    /// have a closed form (NUMERICS 4.2). Empty: none is known.
    std::vector<Point> expected;
    /// Whether every way of resolving contacts at one instant gives the same velocities.
    bool well_posed = false;
};

/// All of them, each in its own way.
[[nodiscard]] std::vector<Spaced> scenes();

}  // namespace osculo::bench::spacing

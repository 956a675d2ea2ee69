#pragma once

#include <optional>
#include <vector>

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Two balls that overlap.
struct Overlap {
    std::size_t first;  ///< indices into the balls, first < second
    std::size_t second;
    double depth;  ///< [m]
};

/// A pair of balls that overlap by more than [allowed] times the smaller radius, if there is one.
/// Requires finite positions and positive radii. O(n log n) for balls that hardly overlap.
[[nodiscard]] std::optional<Overlap> find_overlap(const std::vector<Ball>& balls, double allowed);

}  // namespace osculo::facade

#pragma once

#include <cstdint>
#include <optional>
#include <span>
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

/// Whether there is one among the balls whose entry in [present] is not 0; all are there if it is
/// empty. Allocates nothing for few balls.
[[nodiscard]] bool has_overlap(const std::vector<Ball>& balls,
                               std::span<const std::uint8_t> present, double allowed);

}  // namespace osculo::facade

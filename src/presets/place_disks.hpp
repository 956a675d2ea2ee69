#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "osculo/scene.hpp"

// Random numbers that are the same bits everywhere: the standard fixes std::mt19937_64 but neither
// its distributions nor log, sin and cos.
namespace osculo::presets {

/// Uniform in [0, 1): 53 random bits.
[[nodiscard]] double uniform(std::mt19937_64& random);

/// A unit vector of random direction.
[[nodiscard]] Point random_direction(std::mt19937_64& random);

/// Uniform in the unit disk.
[[nodiscard]] Point random_in_disk(std::mt19937_64& random);

/// Centres of `count` disks of that radius, apart from each other and from the edges of the unit
/// square: a lattice, shaken as far as its cells allow. Empty if its cells are too small.
[[nodiscard]] std::vector<Point> place_disks(std::uint32_t count, double radius,
                                             std::mt19937_64& random);

}  // namespace osculo::presets

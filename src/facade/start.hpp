#pragma once

#include <cstdint>
#include <span>

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Whether the balls can start where and as they are, in a scene without a cue that would be valid
/// with other states of its balls; but not whether they are enclosed. Balls whose entry in
/// [present] is 0 do not matter; all are there if it is empty. Allocates nothing for few balls.
[[nodiscard]] bool is_valid_start(const Scene& scene, std::span<const std::uint8_t> present);

}  // namespace osculo::facade

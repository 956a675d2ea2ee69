#pragma once

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Throws SceneError if the scene has a cue and its strike is impossible.
void validate_cue(const Scene& scene);

/// Whether the strike is possible, in a scene that would be valid with another speed, azimuth,
/// elevation and offset of its cue. Allocates nothing.
[[nodiscard]] bool is_possible_strike(const Scene& scene);

/// The same but for what is in the way of the stick.
[[nodiscard]] bool is_possible_but_for_stick(const Scene& scene);

}  // namespace osculo::facade

#pragma once

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Throws SceneError if the scene has a cue and its strike is impossible.
void validate_cue(const Scene& scene);

}  // namespace osculo::facade

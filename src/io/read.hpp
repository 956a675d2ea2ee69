#pragma once

#include "io/value.hpp"

namespace osculo::io {

inline constexpr std::string_view kSceneSchema = "osculo/scene-1";
inline constexpr std::string_view kRunSchema = "osculo/run-1";

// Each throws SceneError for what breaks a rule of the schema or, at the end, of the scene.
[[nodiscard]] Scene read_scene(const Value& value);
[[nodiscard]] Run read_run(const Value& value);

/// A vector [x, y, z].
[[nodiscard]] inline Spin read_spin(const Value& value) {
    return value.numbers<3>();
}

}  // namespace osculo::io

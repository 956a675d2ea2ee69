#pragma once

#include "io/value.hpp"

namespace osculo::io {

// Each throws SceneError for what breaks a rule of the schema.
[[nodiscard]] MotionLaw read_motion(const Value& value);
[[nodiscard]] Impacts read_impacts(const Value& value, const Impacts& defaults);
[[nodiscard]] Cue read_cue(const Value& value);

}  // namespace osculo::io

#pragma once

#include "io/json_text.hpp"
#include "io/value.hpp"
#include "osculo/outcome.hpp"

namespace osculo::io {

/// The outcome as an object, inside a run.
void write_outcome(JsonText& json, const Run& run, const Outcome& outcome);

/// An outcome follows from the events of its run: throws SceneError unless it is that of `run`.
void check_outcome(const Value& value, const Run& run);

}  // namespace osculo::io

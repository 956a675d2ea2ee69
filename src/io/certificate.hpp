#pragma once

#include "io/json_text.hpp"
#include "io/value.hpp"
#include "osculo/run.hpp"

namespace osculo::io {

/// The certificate of the run as an object in the run's document.
void write_certificate(JsonText& json, const Run& run, const Certificate& certificate);

/// The same read back; must be about as many events and balls as the run has.
[[nodiscard]] Certificate read_certificate(const Value& value, const Run& run);

}  // namespace osculo::io

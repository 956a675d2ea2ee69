#pragma once

#include "osculo/certificate.hpp"
#include "osculo/run.hpp"
#include "osculo/simulate.hpp"

namespace osculo::facade {

/// Runs the run's scene again in higher and higher precisions, until two of them agree at least as
/// far as the run agrees with them, or there is no higher one. Requires the run's events. Throws
/// SceneError if there is no higher precision, or no engine for the scene in one.
[[nodiscard]] Certificate certify(const Run& run, Precision precision);

/// What the two runs say about the first; the witness may be null. Requires their events.
[[nodiscard]] Certificate compare(const Run& run, const Run& reference, const Run* witness);

}  // namespace osculo::facade

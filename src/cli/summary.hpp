#pragma once

#include <string>

#include "osculo/run.hpp"

namespace osculo::cli {

/// What happened in a run, in words, for people.
[[nodiscard]] std::string summary(const Run& run, const std::string& name, double seconds);

/// "16 balls, 18 segments, 12 arcs, 6 rims", without what there is none of.
[[nodiscard]] std::string contents(const Scene& scene);

}  // namespace osculo::cli

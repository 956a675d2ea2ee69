#pragma once

#include "osculo/scene.hpp"

namespace osculo::fuzz {

/// Ends the program, which the fuzzer reports with the input, unless the condition holds.
void require(bool condition, const char* what, const Scene& scene);

/// Everything that must hold of the run of any valid scene: it ends within its limits with a
/// status, its audit is clean unless it says `numeric`, energy is kept where nothing takes any,
/// files give it back, and neither the order of the balls nor what is recorded changes it. Runs at
/// most a few hundred events.
void check_run(Scene scene);

}  // namespace osculo::fuzz

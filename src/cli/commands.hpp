#pragma once

#include "cli/failure.hpp"

namespace CLI {
class App;
}

// Each adds one or more commands. A command that runs throws Failure or sets the exit code.
namespace osculo::cli {

void add_run(CLI::App& app, ExitCode& exit_code);
void add_render(CLI::App& app);
void add_replay(CLI::App& app);
void add_check(CLI::App& app);  ///< validate, explain, expand
void add_presets(CLI::App& app);
void add_batch(CLI::App& app, ExitCode& exit_code);  ///< batch, merge

}  // namespace osculo::cli

#pragma once

#include <string>
#include <string_view>

namespace osculo::cli {

/// "-": standard input or output.
inline constexpr std::string_view kStandardStream = "-";

/// All bytes of the file. Throws Failure.
[[nodiscard]] std::string read_file(const std::string& path);

/// Writes the file whole or not at all: into a new file beside it that then takes its name. What is
/// no regular file (a device, a pipe) is written to directly. Throws Failure.
void write_file(const std::string& path, std::string_view content);

/// To standard output. Who stops reading has read enough: that is no failure.
void write_output(std::string_view content);

/// Makes Ctrl-C leave no half-written file behind, and a closed pipe no signal.
void handle_signals();

}  // namespace osculo::cli

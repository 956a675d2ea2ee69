#pragma once

#include <string>
#include <string_view>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"

namespace osculo::io {

/// Text that is not a valid osculo file. what() is one line; for broken JSON it has line and
/// column.
class FormatError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A scene from JSON text (schema osculo/scene-1). `table` and `rack` are expanded.
/// Throws FormatError if the text is not JSON, SceneError if it breaks a rule of the schema or
/// scene.
[[nodiscard]] Scene scene_from_json(std::string_view text);

/// The scene as JSON (schema osculo/scene-1), fully expanded, shortest round-trip numbers.
[[nodiscard]] std::string scene_to_json(const Scene& scene);

/// A run from JSON text (schema osculo/run-1), as written by run_to_json.
[[nodiscard]] Run run_from_json(std::string_view text);

/// The run as JSON (schema osculo/run-1), with the scene it is a run of.
[[nodiscard]] std::string run_to_json(const Run& run);

struct SvgOptions {
    double width = 1200;  ///< [px]; the height follows from the scene
    bool numbers = true;  ///< number the contact points in order of time
};

/// A picture of the table and its balls before the start.
[[nodiscard]] std::string to_svg(const Scene& scene, const SvgOptions& options = {});

/// A picture of the run: table, balls at start and end, every path, contacts in order of time.
[[nodiscard]] std::string to_svg(const Run& run, const SvgOptions& options = {});

}  // namespace osculo::io

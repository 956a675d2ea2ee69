#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"
#include "osculo/simulation.hpp"

namespace osculo::io {

/// Input that is not a file of osculo at all. what() is one line; for broken JSON it has line and
/// column, for broken MessagePack the byte.
class FormatError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Reading. All throw FormatError if the input is not JSON (MessagePack), and SceneError, with the
// path, for what breaks a rule of the schema or of the scene. Unknown and repeated keys are errors.

/// A scene (schema osculo/scene-1). `table` and `rack` are expanded; the scene is valid.
[[nodiscard]] Scene scene_from_json(std::string_view text);
[[nodiscard]] Scene scene_from_msgpack(std::string_view bytes);

/// A run (schema osculo/run-1), as written by run_to_json. Its outcome, if it has one, must be that
/// of its events.
[[nodiscard]] Run run_from_json(std::string_view text);
[[nodiscard]] Run run_from_msgpack(std::string_view bytes);

/// A scene or a run, as the schema says.
[[nodiscard]] std::variant<Scene, Run> scene_or_run_from_json(std::string_view text);
[[nodiscard]] std::variant<Scene, Run> scene_or_run_from_msgpack(std::string_view bytes);

// Writing. Numbers are the shortest decimals that read back as the same doubles; numbers that are
// not finite, which only a run that ended `numeric` can have, are the texts "inf", "-inf", "nan".
// The same scene or run always gives the same bytes.

/// The scene as JSON (schema osculo/scene-1), fully expanded, one ball or cushion per line.
[[nodiscard]] std::string scene_to_json(const Scene& scene);

/// The run as JSON (schema osculo/run-1), one event or piece per line, with the scene it is a run
/// of, and its outcome if events were recorded. Low parts and spins of zero are left out.
[[nodiscard]] std::string run_to_json(const Run& run);

/// The same document as MessagePack. Throws FormatError if the text is not JSON.
[[nodiscard]] std::string msgpack_from_json(std::string_view text);

// Snapshots: a simulation as one file (schema osculo/snapshot-1), with its scene, its options and
// the state of its engine, to be played on elsewhere, bit for bit as if it had never stopped.

/// The same simulation always gives the same bytes, on every machine.
[[nodiscard]] std::string simulation_to_snapshot(const Simulation& simulation);

/// Where it was. Replays nothing. Throws FormatError for what is no snapshot, is damaged, or was
/// written by another version of osculo, which might play on differently.
[[nodiscard]] Simulation simulation_from_snapshot(std::string_view bytes);

/// Whether it begins as a snapshot does.
[[nodiscard]] bool is_snapshot(std::string_view bytes);

struct SvgOptions {
    double width = 1200;  ///< [px]; the height follows from the scene
    bool numbers = true;  ///< number the contact points in order of time
};

/// A run as one HTML page that needs nothing else: the table, every ball where it exactly is at any
/// time, play, pause, event by event. Plays what its pieces show; a ball without any stands.
[[nodiscard]] std::string to_html(const Run& run, double width = 1200);

/// A picture of the table and its balls before the start.
[[nodiscard]] std::string to_svg(const Scene& scene, const SvgOptions& options = {});

/// A picture of the run: table, balls at start and end, every path, contacts in order of time.
[[nodiscard]] std::string to_svg(const Run& run, const SvgOptions& options = {});

}  // namespace osculo::io

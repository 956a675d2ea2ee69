#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "osculo/batch.hpp"

/// Files of shots and of what came of them, one shot per line.
namespace osculo::io {

/// One start: a row of Starts.
struct Start {
    std::vector<BallState> states;
    std::vector<std::uint8_t> present;
};

using Shot = std::variant<Strike, Start>;

/// A line of shots as JSON (schema osculo/shots-1): a strike with the members of a scene's `cue`
/// that it changes (`speed`, `azimuth`, `elevation`, `offset`), or `balls`, those that are on the
/// table, with `id`, `position`, `velocity` and `spin`. Throws FormatError if it is not JSON, and
/// SceneError for what breaks a rule of the schema. Whether the shot is possible is not looked at.
[[nodiscard]] Shot shot_from_json(std::string_view line, const Scene& scene);

/// Whether a line is not a shot but says `schema`, as the first one may. Throws FormatError if it
/// is not JSON, SceneError if it is another schema than osculo/shots-1.
[[nodiscard]] bool is_shots_header(std::string_view line);

/// What tells whether outcomes are of the same scene, precision and version of osculo.
[[nodiscard]] std::string fingerprint(const Scene& scene, const BatchOptions& options);

/// How outcomes are written as text.
enum class OutcomeFormat { json, csv };

/// The first line of outcomes: as JSON (schema osculo/outcomes-1) the fingerprint, the precision
/// and the ids of balls and rims; as CSV the names of the columns.
[[nodiscard]] std::string outcomes_header(OutcomeFormat format, const Scene& scene,
                                          const BatchOptions& options);

/// The line of shot [row] of a result, which is number [shot] of its file. [error] is why it is
/// invalid, if it is. Doubles are the shortest decimals that read back as the same.
void append_outcome(std::string& text, OutcomeFormat format, const Scene& scene,
                    const BatchResult& result, std::size_t row, std::uint64_t shot,
                    std::string_view error);

}  // namespace osculo::io

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "osculo/scene.hpp"

namespace osculo::presets {

/// What a preset can be asked for. A preset refuses (SceneError) what it does not use.
struct Parameters {
    std::optional<std::uint32_t> balls{};   ///< number of balls
    std::optional<double> packing{};        ///< fraction of the area that disks cover, (0, 0.6]
    std::optional<double> gap{};            ///< between neighbouring balls [m], >= 0
    std::optional<double> speed{};          ///< of what moves at the start, or the cue [m/s], > 0
    std::optional<double> restitution{};    ///< of every contact, in [0, 1]
    std::optional<std::uint32_t> digits{};  ///< digits of pi to count, 1 to 7
    std::optional<std::uint64_t> seed{};    ///< of everything drawn at random
};

struct Info {
    std::string_view name;         ///< e.g. "break"
    std::string_view description;  ///< one line
    std::string_view parameters;   ///< the parameters it takes with their defaults, one line
};

/// Every preset scene.
[[nodiscard]] std::span<const Info> list();

/// The preset scene of that name. Throws SceneError (with the nearest name) if there is none, or if
/// a parameter is out of range or not used. Same name and parameters: same bits everywhere.
[[nodiscard]] Scene make(std::string_view name, const Parameters& parameters = {});

/// The same scene as a short file (JSON, schema osculo/scene-1), if it is a table, a rack and a
/// strike: reading it gives what make() gives. Nothing for other presets.
[[nodiscard]] std::optional<std::string> short_text(std::string_view name,
                                                    const Parameters& parameters = {});

/// Adds the cushions, jaws and rims of a table to the scene ("pool-7ft", "pool-8ft", "pool-9ft",
/// "snooker-12ft", "carom-10ft"), marked closed. The origin is the corner of the nose lines at the
/// bottom left, the length is along y. Throws SceneError (with the nearest name) if there is no
/// such table.
void add_table(Scene& scene, std::string_view name);

/// Gives the scene the motion law and the impacts of the cloth, the balls and the cushions of a
/// table of that name.
void set_table_laws(Scene& scene, std::string_view name);

/// How balls are racked.
struct RackOptions {
    double gap = 1e-4;  ///< between neighbours [m], from 0 (frozen) to one radius
    /// If given, each ball among neighbours is displaced at random by less than half the gap.
    std::optional<std::uint64_t> seed{};
    friend bool operator==(const RackOptions&, const RackOptions&) = default;
};

/// Adds a rack of balls to the table that the scene already has: "eight-ball" ("1" to "15") and
/// "nine-ball" for pool tables, "snooker" ("red-1" to "red-15" and the colours) for the snooker
/// table, "three-cushion" ("red" and "yellow") for the carom table; each with the ball "cue" at its
/// place for the break, unless the scene has a ball of that name. Throws SceneError if there is no
/// such rack (with the nearest name), for the wrong table, or for a gap out of range.
void add_rack(Scene& scene, std::string_view name, const RackOptions& options = {});

}  // namespace osculo::presets

#pragma once

#include <string>
#include <variant>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"
#include "osculo/simulation.hpp"

namespace osculo::cli {

/// What the help says about arguments read by these functions.
inline constexpr const char* kSceneHelp = "scene file (.json, .msgpack), - or preset:NAME";

/// A file that ends so is MessagePack, any other JSON.
[[nodiscard]] bool is_msgpack(const std::string& path);

/// The scene of a file, of standard input ("-") or of a preset ("preset:NAME"), valid. Throws
/// Failure, whose message begins with the name.
[[nodiscard]] Scene load_scene(const std::string& name);

/// The same, or a snapshot of a simulation.
[[nodiscard]] std::variant<Scene, Simulation> load_scene_or_simulation(const std::string& name);

/// A scene or a run, from the same places.
[[nodiscard]] std::variant<Scene, Run> load_scene_or_run(const std::string& name);

/// Writes JSON to a file (as MessagePack if its name says so) or to standard output ("-"). Throws
/// Failure.
void save_json(const std::string& path, const std::string& json);

/// Writes text to a file or to standard output ("-"). Throws Failure.
void save_text(const std::string& path, const std::string& text);

}  // namespace osculo::cli

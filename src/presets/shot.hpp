#pragma once

#include <string>

#include "presets/tables.hpp"

namespace osculo::presets {

/// A scene that is a table, a rack and a strike, as level as can be, and nothing else.
struct Shot {
    std::string_view table;
    std::string_view rack;
    RackOptions options;
    Cue cue;
};

/// The scene: with the laws of its table.
[[nodiscard]] Scene scene_of(const Shot& shot);

/// The scene as a short file, which leaves out what are defaults.
[[nodiscard]] std::string text_of(const Shot& shot);

}  // namespace osculo::presets

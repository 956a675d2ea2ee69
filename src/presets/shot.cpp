#include "presets/shot.hpp"

#include "presets/parameters.hpp"

namespace osculo::presets {
namespace {

std::string rack_text(const Shot& shot) {
    const std::string name = '"' + std::string(shot.rack) + '"';
    const RackOptions& options = shot.options;
    if (options == RackOptions{}) return name;
    std::string text = "{\"name\": " + name;
    if (options.gap != RackOptions{}.gap) text += ", \"gap\": " + number_text(options.gap);
    if (options.seed) text += ", \"seed\": " + std::to_string(*options.seed);
    return text + '}';
}

std::string cue_text(const Cue& cue) {
    std::string text = "{\"speed\": " + number_text(cue.speed);
    text += ", \"azimuth\": " + number_text(cue.azimuth);
    if (cue.offset != Cue{}.offset) {
        text += ", \"offset\": [" + number_text(cue.offset[0]) + ", " + number_text(cue.offset[1]) +
                ']';
    }
    return text + '}';
}

}  // namespace

Scene scene_of(const Shot& shot) {
    Scene scene;
    add_table(scene, shot.table);
    set_table_laws(scene, shot.table);
    add_rack(scene, shot.rack, shot.options);
    scene.cue = shot.cue;
    scene.cue->elevation = least_elevation(scene).value_or(0);
    return scene;
}

std::string text_of(const Shot& shot) {
    return "{\n  \"schema\": \"osculo/scene-1\",\n  \"table\": \"" + std::string(shot.table) +
           "\",\n  \"rack\": " + rack_text(shot) + ",\n  \"cue\": " + cue_text(shot.cue) + "\n}\n";
}

}  // namespace osculo::presets

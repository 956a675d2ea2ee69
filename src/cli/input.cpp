#include "cli/input.hpp"

#include <optional>

#include "cli/failure.hpp"
#include "cli/files.hpp"
#include "osculo/io.hpp"
#include "osculo/presets.hpp"

namespace osculo::cli {
namespace {

// Runs read(); what it throws gets the name in front.
template <class Read>
auto named(const std::string& name, Read read) {
    try {
        return read();
    } catch (const SceneError& error) {
        throw Failure(kInvalidScene, name + ": " + error.what());
    } catch (const io::FormatError& error) {
        throw Failure(kInvalidScene, name + ": " + error.what());
    }
}

std::optional<Scene> preset(const std::string& name) {
    constexpr std::string_view kPrefix = "preset:";
    if (!name.starts_with(kPrefix)) return std::nullopt;
    return named(name,
                 [&] { return presets::make(std::string_view(name).substr(kPrefix.size())); });
}

std::string content_of(const std::string& name) {
    std::string content = read_file(name);
    if (content.empty()) throw Failure(kInvalidScene, name + ": is empty");
    return content;
}

Scene scene_of(const std::string& name, const std::string& content) {
    return named(name, [&] {
        return is_msgpack(name) ? io::scene_from_msgpack(content) : io::scene_from_json(content);
    });
}

}  // namespace

bool is_msgpack(const std::string& path) {
    return path.ends_with(".msgpack");
}

Scene load_scene(const std::string& name) {
    if (auto scene = preset(name)) return std::move(*scene);
    return scene_of(name, content_of(name));
}

std::variant<Scene, Simulation> load_scene_or_simulation(const std::string& name) {
    if (auto scene = preset(name)) return std::move(*scene);
    const std::string content = content_of(name);
    if (!io::is_snapshot(content)) return scene_of(name, content);
    return named(name, [&] { return io::simulation_from_snapshot(content); });
}

std::variant<Scene, Run> load_scene_or_run(const std::string& name) {
    if (auto scene = preset(name)) return std::move(*scene);
    const std::string content = content_of(name);
    return named(name, [&] {
        return is_msgpack(name) ? io::scene_or_run_from_msgpack(content)
                                : io::scene_or_run_from_json(content);
    });
}

void save_json(const std::string& path, const std::string& json) {
    save_text(path, is_msgpack(path) ? io::msgpack_from_json(json) : json);
}

void save_text(const std::string& path, const std::string& text) {
    if (path == kStandardStream) {
        write_output(text);
    } else {
        write_file(path, text);
    }
}

}  // namespace osculo::cli

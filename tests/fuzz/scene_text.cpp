// Fuzzes what reads files: any bytes are a scene, or a run, that is given back as it was written,
// or one of the two errors that readers throw. A mutator that knows JSON gets past the first
// bracket; small scenes are run.
#include <cstdint>
#include <string_view>
#include <variant>

#include "json_mutator.hpp"
#include "oracle.hpp"
#include "osculo/io.hpp"

namespace osculo::fuzz {
namespace {

void check_scene(const Scene& scene) {
    const std::string text = io::scene_to_json(scene);
    require(io::scene_from_json(text) == scene, "JSON does not give the scene back", scene);
    require(io::scene_from_msgpack(io::msgpack_from_json(text)) == scene,
            "MessagePack does not give the scene back", scene);
    if (scene.balls.size() <= 24 && scene.segments.size() + scene.arcs.size() <= 100) {
        check_run(scene);
    }
}

void check_text(std::string_view text) {
    try {
        const auto read = io::scene_or_run_from_json(text);
        if (const auto* scene = std::get_if<Scene>(&read)) {
            check_scene(*scene);
        } else {
            const Run& run = std::get<Run>(read);
            const std::string again = io::run_to_json(run);
            require(io::run_to_json(io::run_from_json(again)) == again,
                    "JSON does not give the run back", run.scene);
        }
    } catch (const io::FormatError&) {
    } catch (const SceneError&) {
    }
    try {
        static_cast<void>(io::scene_or_run_from_msgpack(text));
    } catch (const io::FormatError&) {
    } catch (const SceneError&) {
    }
}

}  // namespace
}  // namespace osculo::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    osculo::fuzz::check_text({reinterpret_cast<const char*>(data), size});
    return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::string mutated = osculo::fuzz::mutated_json(text, seed);
    if (mutated.empty() || mutated.size() > most) return LLVMFuzzerMutate(data, size, most);
    mutated.copy(reinterpret_cast<char*>(data), mutated.size());
    return mutated.size();
}

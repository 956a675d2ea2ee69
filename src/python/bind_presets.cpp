#include <pybind11/stl.h>

#include "osculo/presets.hpp"
#include "osculo/scene.hpp"
#include "python/bindings.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

Scene preset(const std::string& name, std::optional<std::uint32_t> balls,
             std::optional<double> packing, std::optional<double> gap, std::optional<double> speed,
             std::optional<double> restitution, std::optional<std::uint32_t> digits,
             std::optional<std::uint64_t> seed) {
    return presets::make(name, {balls, packing, gap, speed, restitution, digits, seed});
}

}  // namespace

void bind_presets(py::module_& module) {
    module.def("preset", preset, "name"_a, py::kw_only(), "balls"_a = py::none(),
               "packing"_a = py::none(), "gap"_a = py::none(), "speed"_a = py::none(),
               "restitution"_a = py::none(), "digits"_a = py::none(), "seed"_a = py::none(),
               R"(A preset scene; presets() lists them with the parameters that each takes.

balls: number of them. packing: fraction of the area that disks cover. gap: between neighbours [m].
speed: of what moves at the start, or of the cue [m/s]. restitution: of every contact. digits: of pi.
seed: of everything drawn at random. Raises SceneError.)");
    module.def(
        "presets",
        [] {
            py::dict list;
            for (const presets::Info& info : presets::list()) {
                list[py::cast(info.name)] =
                    std::string(info.description) + "; " + std::string(info.parameters);
            }
            return list;
        },
        "The names of the preset scenes, with what they are and their parameters.");
    module.def(
        "table",
        [](const std::string& name) {
            Scene scene;
            presets::add_table(scene, name);
            presets::set_table_laws(scene, name);
            return scene;
        },
        "name"_a,
        "A table without balls: \"pool-7ft\", \"pool-8ft\", \"pool-9ft\", \"snooker-12ft\" or "
        "\"carom-10ft\". Raises SceneError.");
}

}  // namespace osculo::python

#include "osculo/version.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_osculo, module) {
    module.doc() = "What of osculo is compiled; use it as `osculo`.";
    module.attr("__version__") = osculo::kVersion;
    // Runs need scenes, and what is simulated needs both: their types have to be known by then.
    osculo::python::bind_errors(module);
    osculo::python::bind_names(module);
    osculo::python::bind_scene(module);
    osculo::python::bind_presets(module);
    osculo::python::bind_run(module);
    osculo::python::bind_simulate(module);
    osculo::python::bind_simulation(module);
    osculo::python::bind_noise(module);
    osculo::python::bind_batch(module);
}

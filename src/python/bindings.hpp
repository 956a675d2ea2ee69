#pragma once

#include <pybind11/pybind11.h>

// Each puts one part of osculo into the module.
namespace osculo::python {

void bind_errors(pybind11::module_& module);
void bind_names(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_presets(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_simulate(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_noise(pybind11::module_& module);
void bind_batch(pybind11::module_& module);

}  // namespace osculo::python

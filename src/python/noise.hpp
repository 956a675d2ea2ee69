#pragma once

#include <pybind11/pybind11.h>

#include "osculo/noise.hpp"

namespace osculo::python {

/// The noise that a Python object says: a dict of standard deviations, or the magnitude of that of
/// the tournaments. Throws py::key_error for other members.
[[nodiscard]] CueNoise noise_from(const pybind11::object& noise);

}  // namespace osculo::python

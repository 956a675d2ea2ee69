#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "osculo/scene.hpp"

namespace osculo::python {

/// The scene that a Python object says: a mapping or a JSON text, its members replaced by those
/// given. Throws SceneError, io::FormatError.
[[nodiscard]] Scene scene_from(const pybind11::object& source, const pybind11::dict& members);

/// The Python object that a JSON text says.
[[nodiscard]] pybind11::object parsed(const std::string& json);

}  // namespace osculo::python

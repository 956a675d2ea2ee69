#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "osculo/batch.hpp"

namespace osculo::python {

/// The columns of the result as arrays over its memory, which lives as long as one of them.
[[nodiscard]] pybind11::dict columns_of(std::unique_ptr<BatchResult> result);

}  // namespace osculo::python

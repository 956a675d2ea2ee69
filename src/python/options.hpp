#pragma once

#include <string>

#include "osculo/simulate.hpp"

namespace osculo::python {

/// The precision of that name; throws std::invalid_argument.
[[nodiscard]] Precision precision_from(const std::string& name);

/// What to record, by its name; throws std::invalid_argument.
[[nodiscard]] Record record_from(const std::string& name);

[[nodiscard]] inline Options options_from(const std::string& precision, const std::string& record) {
    return {.precision = precision_from(precision), .record = record_from(record)};
}

}  // namespace osculo::python

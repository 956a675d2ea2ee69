#include <utility>

#include "osculo/scene.hpp"
#include "text.hpp"

namespace osculo {

SceneError::SceneError(std::string path, std::string rule, std::string value)
    : std::invalid_argument(
          facade::concatenated(path, ": ", rule, value.empty() ? "" : ", but it is ", value)),
      path_(std::move(path)),
      rule_(std::move(rule)),
      value_(std::move(value)) {}

}  // namespace osculo

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "osculo/presets.hpp"

namespace osculo::presets {

/// The shortest decimal number that reads back as `value`.
[[nodiscard]] std::string number_text(double value);

/// The parameter, or its default. Throws SceneError unless it is from `lowest` to `highest`.
template <class T>
[[nodiscard]] T in_range(std::string_view name, const std::optional<T>& parameter, T default_value,
                         T lowest, T highest) {
    const T value = parameter.value_or(default_value);
    if (value >= lowest && value <= highest) return value;
    const auto text = [](T bound) { return number_text(static_cast<double>(bound)); };
    throw SceneError(std::string(name), "must be from " + text(lowest) + " to " + text(highest),
                     text(value));
}

// The ranges that several presets share.

[[nodiscard]] inline double speed_of(const Parameters& parameters, double default_speed) {
    return in_range("speed", parameters.speed, default_speed, 1e-100, 1e100);
}

[[nodiscard]] inline Impacts impacts_of(const Parameters& parameters) {
    Impacts impacts;
    impacts.ball_ball.restitution = in_range("restitution", parameters.restitution, 1.0, 0.0, 1.0);
    impacts.ball_cushion.restitution = impacts.ball_ball.restitution;
    return impacts;
}

}  // namespace osculo::presets

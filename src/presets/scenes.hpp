#pragma once

#include "osculo/presets.hpp"

// The preset scenes, one file each. The parameters they do not take have been refused already.
namespace osculo::presets {

[[nodiscard]] Scene make_box(const Parameters& parameters);
[[nodiscard]] Scene make_carom(const Parameters& parameters);
[[nodiscard]] Scene make_cradle(const Parameters& parameters);
[[nodiscard]] Scene make_pi(const Parameters& parameters);
[[nodiscard]] Scene make_break(const Parameters& parameters);
[[nodiscard]] Scene make_gas(const Parameters& parameters);

}  // namespace osculo::presets

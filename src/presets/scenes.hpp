#pragma once

#include "osculo/presets.hpp"
#include "presets/shot.hpp"

// The preset scenes. The parameters they do not take have been refused already.
namespace osculo::presets {

[[nodiscard]] Scene make_box(const Parameters& parameters);
[[nodiscard]] Scene make_carom(const Parameters& parameters);
[[nodiscard]] Scene make_cradle(const Parameters& parameters);
[[nodiscard]] Scene make_pi(const Parameters& parameters);
[[nodiscard]] Scene make_frictionless_break(const Parameters& parameters);
[[nodiscard]] Scene make_gas(const Parameters& parameters);

[[nodiscard]] Scene make_stage_funnel(const Parameters& parameters);
[[nodiscard]] Scene make_stage_islands(const Parameters& parameters);
[[nodiscard]] Scene make_stage_bumpers(const Parameters& parameters);

[[nodiscard]] Shot break_shot(const Parameters& parameters);
[[nodiscard]] Shot nine_ball_shot(const Parameters& parameters);
[[nodiscard]] Shot snooker_break_shot(const Parameters& parameters);
[[nodiscard]] Shot three_cushion_shot(const Parameters& parameters);

}  // namespace osculo::presets

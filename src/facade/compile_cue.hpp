#pragma once

#include "osculo/impact/cue_strike.hpp"
#include "osculo/scene.hpp"

namespace osculo::facade {

/// Largest azimuth of a cue, in size [rad]: sin_cos() takes no more.
inline constexpr double kLargestAzimuth = 1e12;

/// The strike as the impact law takes it.
template <math::Scalar S>
[[nodiscard]] impact::CueStrike<S> compile_cue(const Cue& cue) {
    return {S(cue.speed), S(cue.azimuth),  S(cue.elevation),   S(cue.offset[0]),   S(cue.offset[1]),
            S(cue.mass),  S(cue.end_mass), S(cue.restitution), S(cue.miscue_limit)};
}

}  // namespace osculo::facade

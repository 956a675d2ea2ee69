#pragma once

#include <optional>
#include <string>

#include "osculo/scene.hpp"

namespace osculo::facade {

// The model of a cue stick: a straight rod of the radius kStickRadius and the length kStickLength,
// whose axis begins where the tip meets the ball, runs back against the azimuth and rises with the
// elevation. It may not come nearer than its radius to another ball, and where it passes over a
// segment or an arc its underside may not be lower than the nose of the cushion: rails are as high
// as noses, and no wider than a line. The nose is as high as the cushion's law says, or else 0.64
// diameters of the ball. Above a pocket nothing is in its way.

/// A tip of 13 mm [WPA equipment specifications: at most 14 mm], and the shaft as thick as the tip.
inline constexpr double kStickRadius = 0.0065;

/// 58 in, as most cues [WPA equipment specifications: at least 40 in].
inline constexpr double kStickLength = 1.4732;

/// What the stick of the scene's cue would pass through at that elevation: `segments[2] ("top")`.
/// Nothing if its way is free, or if the scene has no cue whose strike is otherwise possible.
[[nodiscard]] std::optional<std::string> find_obstruction(const Scene& scene, double elevation);

/// Whether there is such a thing; allocates nothing.
[[nodiscard]] bool is_obstructed(const Scene& scene, double elevation);

}  // namespace osculo::facade

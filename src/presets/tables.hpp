#pragma once

#include "osculo/presets.hpp"

// The tables and racks, one file each.
namespace osculo::presets {

/// Width (along x) and length (along y) of the bed between the noses of the cushions [m]; the
/// origin is the corner of the noses at the bottom left.
struct Bed {
    double width;
    double length;
};

inline constexpr Bed kPool7ft{0.9906, 1.9812};
inline constexpr Bed kCarom10ft{1.42, 2.84};

/// Ball of pool: 2 1/4 in and 6 oz [WPA equipment specification].
inline constexpr double kPoolBallRadius = 0.028575;
inline constexpr double kPoolBallMass = 0.170097;

/// Ball of carom: 61.5 mm and 210 g [UMB equipment rules: 61 to 61.5 mm, 205 to 220 g].
inline constexpr double kCaromBallRadius = 0.03075;
inline constexpr double kCaromBallMass = 0.21;

void add_pool_7ft(Scene& scene);
void add_carom_10ft(Scene& scene);

/// Fifteen balls in a triangle, the apex on the foot spot (three quarters of the length).
void add_eight_ball(Scene& scene, const Bed& bed, double gap);

/// Four one-sided segments, "bottom", "right", "top" and "left", that bound the rectangle from the
/// origin to (width, height).
void add_rectangle(Scene& scene, double width, double height);

}  // namespace osculo::presets

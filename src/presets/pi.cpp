#include "presets/parameters.hpp"
#include "presets/scenes.hpp"

namespace osculo::presets {

// A wall, a ball of 1 kg at rest, and one of 100^(digits - 1) kg moving towards them: the number of
// collisions of the small ball, with either, spells the digits [Galperin, Playing pool with pi,
// 2003]. In coordinates scaled by the square roots of the masses the two balls are one point that
// moves on a straight line through mirrored wedges of angle atan(10^-(digits - 1)); it crosses less
// than 3.2 * 10^(digits - 1) edges.
Scene make_pi(const Parameters& parameters) {
    const auto digits = in_range<std::uint32_t>("digits", parameters.digits, 3, 1, 7);
    const double speed = speed_of(parameters, 1);

    double mass_ratio = 1;
    std::uint64_t most_collisions = 4;
    for (std::uint32_t i = 1; i < digits; ++i) {
        mass_ratio *= 100;
        most_collisions *= 10;
    }

    Scene scene;
    Ball small;
    small.id = "small";
    small.mass = 1;
    small.radius = 0.03125;
    small.position = {0.5, 0};
    Ball big;
    big.id = "big";
    big.mass = mass_ratio;
    big.radius = 0.125;
    big.position = {1, 0};
    big.velocity = {-speed, 0};
    scene.balls = {small, big};
    scene.segments.push_back({"wall", {0, -0.25}, {0, 0.25}, Side::both});

    // The line passes the last edge after less than (gap of the big ball + gap of the small one *
    // tan(wedge) / tan(angle left in the last wedge)) / speed: 4 s at 1 m/s for up to seven digits,
    // of which the worst is 314 because the next digits of pi, 159, are so small.
    scene.limits.time = 8 / speed;
    scene.limits.events = most_collisions;
    return scene;
}

}  // namespace osculo::presets

#include <string>

#include "presets/parameters.hpp"
#include "presets/scenes.hpp"

namespace osculo::presets {

// Steel balls of 1 in, struck by the first one, which starts four diameters away.
Scene make_cradle(const Parameters& parameters) {
    constexpr double kRadius = 0.0127;
    constexpr double kMass = 0.067;  // of 7800 kg/m^3
    const auto balls = in_range<std::uint32_t>("balls", parameters.balls, 5, 3, 15);
    const double gap = in_range("gap", parameters.gap, 0.0, 0.0, 1.0);
    const double speed = speed_of(parameters, 1);
    const double run_up = 8 * kRadius;

    Scene scene;
    scene.impacts = impacts_of(parameters);
    for (std::uint32_t i = 0; i < balls; ++i) {
        Ball ball;
        ball.id = "ball-" + std::to_string(i + 1);
        ball.mass = kMass;
        ball.radius = kRadius;
        // Measured from the second ball, so that gaps far below a radius are not rounded away.
        ball.position = {i == 0 ? -run_up : (i - 1) * (2 * kRadius + gap), 0};
        scene.balls.push_back(ball);
    }
    scene.balls.front().velocity = {speed, 0};
    // Long enough for the impulse to pass through, and for the last ball to get clear.
    scene.limits.time = (2 * run_up + balls * gap) / speed;
    return scene;
}

}  // namespace osculo::presets

#include "forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "text.hpp"

namespace osculo::facade {
namespace {

constexpr double kWeakest = 1e-50;

/// What balls may reach by taking the energy of all others, spins counted with the radius [m/s].
double largest_speed(const Scene& scene) {
    double energy = 0;
    double lightest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : scene.balls) {
        double speed = std::hypot(ball.velocity.x, ball.velocity.y);
        for (const double w : ball.spin) speed += ball.radius * std::abs(w);
        if (scene.cue) speed = std::max(speed, 10 * std::abs(scene.cue->speed));
        energy += ball.mass * speed * speed;
        lightest = std::min(lightest, ball.mass);
    }
    return energy > 0 ? std::sqrt(energy / lightest) : 0;
}

/// The smallest deceleration that is not 0 [m/s^2], or infinity.
double weakest(const Scene& scene) {
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](double friction) {
        if (!(friction > 0 && scene.gravity > 0)) return;
        constexpr double kLeast = std::numeric_limits<double>::denorm_min();  // not 0 by underflow
        least = std::min(least, std::max(friction * scene.gravity, kLeast));
    };
    if (const auto* rolling = std::get_if<RollingMotion>(&scene.motion)) {
        consider(rolling->friction);
    } else if (const auto* cloth = std::get_if<ClothMotion>(&scene.motion)) {
        consider(cloth->sliding_friction);
        consider(cloth->rolling_friction);
        consider(cloth->spinning_friction);
    }
    return least;
}

}  // namespace

void validate_forces(const Scene& scene) {
    const double speed = largest_speed(scene);
    if (!(speed > 0)) return;
    double smallest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : scene.balls) smallest = std::min(smallest, ball.radius);
    const double force = weakest(scene);
    if (std::isinf(force)) return;
    // Division by division: neither the square nor the product may leave the range.
    if (force / speed * (smallest / speed) >= kWeakest) return;
    throw SceneError("motion",
                     concatenated("must slow balls down by nothing, or by at least 1e-50 v^2 / "
                                  "radius at the largest speed that they can reach, ",
                                  number_text(speed), " m/s"),
                     concatenated(number_text(force), " m/s^2"));
}

}  // namespace osculo::facade

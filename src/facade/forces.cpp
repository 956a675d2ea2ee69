#include "forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "smallest_radius.hpp"
#include "text.hpp"

namespace osculo::facade {
namespace {

constexpr double kWeakest = 1e-50;
/// [m/s^2]: contacts of curved paths are found from squares of these and products of those.
constexpr double kLeast = 1e-80;
constexpr double kMost = 1e80;

/// What balls may reach by taking the energy of all others, spins counted with the radius [m/s].
double largest_speed(const Scene& scene) {
    const auto speed_of = [&scene](const Ball& ball) {
        double speed = std::hypot(ball.velocity.x, ball.velocity.y);
        for (const double w : ball.spin) speed += ball.radius * std::abs(w);
        return scene.cue ? std::max(speed, 10 * std::abs(scene.cue->speed)) : speed;
    };
    double fastest = 0;
    for (const Ball& ball : scene.balls) fastest = std::max(fastest, speed_of(ball));
    if (!(fastest > 0)) return 0;
    double energy = 0;  // in units of its square
    double lightest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : scene.balls) {
        const double speed = speed_of(ball) / fastest;
        energy += ball.mass * speed * speed;
        lightest = std::min(lightest, ball.mass);
    }
    return fastest * std::sqrt(energy / lightest);
}

/// The smallest and the largest deceleration that is not 0 [m/s^2], or infinity and 0.
struct Range {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
};
Range decelerations(const Scene& scene) {
    Range range;
    const auto consider = [&](double friction) {
        if (!(friction > 0 && scene.gravity > 0)) return;
        constexpr double kLeastNumber = std::numeric_limits<double>::denorm_min();
        const double force =
            std::max(friction * scene.gravity, kLeastNumber);  // underflow is not 0
        range.least = std::min(range.least, force);
        range.most = std::max(range.most, force);
    };
    if (const auto* rolling = std::get_if<RollingMotion>(&scene.motion)) {
        consider(rolling->friction);
    } else if (const auto* cloth = std::get_if<ClothMotion>(&scene.motion)) {
        consider(cloth->sliding_friction);
        consider(cloth->rolling_friction);
        consider(cloth->spinning_friction);
    }
    return range;
}

}  // namespace

void validate_forces(const Scene& scene) {
    const double speed = largest_speed(scene);
    const auto [force, most] = decelerations(scene);
    if (!(speed > 0) || !(most > 0)) return;
    if (force < kLeast || most > kMost) {
        throw SceneError("motion",
                         "must slow balls down by nothing, or by 1e-80 to 1e80 m/s^2 (friction "
                         "times gravity)",
                         concatenated(number_text(force < kLeast ? force : most), " m/s^2"));
    }
    const double smallest = smallest_radius(scene);
    // Division by division: neither the square nor the product may leave the range.
    if (force / speed * (smallest / speed) >= kWeakest) return;
    throw SceneError("motion",
                     concatenated("must slow balls down by nothing, or by at least 1e-50 v^2 / "
                                  "radius at the largest speed that they can reach, ",
                                  number_text(speed), " m/s"),
                     concatenated(number_text(force), " m/s^2"));
}

}  // namespace osculo::facade

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "presets/parameters.hpp"
#include "presets/place_disks.hpp"
#include "presets/scenes.hpp"
#include "presets/tables.hpp"

namespace osculo::presets {
namespace {

// Sum of twelve uniform numbers less six: mean 0, variance 1, and close enough to the normal
// distribution for a start that collisions make exactly Maxwell's within a few per ball.
double roughly_normal(std::mt19937_64& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(random);
    return sum;
}

// Random velocities without total momentum, of the root mean square `speed`.
void set_velocities(std::vector<Ball>& balls, double speed, std::mt19937_64& random) {
    const auto count = static_cast<double>(balls.size());
    Point mean;
    for (Ball& ball : balls) {
        ball.velocity = {roughly_normal(random), roughly_normal(random)};
        mean.x += ball.velocity.x / count;
        mean.y += ball.velocity.y / count;
    }
    double mean_square = 0;
    for (Ball& ball : balls) {
        Point& v = ball.velocity;
        v = {v.x - mean.x, v.y - mean.y};
        mean_square += (v.x * v.x + v.y * v.y) / count;
    }
    const double scale = speed / std::sqrt(mean_square);
    for (Ball& ball : balls) {
        ball.velocity = {scale * ball.velocity.x, scale * ball.velocity.y};
    }
}

}  // namespace

Scene make_gas(const Parameters& parameters) {
    const auto count = in_range<std::uint32_t>("balls", parameters.balls, 100, 2, 10'000'000);
    const double packing = in_range("packing", parameters.packing, 0.3, 1e-6, 0.6);
    const double speed = speed_of(parameters, 1);
    const double radius = std::sqrt(packing / (count * std::numbers::pi));
    std::mt19937_64 random(parameters.seed.value_or(1));

    Scene scene;
    add_rectangle(scene, 1, 1);
    scene.closed = true;
    scene.impacts = impacts_of(parameters);
    const std::vector<Point> centers = place_disks(count, radius, random);
    if (centers.empty()) {
        throw SceneError("packing", "must leave room for " + std::to_string(count) + " balls",
                         number_text(packing));
    }
    scene.balls.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        scene.balls[i].id = "disk-" + std::to_string(i + 1);
        scene.balls[i].radius = radius;
        scene.balls[i].position = centers[i];
    }
    set_velocities(scene.balls, speed, random);

    // The time to cross twenty lattice cells: some tens of collisions per disk.
    scene.limits.time = 20 / (std::sqrt(count) * speed);
    scene.limits.events = std::max<std::uint64_t>(1'000'000, 100 * std::uint64_t{count});
    return scene;
}

}  // namespace osculo::presets

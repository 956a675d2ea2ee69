#include <string>

#include "presets/parameters.hpp"
#include "presets/place_disks.hpp"
#include "presets/scenes.hpp"
#include "presets/tables.hpp"

namespace osculo::presets {

Scene make_box(const Parameters& parameters) {
    constexpr double kRadius = 0.03;
    const auto balls = in_range<std::uint32_t>("balls", parameters.balls, 1, 1, 100);
    const double speed = speed_of(parameters, 1);
    std::mt19937_64 random(parameters.seed.value_or(2));

    Scene scene;
    add_rectangle(scene, 1, 1);
    scene.closed = true;
    scene.impacts = impacts_of(parameters);
    scene.limits.time = 20 / speed;
    for (const Point& center : place_disks(balls, kRadius, random)) {
        const Point direction = random_direction(random);
        Ball ball;
        ball.id = "ball-" + std::to_string(scene.balls.size() + 1);
        ball.radius = kRadius;
        ball.position = center;
        ball.velocity = {speed * direction.x, speed * direction.y};
        scene.balls.push_back(ball);
    }
    return scene;
}

}  // namespace osculo::presets

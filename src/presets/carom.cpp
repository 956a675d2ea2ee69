#include <cmath>

#include "presets/parameters.hpp"
#include "presets/scenes.hpp"
#include "presets/tables.hpp"

namespace osculo::presets {

// Balls near the opening position of carom: red on the foot spot, yellow on the head spot, white
// beside it [UMB rules], white moving so that it meets red, four cushions and yellow.
Scene make_carom(const Parameters& parameters) {
    Scene scene;
    add_table(scene, "carom-10ft");
    scene.impacts = impacts_of(parameters);

    const double speed = speed_of(parameters, 4);
    scene.limits.time = 16 / speed;  // the white ball could run the length of the table five times

    const auto add = [&scene](const char* id, Point position, Point velocity) {
        Ball ball;
        ball.id = id;
        ball.mass = kCaromBallMass;
        ball.radius = kCaromBallRadius;
        ball.position = position;
        ball.velocity = velocity;
        scene.balls.push_back(ball);
    };
    const double middle = kCarom10ft.width / 2;
    const double head = kCarom10ft.length / 4;
    add("white", {middle + 0.18, head}, {-0.092 * speed, std::sqrt(1 - 0.092 * 0.092) * speed});
    add("yellow", {middle, head}, {});
    add("red", {middle, 3 * head}, {});
    return scene;
}

}  // namespace osculo::presets

#include "presets/stage.hpp"

#include <numbers>
#include <vector>

namespace osculo::presets {
namespace {

void add_walls(Scene& scene, const std::string& name, const std::vector<Point>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        scene.segments.push_back({name + '-' + std::to_string(k + 1), corners[k],
                                  corners[(k + 1) % corners.size()], Side::left});
    }
}

}  // namespace

void add_room(Scene& scene, const std::string& name, std::initializer_list<Point> corners) {
    add_walls(scene, name, corners);
}

void add_island(Scene& scene, const std::string& name, std::initializer_list<Point> corners) {
    const std::vector<Point> clockwise(std::rbegin(corners), std::rend(corners));
    add_walls(scene, name, clockwise);
}

void add_post(Scene& scene, const std::string& id, Point center, double radius) {
    Arc arc;
    arc.id = id;
    arc.center = center;
    arc.radius = radius;
    scene.arcs.push_back(arc);
}

void add_hole(Scene& scene, const std::string& id, Point center, double radius) {
    scene.rims.push_back({id, center, radius, RimLaw::paper});
}

void add_ball(Scene& scene, const std::string& id, Point position, double radius, Point velocity) {
    constexpr double kDensity = 1700;
    Ball ball;
    ball.id = id;
    ball.radius = radius;
    ball.mass = kDensity * 4 / 3 * std::numbers::pi * radius * radius * radius;
    ball.position = position;
    ball.velocity = velocity;
    scene.balls.push_back(ball);
}

Scene stage(double restitution) {
    Scene scene;
    scene.motion = RollingMotion{0.02};  // a short carpet
    scene.impacts.ball_ball.restitution = restitution;
    scene.impacts.ball_cushion.restitution = restitution;
    scene.limits.time = 120;
    scene.closed = true;
    return scene;
}

}  // namespace osculo::presets

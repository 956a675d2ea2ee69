// Rows, pairs and triangles of balls with a gap between neighbours.

#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace osculo::bench::spacing {
namespace {

const double kRoot3 = std::sqrt(3.0);
constexpr double kTenDegrees = std::numbers::pi / 18;

void add(Scene& scene, Point position, Point velocity = {}) {
    Ball ball;
    ball.id = std::to_string(scene.balls.size());
    ball.position = position;
    ball.velocity = velocity;
    scene.balls.push_back(ball);
}

/// Without anything in it yet. Whatever still meets does so long before it ends.
Scene empty() {
    Scene scene;
    scene.limits = {1e6, 100'000};
    return scene;
}

Scene cradle(double gap, double e) {
    Scene scene = empty();
    scene.impacts.ball_ball.restitution = e;
    add(scene, {-6, 0}, {1, 0});
    const int count = e == 1 ? 4 : 2;
    for (int k = 0; k < count; ++k) add(scene, {k * (2 + gap), 0});
    return scene;
}
Scene elastic_cradle(double gap) {
    return cradle(gap, 1);
}
Scene lossy_cradle(double gap) {
    return cradle(gap, 0.9);
}

/// A ball that would touch two at once at the origin, if these touched.
Scene pair(double gap, double angle) {
    Scene scene = empty();
    const Point way{std::cos(angle), std::sin(angle)};
    add(scene, {-4 * way.x, -4 * way.y}, way);
    add(scene, {kRoot3, 1 + gap / 2});
    add(scene, {kRoot3, -1 - gap / 2});
    return scene;
}
Scene straight_pair(double gap) {
    return pair(gap, 0);
}
Scene oblique_pair(double gap) {
    return pair(gap, kTenDegrees);
}

/// The triangle of fifteen, its tip at the origin, hit [beside] the axis.
Scene rack(double gap, double beside) {
    Scene scene = empty();
    add(scene, {-6, beside}, {1, 0});
    const double pitch = 2 + gap;
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            add(scene, {row * pitch * kRoot3 / 2, (place - row / 2.0) * pitch});
        }
    }
    return scene;
}
Scene rack_on_the_axis(double gap) {
    return rack(gap, 0);
}
Scene rack_beside_the_axis(double gap) {
    return rack(gap, 0.3);
}

/// The ball on two touching ones: twice the impulses that would stop it at both, so these leave
/// along the lines of centres with (4 a - b) 4/15, a and b being its speeds along them.
std::vector<Point> after_pair(double angle) {
    const double upper = std::cos(std::numbers::pi / 6 - angle);
    const double lower = std::cos(std::numbers::pi / 6 + angle);
    const double first = (4 * upper - lower) * 4 / 15;
    const double second = (4 * lower - upper) * 4 / 15;
    const Point one{first * kRoot3 / 2, first / 2};
    const Point other{second * kRoot3 / 2, -second / 2};
    return {{std::cos(angle) - one.x - other.x, std::sin(angle) - one.y - other.y}, one, other};
}

}  // namespace

std::vector<Spaced> scenes() {
    return {
        {"cradle of 5", elastic_cradle, {{}, {}, {}, {}, {1, 0}}, true},
        {"cradle of 3, e = 0.9", lossy_cradle, {{1. / 30, 0}, {1. / 30, 0}, {14. / 15, 0}}},
        {"one ball on two, on the axis", straight_pair, after_pair(0)},
        {"one ball on two, 10 degrees off", oblique_pair, after_pair(kTenDegrees)},
        {"rack of 15, on the axis", rack_on_the_axis, {}},
        {"rack of 15, 0.3 radii off", rack_beside_the_axis, {}},
    };
}

}  // namespace osculo::bench::spacing

#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "osculo/scene.hpp"

namespace osculo::io::test {

/// A valid scene with numbers of all magnitudes: balls and obstacles far apart in a row, whose
/// distances double.
inline Scene random_scene(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto any = [&](double largest_exponent) {
        const double size = std::pow(10.0, (2 * uniform() - 1) * largest_exponent);
        return uniform() < 0.5 ? -size : size;
    };
    const auto maybe_zero = [&](double value) {
        const double choice = uniform();
        return choice < 0.1 ? 0.0 : choice < 0.2 ? -0.0 : value;
    };
    double place = 1;
    const auto next_place = [&] { return Point{place *= 4, maybe_zero(any(0))}; };

    Scene scene;
    scene.gravity = std::abs(any(3));
    const bool walled = uniform() < 0.5;  // by segments, which are not too long for the balls
    const auto count = [&] { return static_cast<int>(4 * uniform()); };
    for (int i = count(); i >= 0; --i) {
        Ball ball;
        ball.id = "ball \"" + std::to_string(i) + "\" \\ \xC3\xA9\n\x01";
        ball.mass = std::abs(any(99));
        const double decades = walled ? 1.5 : 49.5;
        ball.radius = std::abs(any(decades)) * std::pow(10.0, -decades);
        ball.position = next_place();
        ball.velocity = {maybe_zero(any(149)), maybe_zero(any(149))};
        ball.spin = {maybe_zero(any(20)), maybe_zero(0), maybe_zero(0)};
        // Its energy is a number, too.
        const double speed = 1 + std::hypot(ball.velocity.x, ball.velocity.y);
        ball.mass = std::min(ball.mass, 1e300 / speed / speed);
        scene.balls.push_back(ball);
    }
    for (int i = walled ? count() : 0; i > 0; --i) {
        scene.segments.push_back({"segment" + std::to_string(i), next_place(), next_place(),
                                  uniform() < 0.5 ? Side::left : Side::both});
    }
    for (int i = count(); i > 0; --i) {
        Arc arc{"arc" + std::to_string(i), next_place(), 0.5 * uniform() + 0.1};
        if (uniform() < 0.5) {
            arc.from_angle = any(1);
            arc.to_angle = arc.from_angle + 0.1 + 6 * uniform();
        }
        scene.arcs.push_back(arc);
    }
    for (int i = count(); i > 0; --i) {
        scene.rims.push_back({"rim" + std::to_string(i), next_place(), uniform() + 0.1});
    }
    scene.impacts.ball_ball.restitution = uniform();
    scene.impacts.ball_cushion.restitution = uniform();
    scene.limits = {std::abs(any(100)), random() | 1U};
    return scene;
}

}  // namespace osculo::io::test

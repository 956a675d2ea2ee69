#pragma once

#include "osculo/engine/scenes.hpp"
#include "support/random_tables.hpp"

/// Random tables of random_tables.hpp with balls that roll, or slide and spin on a cloth.
namespace osculo::support {

template <math::Scalar S>
using RollingTable = engine::RollingScene<S, engine::RollingPieces>;
template <math::Scalar S>
using ClothTable = engine::ClothScene<S, impact::CushionHan2005, engine::ClothPieces>;

[[nodiscard]] inline TableOptions curved_options() {
    TableOptions options;
    options.most_balls = 10;
    options.restitution = 0.9;
    return options;
}

template <math::Scalar S>
[[nodiscard]] engine::SceneData<RollingTable<S>> rolling_table(std::uint64_t seed) {
    auto scene = random_table<RollingTable<S>>(seed, curved_options()).scene;
    Random random(seed + 1'000'000);
    scene.motion.deceleration = S(random.magnitude<double>(-7, 2));
    scene.contact_time = S(1e-4);
    return scene;
}

/// Solid balls of the table's radii; some only roll, some spin hard.
template <math::Scalar S>
[[nodiscard]] engine::SceneData<ClothTable<S>> cloth_table(std::uint64_t seed) {
    auto scene = random_table<ClothTable<S>>(seed, curved_options()).scene;
    Random random(seed + 2'000'000);
    scene.motion = {S(random.magnitude<double>(-2, 3)), S(random.magnitude<double>(-7, 0)),
                    S(random.magnitude<double>(-7, 0))};
    scene.contact_time = S(1e-4);
    const auto some = [&](double least, double most, double often) {
        return S(random.below(4) == 0 ? often : random.uniform<double>(least, most));
    };
    scene.friction.ball_ball = {some(0.5, 1, 1), {some(0, 0.3, 0), S(0), S(0)}};
    S smallest(1);
    for (auto& body : scene.bodies) {
        body.state.radius = body.radius;
        smallest = std::min<S>(smallest, body.radius);
        const S speed = math::norm<S>(body.state.velocity);
        const math::Vec<S> v = body.state.velocity;
        switch (random.below(4)) {
            case 0: break;
            case 1: body.state.spin = {-v.y() / body.radius, v.x() / body.radius, S(0)}; break;
            case 2: body.state.spin = {S(0), S(0), S(random.uniform<double>(-100, 100))}; break;
            default:
                for (S& w : body.state.spin) {
                    w = speed / body.radius * S(random.uniform<double>(-3, 3));
                }
        }
    }
    scene.friction.ball_cushion = {some(0.5, 1, 1), some(0, 0.4, 0), smallest * some(0.8, 1.4, 1)};
    return scene;
}

}  // namespace osculo::support

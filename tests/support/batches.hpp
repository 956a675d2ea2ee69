#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "osculo/batch.hpp"
#include "support/scenes.hpp"

/// Scenes and shots for batches.
namespace osculo::test {

inline double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A cloth of 1 m x 2 m with holes in the corners, a post, the cue ball and [others] balls in rows
/// above it.
inline Scene pool_scene(int others) {
    constexpr double kRadius = 0.028575;
    Scene scene;
    add_box(scene, 1, 2);
    scene.arcs = {{"post", {0.3, 0.9}, 0.03}};
    scene.rims = {
        {"a", {0, 0}, 0.08}, {"b", {1, 0}, 0.08}, {"c", {0, 2}, 0.08}, {"d", {1, 2}, 0.08}};
    scene.motion = ClothMotion{};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.95, {0.06, 0, 0}};
    scene.impacts.ball_cushion = {CushionLaw::han_2005, 0.85, 0.2, 1.28 * kRadius};
    scene.balls.push_back(ball("cue", {0.5, 0.5}, {}, kRadius));
    for (int i = 0; i < others; ++i) {
        const double x = 0.25 + 0.15 * (i % 4) + 0.01 * (i / 4);
        scene.balls.push_back(
            ball("b" + std::to_string(i), {x, 1.1 + 0.12 * (i / 4)}, {}, kRadius));
    }
    for (Ball& ball : scene.balls) ball.mass = 0.17;
    return scene;
}

/// Strikes in all directions, some with an elevation of their own.
inline std::vector<Strike> random_strikes(std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Strike> strikes(count);
    for (Strike& strike : strikes) {
        strike.speed = 0.5 + 4 * uniform(random);
        strike.azimuth = 2 * std::numbers::pi * uniform(random);
        if (uniform(random) < 0.3) strike.elevation = 0.1 + 0.3 * uniform(random);
        strike.side = 0.6 * (uniform(random) - 0.5);
        strike.height = 0.6 * (uniform(random) - 0.5);
    }
    return strikes;
}

/// The same places, velocities and spins drawn at random, [shot][ball].
inline std::vector<BallState> random_states(const Scene& scene, std::size_t shots, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto centred = [&](double width) { return width * (uniform(random) - 0.5); };
    std::vector<BallState> states;
    for (std::size_t shot = 0; shot < shots; ++shot) {
        for (const Ball& ball : scene.balls) {
            const bool moves = uniform(random) < 0.4;
            states.push_back({{ball.position.x + centred(0.02), ball.position.y + centred(0.02)},
                              moves ? Point{centred(3), centred(3)} : Point{},
                              moves ? Spin{centred(50), centred(50), centred(50)} : Spin{}});
        }
    }
    return states;
}

/// Whether two results have the same bits in every column.
inline bool same_result(const BatchResult& a, const BatchResult& b) {
    const auto same_bits = [](const std::vector<double>& x, const std::vector<double>& y) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](double p, double q) {
            return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q);
        });
    };
    return a.shots == b.shots && a.balls == b.balls && a.status == b.status &&
           same_bits(a.time, b.time) && a.event_count == b.event_count &&
           a.cue_ball == b.cue_ball && a.first_hit == b.first_hit &&
           a.cushions_before_hit == b.cushions_before_hit &&
           a.cushions_after_hit == b.cushions_after_hit &&
           a.driven_to_cushion == b.driven_to_cushion && a.kisses == b.kisses &&
           a.settled_count == b.settled_count && a.fate == b.fate && a.position == b.position &&
           a.rim == b.rim && same_bits(a.capture_time, b.capture_time) &&
           a.ball_contacts == b.ball_contacts && a.cushion_contacts == b.cushion_contacts &&
           a.state == b.state && a.event_offsets == b.event_offsets && a.events == b.events &&
           a.piece_offsets == b.piece_offsets && a.pieces == b.pieces && a.points == b.points;
}

}  // namespace osculo::test

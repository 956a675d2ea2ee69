#include "workload.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "osculo/presets.hpp"
#include "presets/place_disks.hpp"
#include "presets/tables.hpp"

namespace osculo::bench {
namespace {

using presets::uniform;
using Random = std::mt19937_64;

constexpr double kRadius = 0.03;

double between(Random& random, double low, double high) {
    return low + (high - low) * uniform(random);
}

/// 10^-k for k from low to high, all magnitudes equally likely.
double small(Random& random, double low, double high) {
    return std::pow(10.0, -between(random, low, high));
}

double sign(Random& random) {
    return (random() & 1U) != 0 ? 1 : -1;
}

void add(Scene& scene, Point position, Point velocity, double radius = kRadius, double mass = 1) {
    std::string id = std::to_string(scene.balls.size());
    id.insert(0, 4 - id.size(), '0');  // sorted by name is sorted by number
    scene.balls.push_back({id, mass, radius, position, velocity, {}});
}

// All begin at a random distance: where a time step happens to end must not decide.

/// A ball flies against a thin wall 1 to 2 m away, and back: three metres in all.
Scene thin_wall(std::uint64_t seed, double speed) {
    Random random(seed);
    Scene scene;
    const double at = between(random, 1, 2);
    const double angle = between(random, -0.3, 0.3);
    scene.segments.push_back({"wall", {at, -5}, {at, 5}, Side::both});
    add(scene, {0, 0}, {speed * std::cos(angle), speed * std::sin(angle)});
    return scene;
}

/// Two balls that just touch, or just do not: impact parameter 1 -+ 10^-1 .. 10^-12 diameters.
Scene graze(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    const double beside = 2 * kRadius * (1 - sign(random) * small(random, 1, 12));
    add(scene, {-between(random, 0.4, 0.5), beside}, {1, 0});
    add(scene, {0, 0}, {0, 0});
    return scene;
}

/// A ball flies into the gap between two others, one of which is 10^-3 .. 10^-10 radii nearer:
/// which one is hit first decides everything.
Scene three_bodies(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    const double half = kRadius * between(random, 1.01, 1.5);
    add(scene, {-between(random, 0.4, 0.5), 0}, {1, 0});
    add(scene, {0, half}, {0, 0});
    add(scene, {sign(random) * kRadius * small(random, 3, 10), -half}, {0, 0});
    return scene;
}

/// Five balls in a row, 10^-2 .. 10^-10 radii apart, struck by the first.
Scene cradle(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    add(scene, {-kRadius * between(random, 7, 8), 0}, {1, 0});
    const double gap = kRadius * small(random, 2, 10);
    for (int i = 0; i < 4; ++i) add(scene, {i * (2 * kRadius + gap), 0}, {0, 0});
    return scene;
}

/// A ball of 1 kg between a wall and one of 1e6 kg that comes nearer: Galperin's billiard, in which
/// 3,141 collisions must happen.
Scene mass_ratio(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    scene.segments.push_back({"wall", {0, -1}, {0, 1}, Side::both});
    const double x = between(random, 0.1, 0.4);
    add(scene, {x, 0}, {0, 0});
    add(scene, {x + between(random, 0.1, 0.4), 0}, {-1, 0}, kRadius, 1e6);
    return scene;
}

/// Sixteen disks of 1 m/s in a box of 1 m.
Scene box(std::uint64_t seed, double) {
    return presets::make("box", {.balls = 16, .seed = seed});
}

/// A thousand disks that cover three tenths of the box.
Scene gas(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    presets::add_rectangle(scene, 1, 1);
    const double radius = std::sqrt(0.3 / (1000 * std::numbers::pi));
    for (const Point& at : presets::place_disks(1000, radius, random)) {
        const double vx = between(random, -1, 1);
        add(scene, at, {vx, between(random, -1, 1)}, radius);
    }
    return scene;
}

/// The break of fifteen balls 0.1 mm apart on a 7 ft table.
Scene rack(std::uint64_t seed, double speed) {
    Random random(seed);
    Scene scene;
    presets::add_table(scene, "pool-7ft");
    const double x = presets::kPool7ft.width / 2 + between(random, -0.004, 0.004);
    const double y = presets::kPool7ft.length / 4 - between(random, 0, 0.02);
    add(scene, {x, y}, {0, speed}, presets::kPoolBallRadius, presets::kPoolBallMass);
    presets::add_rack(scene, "eight-ball");
    std::erase_if(scene.balls, [](const Ball& ball) { return ball.id == "cue"; });  // has its own
    return scene;
}

Scene cloth_rack(std::uint64_t seed, double speed) {
    Scene scene = rack(seed, speed);
    presets::set_table_laws(scene, "pool-7ft");
    return scene;
}

/// A ball crosses the edge of a hole, or passes it, by 10^-1 .. 10^-6 of the hole's radius.
Scene rim(std::uint64_t seed, double) {
    Random random(seed);
    Scene scene;
    const double hole = 2 * kRadius;
    scene.rims.push_back({"hole", {between(random, 0.4, 0.6), 0}, hole});
    add(scene, {0, hole * (1 - sign(random) * small(random, 1, 6))}, {2, 0});
    return scene;
}

}  // namespace

const std::vector<Workload>& workloads() {
    // Where variants differ by orders of magnitude, all contenders must play many.
    constexpr double kPatient = 4;
    static const std::vector<Workload> all = [] {
        std::vector<Workload> list;
        for (const double speed : {1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
            list.push_back({.name = "thin wall, " + std::to_string(long(speed)) + " m/s",
                            .times = {3 / speed},
                            .make = thin_wall,
                            .parameter = speed});
        }
        list.push_back({.name = "graze", .times = {1}, .make = graze, .budget = kPatient});
        list.push_back(
            {.name = "three bodies", .times = {1}, .make = three_bodies, .budget = kPatient});
        list.push_back({.name = "cradle", .times = {0.5}, .make = cradle});
        list.push_back({.name = "mass ratio 1e6", .times = {1.5}, .make = mass_ratio});
        list.push_back({.name = "rim", .times = {0.5}, .make = rim, .budget = kPatient});
        list.push_back({.name = "16 disks", .times = {0.25, 0.5, 1, 2}, .make = box});
        list.push_back(
            {.name = "break", .times = {0.11, 0.15, 0.2, 0.4}, .make = rack, .parameter = 9});
        list.push_back({.name = "1,000 disks",
                        .times = {0.01, 0.03, 0.1},
                        .make = gas,
                        // A reference of 100 digits takes more than a second.
                        .variants = 20,
                        .quick_variants = 2});
        list.push_back({.name = "cloth break",
                        .times = {0.11, 0.2, 0.5, 2},
                        .make = cloth_rack,
                        .parameter = 9,
                        .cloth = true});
        return list;
    }();
    return all;
}

}  // namespace osculo::bench

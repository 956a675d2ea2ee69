// Two lines that meet at a small angle, in space or in the plane of two positions: the number of
// bounces is that of the angles that fit into a half turn.

#include <numbers>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

/// Ball 0 between a wall and ball 1, which comes with 1 m/s and [mass] times its mass. With lengths
/// scaled by the roots of the masses the pair is a point in a wedge of the angle atan(1 / root of
/// [mass]): it crosses every copy of the wedge within a half turn, and leaves as it is folded back.
Case galperin(int hundreds) {
    const long double root = std::pow(10.0L, hundreds);
    const long double angle = std::atan(1 / root);
    const auto count = std::ceil(kPi / angle) - 1;
    const bool odd = std::fmod(count, 2.0L) > 0;
    const long double left = odd ? (count + 1) * angle - kPi : kPi - count * angle;

    Case c;
    c.name = "pi, mass ratio 1e" + std::to_string(2 * hundreds);
    c.family = "wedges";
    c.stiff = "two balls and a wall: contacts accumulate at the wall, masses differ";
    c.scene.segments = {{"wall", {0, 9}, {0, -9}, Side::left}};
    c.scene.balls = {ball("light", 1, 0.5, {2, 0}),
                     ball("heavy", static_cast<double>(root * root), 0.5, {4, 0}, {-1, 0})};
    c.scene.limits = {1e9, 2'000'000'000};
    const auto scale = static_cast<double>(root);
    c.read = [scale](const Run& run) {
        return Values{static_cast<double>(run.event_count), run.balls[1].state.velocity.x,
                      run.balls[0].state.velocity.x / scale};
    };
    c.expected = {{static_cast<double>(count), static_cast<double>(std::cos(left)),
                   static_cast<double>(std::sin(left))}};
    c.source = "digits of pi";
    c.about = static_cast<double>(count);
    c.may_lose = 1 + std::log10(c.about);  // every bounce rounds
    c.audited = c.about < 1e5;
    c.full_only = hundreds > 6;
    return c;
}

/// The same in one instant: the light ball touches the wall.
Case galperin_at_once(int hundreds) {
    Case c = galperin(hundreds);
    c.name = "pi at one instant, mass ratio 1e" + std::to_string(2 * hundreds);
    c.stiff = "more blows in one instant than can be made one by one";
    c.scene.balls[0].position.x = 0.5;
    c.scene.limits = {10, 1000};
    const auto read = c.read;
    c.read = [read](const Run& run) {
        const Values values = read(run);
        return Values{values[1], values[2]};
    };
    c.expected[0].erase(c.expected[0].begin());
    c.about = 2;
    c.may_lose = 1 + hundreds;
    c.audited = true;
    c.full_only = false;
    c.only = Simultaneous::symmetric;
    return c;
}

/// A ball that comes in along one of two walls which meet at [angle].
Case wedge(double angle, const std::string& name) {
    const auto count = std::ceil(kPi / static_cast<long double>(angle)) - 1;
    Case c;
    c.name = "wedge of " + name;
    c.family = "wedges";
    c.stiff = "a ball between two walls that close up: ever shorter flights, then out again";
    const double far = 100 / angle;
    c.scene.segments = {
        {"floor", {0, 0}, {far, 0}, Side::left},
        {"lid", {far * std::cos(angle), far * std::sin(angle)}, {0, 0}, Side::left}};
    c.scene.balls = {ball("ball", 1, 1, {10 / angle, 2}, {-1, 0})};
    c.scene.limits = {50 / angle, 10'000'000};
    c.read = [](const Run& run) {
        const Point v = run.balls[0].state.velocity;
        return Values{static_cast<double>(run.event_count), std::hypot(v.x, v.y)};
    };
    c.expected = {{static_cast<double>(count), 1}};
    c.source = "angles in a half turn";
    c.about = static_cast<double>(count);
    c.may_lose = 1 + std::log10(c.about);
    return c;
}

Point reflected(Point v, Point n, double e) {
    const double out = (1 + e) * (v.x * n.x + v.y * n.y);
    return {v.x - out * n.x, v.y - out * n.y};
}

/// A ball that meets two walls at once which are mirror images of each other; their normals make
/// the angles [tilt] with its way. One after the other, the first wall first, until none is
/// approached.
Case both_walls(double tilt, double e, const std::string& name) {
    Case c;
    c.name = name + (e == 1 ? "" : ", e = 0.5");
    c.family = "wedges";
    c.stiff = "two walls at one instant";
    const Point n[] = {{std::cos(tilt), std::sin(tilt)}, {std::cos(tilt), -std::sin(tilt)}};
    const double far = 50;
    // Both from where they meet: mirror images to the last bit.
    c.scene.segments = {{"above", {0, 0}, {-far * n[0].y, far * n[0].x}, Side::both},
                        {"below", {0, 0}, {-far * n[0].y, -far * n[0].x}, Side::both}};
    c.scene.balls = {ball("ball", 1, 1, {-9, 0}, {1, 0})};
    c.scene.impacts.ball_cushion.restitution = e;
    c.scene.limits = {12, 1000};
    Point v{1, 0};
    for (int k = 0, idle = 0; idle < 2; ++k) {
        const Point& wall = n[k % 2];
        const bool approaches = v.x * wall.x + v.y * wall.y > 1e-9;
        if (approaches) v = reflected(v, wall, e);
        idle = approaches ? 0 : idle + 1;
    }
    c.read = read_velocities;
    c.expected = {{v.x, v.y}, {-e, 0}};
    c.may_lose = 1.5;
    return c;
}

}  // namespace

void add_wedges(Catalogue& all) {
    for (int hundreds = 0; hundreds <= 7; ++hundreds) all.push_back(galperin(hundreds));
    for (const int hundreds : {2, 4, 6, 7, 9}) all.push_back(galperin_at_once(hundreds));
    for (int k = 1; k <= 4; ++k) {
        all.push_back(wedge(std::pow(10.0, -k), "1e-" + std::to_string(k) + " rad"));
    }
    for (const double e : {1.0, 0.5}) {
        all.push_back(both_walls(std::numbers::pi / 3, e, "wedge of 60 degrees, both walls"));
        all.push_back(both_walls(std::numbers::pi / 4, e, "corner of 90 degrees, both walls"));
    }
}

}  // namespace osculo::bench::stability

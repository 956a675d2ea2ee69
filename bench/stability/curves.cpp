// Grazes, the inside of circles, corridors.

#include <numbers>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

/// A ball passes another one with 2 m + [beside] between the lines of their centres.
Case graze(double beside, double count, double flight, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "curves";
    c.stiff = "contact or none is decided by the last bit of a place";
    c.scene.balls = {ball("flies", 1, 1, {-flight, 2 + beside}, {1, 0}),
                     ball("waits", 1, 1, {0, 0})};
    c.scene.limits = {2 * flight, 100};
    c.read = read_count;
    c.expected = {{count}};
    c.source = "count";
    return c;
}

void add_grazes(Catalogue& all) {
    all.push_back(graze(-0x1p-52, 1, 10, "graze at 1 - 1e-16 of the reach"));
    all.push_back(graze(0, 0, 10, "tangent"));
    all.push_back(graze(0x1p-51, 0, 10, "passes at 1 + 2e-16 of the reach"));
    all.push_back(graze(-0x1p-52, 1, 1e6, "graze at 1 - 1e-16, from 1e6 m"));
    all.push_back(graze(0, 0, 1e6, "tangent, from 1e6 m"));

    // A graze at 1e-8 of the reach turns the ball by an angle that cancels to half of the digits.
    Case c = graze(-0x1p-26, 1, 10, "where a graze at 1e-8 goes");
    const double x = 0x1p-26;
    const double normal = std::sqrt(x - x * x / 4);  // cosine of the line of centres with the way
    const double s = 1 - x / 2;
    c.read = read_velocities;
    c.expected = {{1 - normal * normal, normal * s, normal * normal, -normal * s}};
    c.source = "closed form";
    c.may_lose = 1;
    all.push_back(c);
}

/// [scene] with an elastic circle of 10 m around a ball of 1 m.
Case in_circle(Point from, Point velocity, double time, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "curves";
    c.stiff = "inside of a full circle: every bounce starts in contact with what comes next";
    c.scene.arcs = {{"circle", {0, 0}, 10, 0, 2 * std::numbers::pi}};
    c.scene.balls = {ball("ball", 1, 1, from, velocity)};
    c.scene.limits = {time, 1'000'000};
    c.read = [](const Run& run) {
        const BallState& s = run.balls[0].state;
        return Values{static_cast<double>(run.event_count), s.position.x, s.position.y};
    };
    return c;
}

void add_circles(Catalogue& all) {
    Case square = in_circle({0, 0}, {1, 0}, 9 + 18 * 1000 + 9, "through the middle of a circle");
    square.expected = {{1001, 0, 0}};
    square.about = 1001;
    all.push_back(square);

    // From the middle of a chord that makes the angle a with the circle: chords of 18 sin(a).
    for (const double angle : {1e-2, 1e-3, 1e-5}) {
        const double chords = std::min(20'000.0, std::floor(100 / angle));
        char text[40];
        std::snprintf(text, sizeof text, "%g", angle);
        Case c = in_circle({0, -9 * std::cos(angle)}, {1, 0}, 18 * std::sin(angle) * chords,
                           std::string("along a circle, chords at ") + text + " rad");
        // Every bounce turns the middle of the chord by 2 a.
        const long double turn = 2 * static_cast<long double>(angle) * chords;
        c.expected = {{chords, static_cast<double>(9 * std::sin(turn) * std::cos(angle)),
                       static_cast<double>(-9 * std::cos(turn) * std::cos(angle))}};
        c.scale = 9;
        c.about = chords;
        // The start rounds the angle by eps / a^2 of itself, every bounce adds that up.
        c.may_lose = 1 + std::log10(chords * 1e-1 / angle);
        all.push_back(c);
    }
    Case lossy = in_circle({5, 0}, {0.3, 1}, 1000, "along a circle, e = 0.1");
    lossy.scene.impacts.ball_cushion.restitution = 0.1;
    lossy.stiff = "impacts accumulate: it ends up sliding along the circle, which is no event";
    lossy.statuses = {Status::zeno};
    lossy.status_only = true;
    lossy.most_events = 2000;
    all.push_back(lossy);
}

/// A ball between two walls with [room] to spare, across and along alike.
Case corridor(double room, double bounces, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "curves";
    c.stiff = "a corridor of 2000 m with next to no room";
    c.scene.segments = {{"floor", {-1000, 0}, {1000, 0}, Side::left},
                        {"lid", {1000, 2 + room}, {-1000, 2 + room}, Side::left}};
    c.scene.balls = {ball("ball", 1, 1, {0, 1}, {1, -1})};
    c.scene.limits = {1000, static_cast<std::uint64_t>(bounces)};
    c.statuses = {Status::event_limit};
    c.read = [](const Run& run) {
        const BallState& s = run.balls[0].state;
        return Values{s.position.x, s.position.y, s.velocity.x, s.velocity.y};
    };
    // The first bounce is at the start, every other one a passage later: the room is what the
    // doubles of the walls leave.
    const double passage = (2 + room) - 2;
    const bool at_floor = std::fmod(bounces, 2.0) > 0;
    c.expected = {{(bounces - 1) * passage, at_floor ? 1 : 1 + passage, 1, at_floor ? 1. : -1.}};
    c.about = bounces;
    if (room < 1e-13) c.only = Simultaneous::sequential;
    return c;
}

}  // namespace

void add_curves(Catalogue& all) {
    add_grazes(all);
    add_circles(all);
    for (const int digits : {3, 9, 12, 15}) {
        all.push_back(corridor(std::pow(10.0, -digits), 10'000,
                               "corridor with 1e-" + std::to_string(digits) + " m of room"));
    }
    Case jammed = corridor(1, 2, "corridor without any room, across");
    jammed.scene.segments[1] = {"lid", {1000, 2}, {-1000, 2}, Side::left};
    jammed.statuses = {Status::zeno, Status::time_limit};  // in turn; at once, it goes on along
    jammed.status_only = true;
    jammed.scene.limits = {1000, 100'000};
    jammed.most_events = 2000;
    all.push_back(jammed);
}

}  // namespace osculo::bench::stability

#pragma once

#include <cmath>
#include <vector>

#include "contender.hpp"
#include "cpu_clock.hpp"

/// What all contenders with time steps share: the loop over the steps, and the holes.
namespace osculo::bench {

/// A ball as a stepped engine tells of it.
struct Moving {
    double x = 0;
    double y = 0;
    double vx = 0;
    double vy = 0;
    double mass = 1;
    double radius = 1;
    bool present = true;
};

[[nodiscard]] inline std::vector<Moving> balls_of(const Scene& scene) {
    std::vector<Moving> balls;
    for (const Ball& ball : scene.balls) {
        balls.push_back({ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y,
                         ball.mass, ball.radius, true});
    }
    return balls;
}

[[nodiscard]] inline bool in_a_hole(const Scene& scene, double x, double y) {
    for (const Rim& rim : scene.rims) {
        const double dx = x - rim.center.x;
        const double dy = y - rim.center.y;
        if (dx * dx + dy * dy < rim.radius * rim.radius) return true;
    }
    return false;
}

inline void add_pair(std::vector<Contact>& contacts, double time, std::size_t i, std::size_t j) {
    contacts.push_back({time, static_cast<int>(i), static_cast<int>(j)});
    contacts.push_back({time, static_cast<int>(j), static_cast<int>(i)});
}

/// World: step(h), which dates the contacts of a step at its end, now + h; balls(), their states;
/// contacts, a list. Every instant that is asked for is the end of a step, so the steps may be a
/// little shorter than asked for.
template <class World>
[[nodiscard]] Trace step_through(World& world, const Task& task) {
    Trace trace;
    double now = 0;
    double taken = 0;
    for (const double time : task.times) {
        const double steps = std::max(1.0, std::ceil((time - now) / task.step - 1e-6));
        const double h = (time - now) / steps;
        const auto count = static_cast<long>(steps);
        const double start = cpu_now();
        for (long k = 0; k < count; ++k) {
            world.step(h);
            if (k % 256 == 255 && taken + cpu_now() - start > task.patience) {
                trace.contacts = std::move(world.contacts);
                return trace;
            }
        }
        taken += std::max(cpu_now() - start - clock_cost(), 1e-9);
        now = time;
        Snapshot snapshot;
        snapshot.cpu_seconds = taken;
        for (const Moving& ball : world.balls()) {
            snapshot.positions.push_back({Exact(ball.x), Exact(ball.y)});
            const Exact vx = ball.vx;
            const Exact vy = ball.vy;
            if (ball.present) snapshot.energy += ball.mass * (vx * vx + vy * vy) / 2;
        }
        trace.snapshots.push_back(std::move(snapshot));
    }
    trace.contacts = std::move(world.contacts);
    return trace;
}

}  // namespace osculo::bench

// Balls in a row: cradles, chains of masses, squeezes, the break of two.

#include <algorithm>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

/// [count] balls of radius 1 at rest with [gap] between, and one that comes with 1 m/s.
Scene row(int count, double gap, double e) {
    Scene scene;
    scene.impacts.ball_ball.restitution = e;
    scene.balls.push_back(ball("0", 1, 1, {-6, 0}, {1, 0}));
    for (int k = 0; k < count; ++k) {
        scene.balls.push_back(ball(std::to_string(k + 1), 1, 1, {k * (2 + gap), 0}));
    }
    scene.limits = {20 + gap * count, 100'000};
    return scene;
}

void add_cradles(Catalogue& all) {
    for (const double gap : {0.0, 1e-15, 1e-12, 1e-3}) {
        Case c;
        char text[40];
        std::snprintf(text, sizeof text, "%g", gap);
        c.name = std::string("cradle of 5, gaps ") + text;
        c.family = "rows";
        c.stiff = "gaps below the resolution of places: the order of contacts is everything";
        c.scene = row(4, gap, 1);
        c.read = [](const Run& run) {
            Values values = read_speeds(run);
            values.push_back(static_cast<double>(run.event_count));
            return values;
        };
        c.expected = {{0, 0, 0, 0, 1, 4}};
        all.push_back(c);
    }
    // One after the other, until none approaches; all at once: (1 - e) inelastic + e elastic.
    struct Loss {
        double e;
        Values sequential, symmetric;
    };
    const Loss losses[] = {{0.9, {0.047625, 0.049875, 0.9025}, {1. / 30, 1. / 30, 14. / 15}},
                           {0.5, {13. / 64, 15. / 64, 36. / 64}, {1. / 6, 1. / 6, 2. / 3}}};
    for (const Loss& loss : losses) {
        for (const double gap : {0.0, 1e-12}) {
            Case c;
            c.name = std::string("cradle of 3, e = ") + (loss.e == 0.9 ? "0.9" : "0.5") +
                     (gap > 0 ? ", gap 1e-12" : "");
            c.family = "rows";
            c.stiff = "a few impacts within 1e-12 s; the first ball catches up";
            c.scene = row(2, gap, loss.e);
            c.read = read_speeds;
            c.expected = {loss.sequential};
            if (gap == 0) c.expected.push_back(loss.symmetric);
            all.push_back(c);
        }
    }
    for (const int count : {5, 10, 20}) {
        Case c;
        c.name = "row of " + std::to_string(count) + ", e = 0.9, gaps 0.1";
        c.family = "rows";
        c.stiff = "inelastic row, every ball meets its neighbours again and again";
        c.scene = row(count - 1, 0.1, 0.9);
        c.read = read_speeds;
        all.push_back(c);
    }
}

/// Masses in geometric progression, each ball at rest until the one before it comes. The speed of
/// the push after k balls is (2 / (1 + q))^k, and ball k keeps (1 - q) / (1 + q) of its own.
Case chain(int balls, double q, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "rows";
    c.stiff = "masses over fifteen powers of ten in one row";
    Values speeds;
    long double push = 1;
    long double mass = 1;
    for (int k = 0; k < balls; ++k) {
        c.scene.balls.push_back(ball(std::to_string(k), static_cast<double>(mass), 1, {3.0 * k, 0},
                                     {k == 0 ? 1. : 0., 0}));
        const long double next = k + 1 < balls ? static_cast<long double>(q) : 0.0L;
        speeds.push_back(
            static_cast<double>(k + 1 < balls ? push * (1 - next) / (1 + next) : push));
        push *= 2 / (1 + next);
        mass *= static_cast<long double>(q);
    }
    c.scene.limits = {q < 1 ? 40. : 1e13, 1000};
    c.read = read_speeds;
    c.expected = {speeds};
    c.scale = 0;
    c.may_lose = 2;
    return c;
}

Case named(std::string name, std::string stiff) {
    Case c;
    c.name = std::move(name);
    c.family = "rows";
    c.stiff = std::move(stiff);
    c.scene.limits = {10, 10'000};
    c.read = read_velocities;
    return c;
}

void add_simultaneous(Catalogue& all) {
    Case squeeze = named("two balls squeeze a third", "two contacts of one ball at one instant");
    squeeze.scene.balls = {ball("left", 1, 1, {-5, 0}, {1, 0}), ball("middle", 1, 1, {0, 0}),
                           ball("right", 1, 1, {5, 0}, {-1, 0})};
    squeeze.expected = {{-1, 0, 0, 0, 1, 0}};
    all.push_back(squeeze);

    Case frozen = named("ball on a ball frozen to a wall", "the push goes to the wall and back");
    frozen.scene.segments = {{"wall", {1, -9}, {1, 9}, Side::both}};
    frozen.scene.balls = {ball("frozen", 1, 1, {0, 0}), ball("thrown", 1, 1, {-5, 0}, {1, 0})};
    frozen.expected = {{0, 0, -1, 0}};
    all.push_back(frozen);

    // Which of the two comes first decides (the wedge angle is 104.5 degrees, not 180 / n).
    const double r3 = std::sqrt(3.0);
    Case two = named("one ball on two that touch", "two contacts at one instant, no unique answer");
    two.scene.balls = {ball("cue", 1, 1, {-5, 0}, {1, 0}), ball("one", 1, 1, {0, 1}),
                       ball("two", 1, 1, {0, -1})};
    two.expected = {{-0.125, -r3 / 8, 0.75, r3 / 4, 0.375, -r3 / 8},
                    {-0.2, 0, 0.6, r3 / 5, 0.6, -r3 / 5}};
    all.push_back(two);

    Case chain = named("masses 1, 2, 3 touching", "unequal masses frozen in a row");
    chain.scene.balls = {ball("0", 1, 1, {-5, 0}, {1, 0}), ball("1", 2, 1, {0, 0}),
                         ball("2", 3, 1, {2, 0})};
    chain.read = read_speeds;
    chain.expected = {{-1. / 3, -2. / 15, 8. / 15}};
    all.push_back(chain);
}

}  // namespace

void add_impacts(Catalogue& all) {
    add_cradles(all);
    all.push_back(chain(16, 0.1, "masses 1, 0.1, .. 1e-15"));
    all.push_back(chain(16, 10, "masses 1, 10, .. 1e15"));

    Case pair = named("mass ratio 1e15", "the heavy ball's change is at the last bit");
    pair.scene.balls = {ball("heavy", 1e15, 1, {0, 0}, {1, 0}), ball("light", 1, 1, {5, 0})};
    pair.read = read_speeds;
    pair.expected = {
        {static_cast<double>((1 - 1e-15L) / (1 + 1e-15L)), static_cast<double>(2 / (1 + 1e-15L))}};
    all.push_back(pair);

    Case trapped = named("mass ratio 1e15, trapped at a wall", "1000 bounces between them");
    trapped.scene.segments = {{"wall", {0, 9}, {0, -9}, Side::left}};
    trapped.scene.balls = {ball("light", 1, 0.5, {1, 0}),
                           ball("heavy", 1e15, 0.5, {4, 0}, {-1, 0})};
    trapped.scene.limits = {1e3, 1000};
    trapped.statuses = {Status::event_limit};
    trapped.read = read_speeds;
    // 500 times each: turned by 2 theta each time, in the metric of the masses.
    const long double theta = std::atan(std::sqrt(1e-15L));
    trapped.expected = {{static_cast<double>(std::sin(1000 * theta) / std::tan(theta)),
                         static_cast<double>(-std::cos(1000 * theta))}};
    trapped.may_lose = 2.5;
    trapped.scale = 0;
    trapped.about = 1000;
    all.push_back(trapped);
    add_simultaneous(all);
}

}  // namespace osculo::bench::stability

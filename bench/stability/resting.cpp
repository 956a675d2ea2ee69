// Balls at rest in contact, and balls that their spin or another ball presses against something.

#include "case.hpp"
#include "osculo/presets.hpp"

namespace osculo::bench::stability {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;

/// Pool balls on cloth; cushions by Han.
Scene cloth() {
    Scene scene;
    scene.motion = ClothMotion{0.2, 0.01, 4.0 / 9 * kRadius};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.95, {0.05, 0, 0}};
    scene.impacts.ball_cushion.law = CushionLaw::han_2005;
    scene.impacts.ball_cushion.restitution = 0.85;
    scene.impacts.ball_cushion.friction = 0.2;
    scene.impacts.ball_cushion.height = 1.28 * kRadius;
    scene.limits = {600, 100'000};
    return scene;
}

Ball pool(std::string id, Point position, Point velocity = {}) {
    return ball(std::move(id), kMass, kRadius, position, velocity);
}

Case named(std::string name, std::string stiff) {
    Case c;
    c.name = std::move(name);
    c.family = "resting";
    c.stiff = std::move(stiff);
    c.scene = cloth();
    c.statuses = {Status::at_rest};
    c.most_events = 20'000;
    c.about = 1000;
    return c;
}

/// Balls at rest that touch each other and a rail stay, while another one passes by.
Case stays() {
    Case c =
        named("a frozen row and a rail, another ball passes", "resting contacts are no events");
    c.scene.segments = {{"rail", {-5, 0}, {5, 0}, Side::left}};
    for (int k = 0; k < 10; ++k) {
        c.scene.balls.push_back(pool(std::to_string(k), {k * 2 * kRadius, kRadius}));
    }
    c.scene.balls.push_back(pool("passes", {-1, 0.5}, {1, 0}));
    c.read = [](const Run& run) {
        double contacts = 0, moved = 0;
        for (const Event& event : run.events) contacts += event.kind != EventKind::transition;
        for (std::size_t k = 0; k < 10; ++k) {
            moved += run.balls[k].state.position == run.scene.balls[k].position ? 0 : 1;
        }
        return Values{contacts, moved};
    };
    c.expected = {{0, 0}};
    c.source = "nothing happens";
    return c;
}

/// Pressed against a rail by its own spin, it stays there until the spin is spent. Without
/// friction at the rail that takes the time 2 r w / (5 mu g).
Case pressed(double e) {
    char text[20];
    std::snprintf(text, sizeof text, "%g", e);
    Case c = named(std::string("pressed to a rail by its spin, e = ") + text,
                   "infinitely many bounces in finite time, but for the contact time of 1e-4 s");
    c.scene.impacts.ball_cushion = {};
    c.scene.impacts.ball_cushion.restitution = e;
    c.scene.segments = {{"rail", {-5, 0}, {5, 0}, Side::left}};
    c.scene.balls = {pool("ball", {0, kRadius})};
    c.scene.balls[0].spin = {40, 0, 0};
    c.read = [](const Run& run) {
        double still_in = 0;  // when it last slid
        for (const Event& event : run.events) {
            if (event.kind == EventKind::transition && event.from == Phase::sliding)
                still_in = event.time;
        }
        return Values{run.balls[0].state.position.y / kRadius, still_in};
    };
    c.expected = {{1, 2 * kRadius * 40 / (5 * 0.2 * 9.81)}};
    c.source = "the limit of no hops";
    c.enough = 3;
    return c;
}

/// A rolling ball meets one frozen to another, straight: it follows through and pushes.
Case follow_through(double spacing) {
    char text[20];
    std::snprintf(text, sizeof text, "%g", spacing);
    Case c = named(std::string("follow-through behind frozen balls, gap ") + text,
                   "its topspin presses the ball against those that it has just met");
    c.scene.balls = {pool("cue", {-0.3, 0}, {2, 0}), pool("1", {0, 0}),
                     pool("2", {2 * kRadius + spacing, 0})};
    c.scene.balls[0].spin = {0, 2 / kRadius, 0};
    c.status_only = true;
    return c;
}

Case frozen_to_rail(double e) {
    char text[20];
    std::snprintf(text, sizeof text, "%g", e);
    Case c = named(std::string("hit while frozen to a rail, e = ") + text,
                   "squeezed between a ball and a rail");
    c.scene.impacts.ball_ball.restitution = e;
    c.scene.segments = {{"rail", {-5, 0}, {5, 0}, Side::left}};
    c.scene.balls = {pool("frozen", {0, kRadius}), pool("cue", {0.01, 0.5}, {0, -3})};
    c.status_only = true;
    return c;
}

Case rack(double gap) {
    char text[20];
    std::snprintf(text, sizeof text, "%g", gap);
    Case c =
        named(std::string("break of a rack with gaps ") + text, "15 balls, 30 contacts at once");
    c.scene = presets::make("break", {.gap = gap});
    c.status_only = true;
    c.about = 2000;
    return c;
}

}  // namespace

void add_resting(Catalogue& all) {
    all.push_back(stays());
    for (const double e : {0.0, 1e-6, 1e-3, 0.5}) all.push_back(pressed(e));
    for (const double gap : {0.0, 1e-12, 1e-6}) all.push_back(follow_through(gap));
    for (const double e : {0.0, 1e-3, 0.95}) all.push_back(frozen_to_rail(e));
    for (const double gap : {0.0, 1e-12, 1e-6}) all.push_back(rack(gap));
}

}  // namespace osculo::bench::stability

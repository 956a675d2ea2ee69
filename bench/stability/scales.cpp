// Far away, late, very fast and very slow, very large and very small.

#include <algorithm>
#include <random>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

Case named(std::string name, std::string stiff) {
    Case c;
    c.name = std::move(name);
    c.family = "scales";
    c.stiff = std::move(stiff);
    c.read = read_velocities;
    return c;
}

/// Nine disks in a box, at multiples of 2^-20 m, whose corner is at [corner].
Scene disks_at(Point corner) {
    std::mt19937_64 random(4);
    const auto grid = [&](double reach) {
        const auto steps = static_cast<double>(random() % 2048) - 1024;
        return std::floor(steps * 1024 * reach) * 0x1p-20;
    };
    Scene scene;
    add_box(scene, corner.x, corner.y, corner.x + 8, corner.y + 8);
    for (int k = 0; k < 9; ++k) {
        const Point p{corner.x + 1.25 + 2.5 * (k % 3) + grid(0.2),
                      corner.y + 1.25 + 2.5 * (k / 3) + grid(0.2)};
        const double vx = grid(1);
        scene.balls.push_back(ball(std::to_string(k), 1, 0.5, p, {vx, grid(1)}));
    }
    scene.limits = {1e9, 40};
    return scene;
}

Case far_away() {
    Case c = named("9 disks 1e9 m from the origin", "an ulp of the places is 1e-7 m; 40 contacts");
    c.scene = disks_at({1e9, -1e9});
    c.reference = disks_at({0, 0});
    c.source = "100 digits, at the origin";
    c.statuses = {Status::event_limit};
    return c;
}

/// Bounces between two walls with [room] for 1e15 s.
Case late(double speed, double room, const std::string& name) {
    Case c = named(name, "1e15 s, where an ulp of time is 0.125 s");
    c.scene.segments = {{"left", {-1, 9}, {-1, -9}, Side::left},
                        {"right", {room + 1, -9}, {room + 1, 9}, Side::left}};
    c.scene.balls = {ball("ball", 1, 1, {0, 0}, {speed, 0})};
    c.scene.limits = {1e15, 10'000'000};
    c.read = [](const Run& run) {
        return Values{static_cast<double>(run.event_count), run.balls[0].state.position.x,
                      run.balls[0].state.velocity.x};
    };
    c.about = 1e15 * speed / room;
    return c;
}

void add_late(Catalogue& all) {
    Case exact = late(0x1p-30, 6, "one ball bounces for 1e15 s");
    {  // 931322.57.. m there and back: the rest is exact in double
        const double way = 1e15 * 0x1p-30;
        const double passages = std::floor(way / 6);
        const double rest = std::fmod(way, 6.0);
        const bool back = std::fmod(passages, 2.0) > 0;
        exact.expected = {{passages, back ? 6 - rest : rest, back ? -0x1p-30 : 0x1p-30}};
        exact.audited = false;
        all.push_back(exact);
    }
    Case odd = late(1e-9 / 3, 6, "the same with 1e-9 / 3 m/s");
    odd.may_lose = 6;  // an ulp of the speed is 4e-11 m after 1e15 s
    odd.source = "100 digits";
    odd.audited = false;
    all.push_back(odd);

    Case meet = named("a contact 1e15 s and 1e9 m away", "late and far at once, off centre");
    meet.scene.balls = {ball("comes", 1, 1, {-1e9, 1}, {0x1p-20, 0}), ball("waits", 1, 1, {0, 0})};
    meet.scene.limits = {1.1e15, 100};
    meet.expected = {{0x1p-20 * 0.25, 0x1p-20 * std::sqrt(3.0) / 4, 0x1p-20 * 0.75,
                      -0x1p-20 * std::sqrt(3.0) / 4}};
    meet.scale = 0x1p-20;
    meet.may_lose = 9;  // 1e9 m of way against 1 m of radius
    all.push_back(meet);
}

void add_sizes(Catalogue& all) {
    // A mote of 1 um meets a ball of 1000 km, half of its reach beside the middle.
    Case mote = named("radius ratio 1e12", "1e-6 m meets 1e6 m, far off centre");
    mote.scene.balls = {ball("mote", 1, 1e-6, {-5, 0.5e6}, {1, 0}),
                        ball("ball", 1e12, 1e6, {1e6, 0})};
    mote.scene.limits = {2e6, 100};
    {
        const long double s = 0.5e6L / (1e6L + 1e-6L), normal = std::sqrt(1 - s * s);
        const long double push = 2 * normal / (1 + 1e12L);  // to the ball, along the normal
        mote.expected = {{static_cast<double>(1 - push * 1e12L * normal),
                          static_cast<double>(push * 1e12L * s), static_cast<double>(push * normal),
                          static_cast<double>(-push * s)}};
    }
    all.push_back(mote);

    Case between =
        named("radius ratio 1e12, between a ball and a wall", "1e-6 m in a gap of 1e-5 m");
    between.scene.balls = {ball("mote", 1e-12, 1e-6, {5e-6, 0}, {1, 0}),
                           ball("ball", 1e6, 1e6, {1e6 + 1e-5, 0})};
    between.scene.segments = {{"wall", {0, 9}, {0, -9}, Side::left}};
    between.scene.limits = {1, 100};
    between.statuses = {Status::event_limit};
    between.read = read_speeds;
    // Its double has 2^-33 m for the place of the ball: the gap is what that leaves.
    all.push_back(between);

    for (const int exponent : {-100, 99}) {
        Case c = named("everything 1e" + std::to_string(exponent) + " m",
                       "squares leave the range of double unless scaled");
        const double unit = std::pow(10.0, exponent);
        c.scene.balls = {ball("comes", 1, unit, {-5 * unit, unit}, {1, 0}),
                         ball("waits", 1, unit, {0, 0})};
        c.scene.limits = {10 * unit, 100};
        c.expected = {{0.25, std::sqrt(3.0) / 4, 0.75, -std::sqrt(3.0) / 4}};
        all.push_back(c);
    }
}

void add_speeds(Catalogue& all) {
    const double r3 = std::sqrt(3.0);
    Case c = named("1e-150 and 1e150 m/s in one scene", "speeds over 300 powers of ten");
    c.scene.balls = {ball("fast", 1, 1, {-5, 101}, {1e150, 0}), ball("waits", 1, 1, {0, 100}),
                     ball("slow", 1, 1, {0, 0}, {1e-150, 0}), ball("touches", 1, 1, {2, 0})};
    c.scene.limits = {1e-148, 100};
    c.expected = {{0.25e150, r3 / 4 * 1e150, 0.75e150, -r3 / 4 * 1e150, 0, 0, 1e-150, 0}};
    c.scale = 0;
    all.push_back(c);

    Case both = named("1e150 m/s meets 1e-150 m/s", "the slow one's speed is below every rounding");
    both.scene.balls = {ball("fast", 1, 1, {-5, 0}, {1e150, 0}),
                        ball("slow", 1, 1, {0, 0}, {1e-150, 0})};
    both.scene.limits = {1e-148, 100};
    both.read = read_speeds;
    both.expected = {{0, 1e150}};
    both.scale = 1e150;
    all.push_back(both);

    Case thin = named("1e150 m/s at a wall", "a step would pass through it");
    thin.scene.segments = {{"wall", {10, -9}, {10, 9}, Side::both}};
    thin.scene.balls = {ball("fast", 1, 1e-3, {0, 0}, {1e150, 0})};
    thin.scene.limits = {2e-149, 100};
    thin.read = read_positions;
    // There and back: 2 (10 - 1e-3) - 20 m.
    thin.expected = {{-2e-3, 0}};
    thin.may_lose = 2;  // of 20 m
    thin.scale = 1;
    all.push_back(thin);

    Case beyond = named("a ball 1e30 m away, 1e-9 m small", "no double resolves where it is");
    beyond.scene.balls = {ball("one", 1, 1e-9, {1e30, 0}, {1, 0}),
                          ball("other", 1, 1e-9, {3e30, 1e-9}, {-1, 0})};
    beyond.scene.limits = {1e31, 100};
    beyond.status_only = true;
    beyond.audited = false;
    beyond.statuses = {Status::numeric, Status::time_limit};
    all.push_back(beyond);
}

}  // namespace

void add_scales(Catalogue& all) {
    all.push_back(far_away());
    add_late(all);
    add_sizes(all);
    add_speeds(all);
}

}  // namespace osculo::bench::stability

// Members of the catalogue at random: the same for the same seed everywhere.

#include <algorithm>
#include <numbers>
#include <random>

#include "case.hpp"
#include "osculo/presets.hpp"

namespace osculo::bench::stability {
namespace {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    /// In [0, 1).
    double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    /// 10 to a power between low and high, evenly.
    double magnitude(double low, double high) { return std::pow(10.0, between(low, high)); }

private:
    std::mt19937_64 random_;
};

/// An elastic row of any masses, radii and gaps, one ball thrown.
Case row(Dice& dice) {
    Case c;
    c.stiff = "a row of any masses (1e-3 .. 1e3), radii (1e-3 .. 1e3), gaps (1e-12 .. 1)";
    const int count = 3 + dice.below(6);
    double x = 0;
    for (int k = 0; k < count; ++k) {
        const double r = dice.magnitude(-3, 3);
        if (k > 0) {
            const double gap = k == 1 ? 1 : dice.magnitude(-12, 0);
            if (gap < 1e-13 * (x + r)) c.only = Simultaneous::sequential;
            x += r + gap;
        }
        c.scene.balls.push_back(ball(std::to_string(k), dice.magnitude(-3, 3), r, {x, 0}));
        x += r;
    }
    c.scene.balls[0].velocity.x = 1;
    c.scene.limits = {1e3, 100'000};
    c.about = 1000;
    c.read = read_speeds;
    return c;
}

/// Two balls that all but miss each other, anywhere, at any speed.
Case graze(Dice& dice) {
    Case c;
    c.stiff = "two balls that all but miss (1e-14 .. 1e-2), at any speed (1e-9 .. 1e9)";
    const double r1 = dice.magnitude(-3, 3), r2 = dice.magnitude(-3, 3),
                 speed = dice.magnitude(-9, 9);
    const double turn = dice.between(0, 2 * std::numbers::pi), reach = r1 + r2;
    const double beside = reach * (1 - dice.magnitude(-14, -2)), away = reach * dice.between(2, 20);
    const Point u{std::cos(turn), std::sin(turn)};
    c.scene.balls = {
        ball("flies", dice.magnitude(-3, 3), r1,
             {-away * u.x - beside * u.y, -away * u.y + beside * u.x}, {speed * u.x, speed * u.y}),
        ball("waits", dice.magnitude(-3, 3), r2, {0, 0})};
    c.scene.limits = {2 * away / speed, 100};
    c.read = read_velocities;
    c.scale = speed;
    return c;
}

/// One ball on two that touch or nearly do, met within 1e-15 .. 1e-6 s of each other.
Case nearly_both(Dice& dice) {
    Case c;
    c.stiff = "one ball on two, contacts 1e-14 .. 1e-6 s apart, any restitution";
    const double later = dice.magnitude(-14, -6);
    if (later < 1e-12) c.only = Simultaneous::sequential;
    c.scene.balls = {ball("cue", 1, 1, {-5, 0}, {1, 0}),
                     ball("upper", dice.magnitude(-1, 1), 1, {0, 1}),
                     ball("lower", dice.magnitude(-1, 1), 1, {0, -1})};
    c.scene.balls[static_cast<std::size_t>(1 + dice.below(2))].position.x = later;
    c.scene.impacts.ball_ball.restitution = dice.between(0.3, 1);
    c.scene.limits = {10, 1000};
    c.read = read_velocities;
    return c;
}

/// Disks of different sizes and masses in a box somewhere.
Case gas(Dice& dice) {
    Case c;
    c.stiff = "disks of any masses (1e-3 .. 1e3) in a box up to 1e6 m away, 40 contacts";
    const int side = 2 + dice.below(3);
    const double far = dice.magnitude(0, 6), angle = dice.between(0, 2 * std::numbers::pi);
    const Point corner{far * std::cos(angle), far * std::sin(angle)};
    add_box(c.scene, corner.x, corner.y, corner.x + side, corner.y + side);
    for (int k = 0; k < side * side; ++k) {
        const double r = dice.between(0.2, 0.45), room = 0.5 - r;
        const Point p{corner.x + k % side + 0.5 + dice.between(-room, room) * 0.99,
                      corner.y + k / side + 0.5 + dice.between(-room, room) * 0.99};
        c.scene.balls.push_back(ball(std::to_string(k), dice.magnitude(-3, 3), r, p,
                                     {dice.between(-1, 1), dice.between(-1, 1)}));
    }
    c.scene.limits = {1e9, 40};
    c.statuses = {Status::event_limit};
    c.read = read_velocities;
    return c;
}

/// A row at low restitution towards a wall: how it ends is all that can be said.
Case collapse(Dice& dice) {
    Case c;
    c.stiff = "a row of 3 to 20 at e = 0 .. 0.6 against a wall";
    const int count = 3 + dice.below(18);
    const double e = dice.between(0, 0.6);
    c.scene.impacts.ball_ball.restitution = e;
    c.scene.impacts.ball_cushion.restitution = e;
    double x = 0;
    for (int k = 0; k < count; ++k) {
        c.scene.balls.push_back(ball(std::to_string(k), dice.magnitude(-1, 1), 1, {x, 0},
                                     {dice.between(0, 1) + 1.0 / (k + 1), 0}));
        x += 2 + dice.magnitude(-6, 0);
    }
    c.scene.segments = {{"wall", {x + 5, -9}, {x + 5, 9}, Side::both}};
    c.scene.limits = {1e4, 3'000'000};
    c.statuses = {Status::time_limit, Status::zeno};
    c.status_only = true;
    c.about = 20'000;  // a row that collapses slowly has more of them the more digits there are
    c.read = read_count;
    return c;
}

/// A break with gaps of any size.
Case shot(Dice& dice) {
    Case c;
    c.stiff = "a break on cloth, gaps of the rack 1e-9 .. 1e-3 m, speed 1 .. 8 m/s";
    presets::Parameters parameters;
    parameters.gap = dice.magnitude(-9, -3);
    parameters.speed = dice.between(1, 8);
    parameters.seed = static_cast<std::uint64_t>(dice.below(1'000'000));
    c.scene = presets::make("break", parameters);
    c.statuses = {Status::at_rest};
    c.most_events = 20'000;
    // Balls that press each other part at some instant within the contact time of 1e-4 s, which a
    // precision of its own decides.
    c.enough = 3;
    c.read = read_positions;
    c.about = 300;
    return c;
}

}  // namespace

void add_random(Catalogue& all, std::uint64_t seed, int count) {
    using Maker = Case (*)(Dice&);
    struct Family {
        const char* name;
        Maker make;
    };
    constexpr Family kFamilies[] = {
        {"row", row}, {"graze", graze},       {"nearly both", nearly_both},
        {"gas", gas}, {"collapse", collapse}, {"shot", shot}};
    for (int k = 0; k < count; ++k) {
        const Family& family = kFamilies[static_cast<std::size_t>(k) % std::size(kFamilies)];
        // Of the seed and the number alone, so that more of them do not change the first ones.
        Dice dice(seed * 1'000'003 + static_cast<std::uint64_t>(k));
        Case c = family.make(dice);
        c.name = std::string(family.name) + ", seed " + std::to_string(seed) + " no. " +
                 std::to_string(k);
        c.family = "random";
        all.push_back(c);
    }
}

}  // namespace osculo::bench::stability

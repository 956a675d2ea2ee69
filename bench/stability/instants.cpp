// Instants that coincide, nearly coincide, or fall on the end of a piece.

#include <algorithm>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

/// One ball on two, of which [nearer] is reached first: upper and lower are placed so that the
/// contacts are an ulp of their instant apart.
Case nearly_both(bool upper_first, double offset, const std::string& by) {
    Case c;
    c.name = std::string("two contacts ") + by + " apart, " + (upper_first ? "upper" : "lower") +
             " first";
    c.family = "instants";
    c.stiff = "which of two comes first decides where everything goes";
    const double r3 = std::sqrt(3.0);
    c.scene.balls = {ball("cue", 1, 1, {-3.75, 0}, {1, 0}), ball("one", 1, 1, {0, 1}),
                     ball("two", 1, 1, {0, -1})};
    c.scene.balls[upper_first ? 2 : 1].position.x = offset;
    c.scene.limits = {10, 1000};
    c.read = read_velocities;
    c.expected = {upper_first ? Values{-0.125, -r3 / 8, 0.75, r3 / 4, 0.375, -r3 / 8}
                              : Values{-0.125, r3 / 8, 0.375, r3 / 8, 0.75, -r3 / 4}};
    c.enough = offset > 1e-15 ? 11 : 16;  // who is later by 1e-12 m goes elsewhere by as much
    if (offset <= 1e-15) c.only = Simultaneous::sequential;
    return c;
}

/// The middle one of three in a row, met from both sides an ulp apart, off centre.
Case both_sides(double later, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "instants";
    c.stiff = "contacts of one ball from both sides within an ulp";
    c.scene.balls = {ball("left", 1, 1, {-6, 0}, {1, 0}), ball("middle", 1, 1, {0, 0}),
                     ball("right", 1, 1, {6 + later, 0}, {-1, 0})};
    c.scene.limits = {10, 1000};
    c.read = read_speeds;
    c.expected = {{-1, 0, 1}};
    return c;
}

Case disjoint_pairs() {
    Case c;
    c.name = "100 pairs at one instant, apart from each other";
    c.family = "instants";
    c.stiff = "equal instants in disjoint places: one must not hold up another";
    for (int k = 0; k < 100; ++k) {
        const double y = 4.0 * k;
        c.scene.balls.push_back(ball("left-" + std::to_string(k), 1, 1, {-3, y}, {1, 0}));
        c.scene.balls.push_back(ball("right-" + std::to_string(k), 1, 1, {3, y}, {-1, 0}));
    }
    c.scene.limits = {5, 10'000};
    c.read = [](const Run& run) {
        double spread = 0, first = 0;
        for (const Event& event : run.events) {
            if (&event == &run.events.front()) first = event.time;
            spread = std::max(spread, std::abs(event.time - first) + std::abs(event.time_low));
        }
        double off = 0;
        for (std::size_t k = 0; k < run.balls.size(); ++k) {
            const double expected = k % 2 == 0 ? -1 : 1;
            off = std::max(off, std::abs(run.balls[k].state.velocity.x - expected));
        }
        return Values{static_cast<double>(run.event_count), first, spread, off};
    };
    c.expected = {{100, 2, 0, 0}};
    return c;
}

/// Rolling with the deceleration 1 m/s^2.
Scene rolling() {
    Scene scene;
    scene.motion = RollingMotion{0.5};
    scene.gravity = 2;
    scene.limits = {100, 1000};
    return scene;
}

/// A ball that rolls 2 m meets, or does not, something at 2 m + [beyond].
Case comes_to_rest(double beyond, bool wall, double contacts, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "instants";
    c.stiff = "a contact at the exact end of a ball's last piece, without speed";
    c.scene = rolling();
    c.scene.balls = {ball("rolls", 1, 1, {0, 0}, {2, 0})};
    if (wall) {
        c.scene.segments = {{"wall", {3 + beyond, -9}, {3 + beyond, 9}, Side::both}};
    } else {
        c.scene.balls.push_back(ball("waits", 1, 1, {4 + beyond, 0}));
    }
    c.statuses = {Status::at_rest};
    c.read = [](const Run& run) {
        double met = 0;
        for (const Event& event : run.events) met += event.kind != EventKind::transition;
        return Values{std::min(met, 1.0), run.balls[0].state.position.x};
    };
    c.expected = {{contacts, 2}};
    c.may_lose = beyond < 0 ? 9 : 1;  // the speed that is left is the root of what is beyond
    c.most_events = 50;
    c.enough = beyond < 0 ? 6 : 16;
    return c;
}

/// Ball 0 comes to rest at 2 s, at which instant ball 1 with 2 m/s meets it.
Case transition_with_contact() {
    Case c;
    c.name = "met at the instant of coming to rest";
    c.family = "instants";
    c.stiff = "a transition and a contact of one ball at one instant";
    c.scene = rolling();
    c.scene.balls = {ball("stops", 1, 1, {0, 0}, {2, 0}), ball("comes", 1, 1, {-6, 0}, {4, 0})};
    c.statuses = {Status::at_rest};
    c.read = [](const Run& run) {
        Values all = read_positions(run);
        all.push_back(static_cast<double>(run.event_count));
        all.push_back(run.events.empty() ? 0 : run.events[0].time);
        return all;
    };
    // The stop, the contact, and then the other one's 2 m.
    c.expected = {{4, 0, 0, 0, 3, 2}};
    return c;
}

/// A sliding ball reaches a wall at the instant at which it begins to roll.
Case slide_ends_at_wall(double beyond, const std::string& name) {
    Case c;
    c.name = name;
    c.family = "instants";
    c.stiff = "a transition at the instant of a contact, on cloth";
    ClothMotion cloth;
    cloth.sliding_friction = 0.25;
    cloth.rolling_friction = 0.01;
    c.scene.motion = cloth;
    c.scene.gravity = 8;
    c.scene.impacts.ball_ball.restitution = 1;
    // From 7 m/s without spin it slides for 2 v / (7 mu g) = 1 s and 12 v^2 / (49 mu g) = 6 m.
    c.scene.balls = {ball("ball", 1, 1, {0, 0}, {7, 0})};
    c.scene.segments = {{"wall", {7 + beyond, -9}, {7 + beyond, 9}, Side::both}};
    c.scene.limits = {1000, 10'000};
    c.statuses = {Status::at_rest};
    c.read = [](const Run& run) {
        const double when = run.events.empty() ? 0 : run.events[0].time;
        return Values{when, run.balls[0].state.position.x};
    };
    c.source = "100 digits";
    c.may_lose = 2;
    return c;
}

Case whole_limit() {
    Case c;
    c.name = "a contact at the time limit";
    c.family = "instants";
    c.stiff = "an event at the exact end of the run happens";
    c.scene.segments = {{"wall", {10, -9}, {10, 9}, Side::both}};
    c.scene.balls = {ball("ball", 1, 1, {0, 0}, {1, 0})};
    c.scene.limits = {9, 1000};
    c.read = [](const Run& run) {
        return Values{static_cast<double>(run.event_count), run.balls[0].state.position.x,
                      run.balls[0].state.velocity.x};
    };
    c.expected = {{1, 9, -1}};
    return c;
}

}  // namespace

void add_instants(Catalogue& all) {
    // The cue needs 3.75 - sqrt(3) = 2.02 s: an ulp is 2^-51 s, as it is for the places.
    for (const bool upper_first : {true, false}) {
        all.push_back(nearly_both(upper_first, 0x1p-51, "1 ulp"));
        all.push_back(nearly_both(upper_first, 0x1p-40, "1e-12 s"));
    }
    all.push_back(both_sides(0x1p-50, "from both sides, left 1 ulp earlier"));
    all.push_back(both_sides(-0x1p-50, "from both sides, right 1 ulp earlier"));
    all.push_back(disjoint_pairs());
    all.push_back(whole_limit());
    for (const bool wall : {false, true}) {
        const std::string what = wall ? "a wall" : "a ball";
        all.push_back(comes_to_rest(0, wall, 0, "comes to rest touching " + what));
        all.push_back(comes_to_rest(0x1p-50, wall, 0, "comes to rest an ulp before " + what));
        all.push_back(comes_to_rest(-0x1p-50, wall, 1, "an ulp too far to rest before " + what));
    }
    all.push_back(transition_with_contact());
    all.push_back(slide_ends_at_wall(0, "begins to roll where it meets a wall"));
    all.push_back(slide_ends_at_wall(0x1p-50, "begins to roll an ulp before a wall"));
    all.push_back(slide_ends_at_wall(-0x1p-50, "meets a wall an ulp before it would roll"));
}

}  // namespace osculo::bench::stability

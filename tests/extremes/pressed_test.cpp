#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"

// Balls that a force presses against something: their own spin on the cloth, a rim. They hop
// (impact/pressing.hpp): a bounded number of times, no higher than the contact time allows, and
// what becomes of them tends to what it is without any bounce as e goes to zero.
namespace osculo::support {
namespace {

constexpr double kRestitutions[] = {0.9, 0.5, 0.1, 1e-3, 0};
constexpr Simultaneous kLaws[] = {Simultaneous::symmetric, Simultaneous::sequential};

constexpr double kSliding = 0.2 * 9.81;  // deceleration, or acceleration, of a ball that slips
constexpr double kContactTime = 1e-4;
/// The highest hop of a pressed ball, and how far what speed is left at its end then rolls [m].
constexpr double kHop = kSliding * kContactTime * kContactTime / 8;
constexpr double kLeft = kSliding * kContactTime / 2;
constexpr double kRollOut = kLeft * kLeft / (2 * kDeceleration);

std::string named(double e, Simultaneous law) {
    return "e = " + std::to_string(e) +
           (law == Simultaneous::symmetric ? ", symmetric" : ", sequential");
}

/// Restitution alone at rails and between balls.
Scene frictionless_contacts(double e, Simultaneous law) {
    Scene scene = cloth_scene();
    scene.impacts.ball_ball = {};
    scene.impacts.ball_ball.restitution = e;
    scene.impacts.ball_cushion = {};
    scene.impacts.ball_cushion.restitution = e;
    scene.impacts.simultaneous = law;
    scene.limits.events = 100'000;
    return scene;
}

/// When a ball slid for the last time [s].
double end_of_sliding(const Run& run) {
    double last = 0;
    for (const Event& event : run.events) {
        if (event.kind == EventKind::transition && event.from == Phase::sliding) last = event.time;
    }
    return last;
}

/// How often things met.
double contacts(const Run& run) {
    return static_cast<double>(run.event_count) - count(run, EventKind::transition);
}

/// A ball in touch with a rail, at rest but for a spin that drives it there.
TEST(Pressed, ToARailByItsSpin) {
    const double spin = 40;
    // Held in place it slips until its spin is spent: r w falls with 5/2 of the deceleration.
    const double slips = 2 * kPoolRadius * spin / (5 * kSliding);
    for (const Simultaneous law : kLaws) {
        for (const double e : kRestitutions) {
            SCOPED_TRACE(named(e, law));
            Scene scene = frictionless_contacts(e, law);
            scene.segments = {rail("rail", {-5, 0}, {5, 0})};
            scene.balls = {pool_ball("ball", {0, kPoolRadius})};
            scene.balls[0].spin = {spin, 0, 0};
            const auto run = settled(scene);
            OSCULO_EXPECT_SOUND(run);
            // Hops of the contact time each, but for some short ones in the end.
            EXPECT_LE(contacts(run), slips / kContactTime + 100);
            // The speed of hops is slip, too: at most a tau / 2 of it.
            EXPECT_NEAR(end_of_sliding(run), slips, kContactTime);
            const Point end = run.balls[0].state.position;
            EXPECT_EQ(end.x, 0);
            EXPECT_GE(end.y, kPoolRadius * (1 - 1e-12));
            EXPECT_LE(end.y, kPoolRadius + kHop + kRollOut);
        }
    }
}

/// A ball that rolls straight at another one, which is frozen to a rail, and its spin presses it
/// on.
Run against_a_frozen_ball(double e, Simultaneous law, double speed) {
    Scene scene = frictionless_contacts(e, law);
    scene.segments = {rail("rail", {-5, 0}, {5, 0})};
    scene.balls = {rolling_ball("cue", {0, 0.4}, {0, -speed}),
                   pool_ball("frozen", {0, kPoolRadius})};
    return settled(scene);
}

TEST(Pressed, WithAFrozenBallBetweenItAndTheRail) {
    const double speed = 1.5;
    // A ball stopped in its rolling slips for 2 v / (7 mu g), whatever stops it again and again.
    for (const Simultaneous law : kLaws) {
        for (const double e : kRestitutions) {
            SCOPED_TRACE(named(e, law));
            const auto run = against_a_frozen_ball(e, law, speed);
            OSCULO_EXPECT_SOUND(run);
            const double slips = end_of_sliding(run);
            // Two contacts, hops of at least the contact time unless a ball bounces: those that do
            // lose a factor e each time, from the speed of the first down to that of a hop.
            const double bounces = e > 0 ? std::log(kLeft / speed) / std::log(e) : 1;
            EXPECT_LE(contacts(run), 2 * slips / kContactTime + 20 * bounces + 200);
            const double cue = run.balls[0].state.position.y;
            const double frozen = run.balls[1].state.position.y;
            EXPECT_EQ(run.balls[0].state.position.x, 0);
            EXPECT_GE(frozen, kPoolRadius * (1 - 1e-12));
            EXPECT_GE(cue - frozen, 2 * kPoolRadius * (1 - 1e-12));
        }
    }
}

/// Without any bounce the balls stop where they are and the spin is spent there; with a little, the
/// cue ball comes back by what (e v)^2 / (2 a) is, against the force.
TEST(Pressed, WithAFrozenBallTendsToNoBounce) {
    const double speed = 1.5;
    for (const Simultaneous law : kLaws) {
        for (const double e : {1e-3, 0.0}) {
            SCOPED_TRACE(named(e, law));
            const auto run = against_a_frozen_ball(e, law, speed);
            const double back = e * speed * e * speed / (2 * kSliding);
            const double most = 10 * (kHop + kRollOut + back);
            EXPECT_LE(run.balls[1].state.position.y, kPoolRadius + most);
            EXPECT_LE(run.balls[0].state.position.y, 3 * kPoolRadius + most);
        }
    }
}

/// Straight at two balls frozen to each other: its spin takes it after them.
Run follow_through(double e, Simultaneous law) {
    Scene scene = frictionless_contacts(e, law);
    scene.balls = {rolling_ball("cue", {-0.3, 0}, {2, 0}), pool_ball("1", {0, 0}),
                   pool_ball("2", {2 * kPoolRadius, 0})};
    return settled(scene);
}

/// How far three balls go that stay together: the cue ball comes rolling at 2 m/s from 0.3 m away
/// and goes on slipping forwards. In units of x = mu g t and with V a third of its speed:
/// - All slip, the two others backwards: a = -1/3 mu g, until these roll, V - x / 3 = 5 x / 2.
/// - These roll, 7/5 as inert and each with 7/5 m mu_r g against it, until the cue ball rolls, too.
/// - All roll to rest.
/// Their hops are slips, too, in which mu_r does not act: a tenth of the second part of the way.
double way_of_three_together() {
    const double speed = std::sqrt(4 - 2 * kDeceleration * (0.3 - 2 * kPoolRadius));
    const double first = speed / 3 / (2.5 + 1.0 / 3);
    const double slow = speed / 3 - first / 3;
    const double rate = (1 - 2 * 1.4 * kDeceleration / kSliding) / 3.8;
    const double second = (speed - 2.5 * first - slow) / (2.5 + rate);
    const double fast = slow + rate * second;
    return (first * (speed / 3 + slow) / 2 + second * (slow + fast) / 2) / kSliding +
           fast * fast / (2 * kDeceleration);
}

TEST(Pressed, FollowThroughBehindFrozenBalls) {
    for (const Simultaneous law : kLaws) {
        for (const double e : kRestitutions) {
            SCOPED_TRACE(named(e, law));
            const auto run = follow_through(e, law);
            OSCULO_EXPECT_SOUND(run);
            // In a row, a hop of one pair may bring the other one together earlier.
            EXPECT_LE(contacts(run), 8 * end_of_sliding(run) / kContactTime + 500);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(run.balls[k].state.position.y, 0);
                if (k == 0) continue;
                EXPECT_GE(run.balls[k].state.position.x - run.balls[k - 1].state.position.x,
                          2 * kPoolRadius * (1 - 1e-12));
            }
        }
        // Speeds change by some e, and ways by twice as much.
        const auto little = follow_through(1e-3, law), none = follow_through(0, law);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(little.balls[k].state.position.x, none.balls[k].state.position.x,
                        0.01 * none.balls[k].state.position.x)
                << named(0, law) << ", ball " << k;
            const double from = 2 * kPoolRadius * (static_cast<double>(k) - 1);
            EXPECT_NEAR(none.balls[k].state.position.x - from, way_of_three_together(), 0.012);
        }
    }
}

/// Two balls beside each other on the slope of one rim, whose pull brings them together on the way
/// down.
Run on_one_rim(double e, Simultaneous law, double apart, double until) {
    Scene scene;
    scene.motion = RollingMotion{0.01};
    scene.impacts.ball_ball.restitution = e;
    scene.impacts.simultaneous = law;
    scene.rims = {{"hole", {0, 0}, 1, RimLaw::paper}};
    const double radius = 0.1, out = 0.97, half = radius + apart / 2;
    for (const double side : {-1.0, 1.0}) {
        Ball ball = pool_ball(side < 0 ? "left" : "right",
                              {side * half, std::sqrt(out * out - half * half)});
        ball.radius = radius;
        scene.balls.push_back(ball);
    }
    scene.limits = {until, 100'000};
    return simulate(scene, {.audit = true});
}

TEST(Pressed, TwoBallsPulledIntoEachOther) {
    for (const Simultaneous law : kLaws) {
        for (const double apart : {0.0, 1e-3}) {
            for (const double e : {0.9, 1e-3, 0.0}) {
                SCOPED_TRACE(named(e, law) + ", apart " + std::to_string(apart));
                const auto run = on_one_rim(e, law, apart, 0.1);
                EXPECT_TRUE(run.audit->clean);
                EXPECT_EQ(run.status, Status::time_limit);
                EXPECT_GE(count(run, EventKind::ball_ball), 1);
                EXPECT_LE(contacts(run), run.time / kContactTime + 100);
                const Point left = run.balls[0].state.position;
                const Point right = run.balls[1].state.position;
                const double gap = std::hypot(right.x - left.x, right.y - left.y) - 0.2;
                EXPECT_GE(gap, -1e-13);
                EXPECT_NEAR(left.x, -right.x, 1e-9);
                EXPECT_NEAR(left.y, right.y, 1e-9);
                // Without bounces to speak of they go down side by side, hopping by a tau^2 / 8,
                // less than if they fell towards each other.
                if (apart == 0 || e < 0.01) {
                    EXPECT_LE(gap, 2 * 9.81 * kContactTime * kContactTime / 8);
                }
            }
        }
    }
}

TEST(Pressed, OnOneRimUntilBothHaveFallen) {
    for (const Simultaneous law : kLaws) {
        for (const double e : {0.9, 0.5, 0.0}) {
            for (const double apart : {0.0, 1e-6, 1e-3}) {
                SCOPED_TRACE(named(e, law) + ", apart " + std::to_string(apart));
                const auto run = on_one_rim(e, law, apart, 1);
                EXPECT_EQ(run.status, Status::at_rest);
                EXPECT_TRUE(run.audit->clean);
                for (const FinalBall& ball : run.balls) EXPECT_EQ(ball.fate, BallFate::captured);
            }
        }
    }
}

}  // namespace
}  // namespace osculo::support

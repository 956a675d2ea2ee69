#include <cmath>

#include <gtest/gtest.h>

#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using Type = engine::RimsScene<double, engine::RimsPieces>;
using Engine = engine::Engine<Type>;
using Motion = Type::Motion;
using Vec = math::Vec<double>;

constexpr double kRadius = 0.028575;
constexpr double kRim = 0.06;
constexpr double kGravity = 9.81;

/// A hole of 60 mm around the origin.
engine::SceneData<Type> scene(double friction = 0, double restitution = 1) {
    engine::SceneData<Type> scene;
    scene.motion.deceleration = friction * kGravity;
    scene.motion.gravity = kGravity;
    geometry::PullingRim<double> rim;
    rim.center = Vec(0, 0);
    rim.radius = kRim;
    scene.motion.rims = {rim};
    std::get<0>(scene.obstacles) = scene.motion.rims;
    scene.ball_ball_restitution = scene.ball_cushion_restitution = restitution;
    scene.contact_time = 1e-4;
    return scene;
}
void add(engine::SceneData<Type>& scene, Vec position, Vec velocity) {
    engine::Body<Type> body;
    body.state.position = math::WidePoint<double>(position);
    body.state.velocity = velocity;
    body.state.ball_radius = body.radius = kRadius;
    body.mass = 0.17;
    scene.bodies.push_back(body);
}
constexpr engine::Kind kEntry = engine::kFirstObstacle;

/// Kinetic energy and that in the field, per mass.
double energy(const Motion::State<double>& state) {
    const Vec x = state.position.rounded();
    const double q = std::max((kRim - math::norm<double>(x)) / kRadius, 0.0);
    return math::dot<double>(state.velocity, state.velocity) / 2 +
           kGravity * kRadius / 3 * std::pow(std::max(1 - q * q, 0.0), 1.5);
}

/// The smallest gap of two balls, from their pieces, sampled.
double smallest_gap(const Type::Recorder& record, double end) {
    std::vector<std::vector<const engine::StatePieceRecord<double, Motion::State<double>>*>> of(2);
    for (const auto& piece : record.pieces) of[piece.ball].push_back(&piece);
    const auto place = [&](std::size_t ball, double t) -> std::optional<Vec> {
        for (const auto* piece : of[ball]) {
            if (t < piece->from.hi || t > piece->to.hi) continue;
            auto state = piece->state;
            Motion::advance<double>(state, std::min(t - piece->from.hi, state.remaining));
            return state.position.rounded();
        }
        return std::nullopt;
    };
    double smallest = 1;
    for (int k = 0; k <= 4000; ++k) {
        const auto a = place(0, end * k / 4000), b = place(1, end * k / 4000);
        if (a && b) smallest = std::min(smallest, math::norm<double>(Vec(*a - *b)) - 2 * kRadius);
    }
    return smallest;
}

TEST(RimScenes, ABallRollsInAndFalls) {
    auto data = scene();
    add(data, Vec(0.2, 0.01), Vec(-0.5, 0));
    Engine engine(data);
    EXPECT_EQ(engine.run({60, 1000}), Status::at_rest);
    const auto& events = engine.recorder().events;
    ASSERT_EQ(events.size(), 2);
    EXPECT_EQ(events[0].kind, kEntry);
    EXPECT_EQ(events[1].kind, engine::kTransition);
    EXPECT_FALSE(engine.bodies()[0].present);
    EXPECT_TRUE(engine.bodies()[0].state.fallen);
    EXPECT_NEAR(math::norm<double>(engine.bodies()[0].state.position.rounded()), kRim - kRadius,
                1e-16);
    EXPECT_NEAR(energy(events[1].after[0]), energy(events[0].before[0]), 1e-15);
}

TEST(RimScenes, ABallCirclesTheHoleAndLeaves) {
    auto data = scene();
    add(data, Vec(0.06, -0.3), Vec(-0.004, 0.6));
    Engine engine(data);
    EXPECT_EQ(engine.run({3, 1000}), Status::time_limit);
    const auto& events = engine.recorder().events;
    ASSERT_EQ(events.size(), 2);
    EXPECT_TRUE(engine.bodies()[0].present);
    const auto& out = events[1].after[0];
    EXPECT_EQ(out.rim, Motion::kOutside);
    EXPECT_NEAR(math::norm<double>(out.velocity), math::norm<double>(events[0].before[0].velocity),
                1e-15);
    EXPECT_GT(math::dot<double>(out.position.rounded(), out.velocity), 0);
}

TEST(RimScenes, ABallAtRestInsideFallsAndOneOnTheRimStays) {
    auto data = scene(0.01);
    add(data, Vec(0.059, 0), Vec(0, 0));
    add(data, Vec(-0.06, 0), Vec(0, 0));
    Engine engine(data);
    EXPECT_EQ(engine.run({60, 1000}), Status::at_rest);
    EXPECT_FALSE(engine.bodies()[0].present);
    EXPECT_TRUE(engine.bodies()[1].present);
    EXPECT_EQ(engine.bodies()[1].state.position.x.hi, -0.06);
}

/// A ball that stands on the edge, and one that is struck while it moves in the rim.
TEST(RimScenes, ABallHangingOnTheRimIsStruck) {
    for (const double x : {-0.06, -0.0599}) {
        auto data = scene(0.01, 0.95);
        add(data, Vec(x, 0), Vec(0, 0));
        add(data, Vec(-0.3, 0.02), Vec(1.5, 0));
        Engine engine(data);
        EXPECT_EQ(engine.run({60, 10000}), Status::at_rest);
        int contacts = 0;
        for (const auto& event : engine.recorder().events) {
            if (event.kind != engine::kBallBall) continue;
            ++contacts;
            EXPECT_NEAR(math::norm<double>(event.normal), 2 * kRadius, 1e-15);
        }
        EXPECT_GE(contacts, 1);
        EXPECT_GE(smallest_gap(engine.recorder(), engine.time().hi), -1e-15);
    }
}

/// The rim pulls them against each other, at once and again and again, until one has fallen.
TEST(RimScenes, TwoBallsInOneRim) {
    for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
        for (const double gap : {0.0, 1e-9, 1e-3}) {
            auto data = scene(0.01, restitution);
            const double x = kRadius + gap / 2;
            add(data, Vec(x, 0.045), Vec(0, 0));
            add(data, Vec(-x, 0.0451), Vec(0, 0));
            Engine engine(data);
            EXPECT_EQ(engine.run({10, 200000}), Status::at_rest) << restitution << " " << gap;
            EXPECT_GE(smallest_gap(engine.recorder(), engine.time().hi), -1e-15);
            int contacts = 0;
            double energy_before = energy(engine.recorder().pieces[0].state) +
                                   energy(engine.recorder().pieces[1].state);
            for (const auto& event : engine.recorder().events) {
                if (event.kind != engine::kBallBall) continue;
                ++contacts;
                const double now = energy(event.after[0]) + energy(event.after[1]);
                // What parting may take from the pull: (a tau)^2 / 8 each.
                EXPECT_LE(now, energy_before + 2 * 1e-8 * kGravity * kGravity / 8);
                energy_before = now;
            }
            EXPECT_GE(contacts, 1);
            EXPECT_LT(engine.event_count(), 20000U);
        }
    }
}

/// A rim in a corner: a ball is pulled along a cushion, and another one into it.
TEST(RimScenes, BallsArePulledAgainstCushions) {
    auto data = scene(0.01, 0.8);
    std::get<std::vector<geometry::Segment<double>>>(data.obstacles)
        .emplace_back(Vec(-1, -0.04 - kRadius), Vec(1, -0.04 - kRadius), false);
    add(data, Vec(0.045, -0.035), Vec(-0.1, -0.5));
    Engine engine(data);
    const Status status = engine.run({10, 200000});
    EXPECT_NE(status, Status::numeric);
    int contacts = 0;
    for (const auto& event : engine.recorder().events) {
        if (event.kind != kEntry + 2) continue;
        ++contacts;
        EXPECT_NEAR(event.before[0].position.y.hi, -0.04, 1e-16);
    }
    EXPECT_GE(contacts, 1);
}

TEST(RimScenes, RandomScenesEndAndNothingOverlaps) {
    Random random(3);
    int falls = 0;
    int exits = 0;
    for (int i = 0; i < 200; ++i) {
        auto data = scene(i % 2 == 0 ? 0.01 : 0, i % 3 == 0 ? 1 : 0.8);
        const Vec first = random.uniform<double>(0.032, 0.15) * random.direction<double>();
        add(data, first, random.magnitude<double>(-8, 0) * random.direction<double>());
        for (;;) {
            const Vec second = random.uniform<double>(0.032, 0.2) * random.direction<double>();
            if (math::norm<double>(Vec(first - second)) < 2 * kRadius) continue;
            add(data, second, random.magnitude<double>(-8, 0) * random.direction<double>());
            break;
        }
        Engine engine(data);
        const Status status = engine.run({5, 200000});
        EXPECT_TRUE(status == Status::at_rest || status == Status::time_limit)
            << "scene " << i << ": " << to_string(status) << " at " << engine.time().hi << " after "
            << engine.event_count();
        EXPECT_GE(smallest_gap(engine.recorder(), engine.time().hi), -1e-15) << i;
        for (const auto& body : engine.bodies()) falls += !body.present;
        for (const auto& event : engine.recorder().events) {
            exits +=
                event.kind == engine::kTransition && event.before[0].stay && !event.after[0].stay;
        }
        EXPECT_LT(engine.event_count(), 100000U) << i;
        const auto audit =
            engine::audit<Type>(data, engine.recorder(), engine.bodies(), engine.time());
        EXPECT_TRUE(audit.clean) << i << ": gap " << audit.worst_gap << " at "
                                 << audit.worst_gap_time << ", jump " << audit.largest_jump
                                 << ", contact " << audit.largest_contact_error << ", unexplained "
                                 << audit.unexplained << ", gain " << audit.largest_energy_gain
                                 << ", momentum " << audit.largest_momentum_error;
    }
    EXPECT_GT(falls, 20);
    EXPECT_GT(exits, 20);
}

/// What the audit says of a run that somebody has tampered with.
TEST(RimScenes, AnAuditFindsFaults) {
    auto data = scene(0.01, 0.95);
    add(data, Vec(-0.06, 0), Vec(0, 0));
    add(data, Vec(-0.3, 0.02), Vec(1.5, 0));
    Engine engine(data);
    engine.run({60, 10000});
    const auto audit = [&](const Type::Recorder& record) {
        return engine::audit<Type>(data, record, engine.bodies(), engine.time());
    };
    EXPECT_TRUE(audit(engine.recorder()).clean);
    const auto tampered = [&](auto&& change) {
        auto record = engine.recorder();
        for (auto& piece : record.pieces) {
            if (!piece.state.stay) continue;
            change(piece.state);
            break;
        }
        return audit(record);
    };
    EXPECT_FALSE(tampered([](auto& state) { state.velocity.x() += 1e-12; }).clean);
    EXPECT_FALSE(tampered([](auto& state) { state.since += 1e-9; }).clean);
    EXPECT_FALSE(tampered([](auto& state) { state.position.x.hi += 1e-12; }).clean);
    // A field that is a millionth stronger.
    EXPECT_FALSE(tampered([](auto& state) {
                     state.stay = std::make_shared<const motion::RimPaperMotion<double>>(
                         state.stay->rim(), kGravity * (1 + 1e-6), kRadius, state.position,
                         state.velocity);
                 }).clean);
    // Balls that have been larger all the time overlap where they met.
    for (auto& body : data.bodies) body.radius *= 1 + 1e-9;
    EXPECT_FALSE(audit(engine.recorder()).clean);
    EXPECT_LT(audit(engine.recorder()).worst_gap, -1e-9);
}

/// The separatrix: with no digit to tell, the run ends with a status.
TEST(RimScenes, ABallBalancedOnTheSeparatrixDoesNotHang) {
    auto data = scene();
    const double along = 0.32351607697434975;
    add(data, Vec(kRim, 0), Vec(-0.3, along));
    Engine engine(data);
    const Status status = engine.run({60, 1000});
    EXPECT_TRUE(status == Status::at_rest || status == Status::time_limit ||
                status == Status::numeric);
    EXPECT_LT(engine.event_count(), 10U);
}

/// A circular orbit where the field holds it: for ever, at two turns an orbit.
TEST(RimScenes, AnOrbitEndsAtTheTimeLimit) {
    auto data = scene();
    const double q = 0.9;
    const double d = kRim - q * kRadius;
    add(data, Vec(d, 0), Vec(0, 1.01 * std::sqrt(kGravity * q * std::sqrt(1 - q * q) * d)));
    Engine engine(data);
    EXPECT_EQ(engine.run({2, 100000}), Status::time_limit);
    EXPECT_GT(engine.event_count(), 10U);
    const auto& events = engine.recorder().events;
    // From turn to turn, whatever rounding has left of the radial speed.
    const double half = events[1].when.hi - events[0].when.hi;
    for (std::size_t i = 1; i < events.size(); ++i) {
        EXPECT_NEAR(events[i].when.hi - events[i - 1].when.hi, half, 1e-9) << i;
    }
    EXPECT_NEAR(energy(events.back().after[0]), energy(events.front().before[0]),
                1e-15 * double(events.size()));
}

}  // namespace

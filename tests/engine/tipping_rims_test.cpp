#include <cmath>

#include <gtest/gtest.h>

#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using Type = engine::TippingRimsScene<double, engine::TippingRimsPieces>;
using SymmetricType =
    engine::TippingRimsScene<double, engine::TippingRimsPieces, impact::Symmetric>;
using Engine = engine::Engine<Type>;
using Motion = Type::Motion;
using State = Motion::State<double>;
using Vec = math::Vec<double>;
using motion::TippingEnd;

constexpr double kRadius = 0.028575;
constexpr double kRim = 0.0571;
constexpr double kGravity = 9.81;
constexpr engine::Kind kEntry = engine::kFirstObstacle;

/// A hole around the origin.
template <class T = Type>
engine::SceneData<T> scene(double friction = 0, double restitution = 1, double edge = 0.5,
                           double rim = kRim) {
    engine::SceneData<T> scene;
    scene.motion.deceleration = friction * kGravity;
    scene.motion.gravity = kGravity;
    scene.motion.rims.resize(1);
    scene.motion.rims[0].center = Vec(0, 0);
    scene.motion.rims[0].radius = rim;
    scene.motion.restitutions = {edge};
    scene.motion.contact_time = scene.contact_time = 1e-4;
    std::get<0>(scene.obstacles) = scene.motion.rims;
    scene.ball_ball_restitution = scene.ball_cushion_restitution = restitution;
    return scene;
}
template <class T>
void add(engine::SceneData<T>& scene, Vec position, Vec velocity, double inertia = 0) {
    engine::Body<T> body;
    body.state.position = math::WidePoint<double>(position);
    body.state.velocity = velocity;
    body.state.inertia = inertia;
    body.state.ball_radius = body.radius = kRadius;
    body.mass = 0.17;
    scene.bodies.push_back(body);
}

double energy(const State& s) {
    const double plan = math::dot<double>(s.velocity, s.velocity) / 2;
    return s.stay ? plan + s.climb * s.climb / 2 + kGravity * (s.height - kRadius) : plan;
}
double moment(const State& s) {
    return math::cross<double>(s.position.rounded(), s.velocity);
}

struct Counts {
    int falls = 0, exits = 0, edges = 0, lifts = 0;
};
template <class E>
Counts count(E& engine) {
    Counts counts;
    for (const auto& event : engine.recorder().events) {
        const auto& stay = event.before[0].stay;
        if (event.kind != engine::kTransition || !stay) continue;
        counts.falls += event.after[0].fallen;
        counts.exits += !event.after[0].stay;
        counts.edges += stay->end() == TippingEnd::edge;
        counts.lifts += stay->end() == TippingEnd::lift_off;
    }
    return counts;
}

template <class T, class E>
void expect_clean(const engine::SceneData<T>& data, E& engine, const std::string& what = "") {
    const auto audit = engine::audit<T>(data, engine.recorder(), engine.bodies(), engine.time());
    EXPECT_TRUE(audit.clean) << what << ": gap " << audit.worst_gap << " at "
                             << audit.worst_gap_time << ", jump " << audit.largest_jump
                             << ", contact " << audit.largest_contact_error << ", unexplained "
                             << audit.unexplained << ", gain " << audit.largest_energy_gain
                             << ", momentum " << audit.largest_momentum_error;
}

TEST(TippingRims, ASlowBallTipsFliesAndFalls) {
    auto data = scene();
    add(data, Vec(0.2, 0.01), Vec(-0.3, 0));
    Engine engine(data);
    EXPECT_EQ(engine.run({60, 1000}), Status::at_rest);
    const auto& events = engine.recorder().events;
    ASSERT_EQ(events.size(), 3);
    EXPECT_EQ(events[0].kind, kEntry);
    EXPECT_EQ(events[1].before[0].stay->end(), TippingEnd::lift_off);
    EXPECT_TRUE(events[2].after[0].fallen);
    EXPECT_NEAR(events[2].after[0].height, 0, 1e-16);
    EXPECT_NEAR(energy(events[2].before[0]), energy(events[0].before[0]), 1e-15);
    expect_clean(data, engine);
}

/// Energy and angular momentum about the hole are kept by everything but other things, to 1e-13.
TEST(TippingRims, KeepEnergyAndAngularMomentum) {
    Random random(8);
    for (int i = 0; i < 300; ++i) {
        auto data = scene(0, 1, 1);
        const double a = 1.5 * random.unit<double>() - 0.75;
        const double speed = random.magnitude<double>(-5, 1);
        add(data, Vec(kRim + 0.1, 0), speed * Vec(-std::cos(a), std::sin(a)));
        Engine engine(data);
        engine.run({20, 100000});
        for (const auto& event : engine.recorder().events) {
            const bool lands = event.before[0].stay && !event.after[0].stay;
            const double was = energy(event.before[0]);
            const double unit = speed * speed + kGravity * kRadius;
            EXPECT_LE(std::abs(energy(event.after[0]) - was), lands ? unit : 1e-13 * unit) << i;
            EXPECT_LE(energy(event.after[0]), was + 1e-13 * unit) << i;
            EXPECT_LE(std::abs(moment(event.after[0]) - moment(data.bodies[0].state)),
                      1e-13 * kRim * (speed + 0.5))
                << i;
        }
        expect_clean(data, engine, std::to_string(i));
    }
}

/// What hits a dead edge too fast to stay on it slides along it for an instant and flies on.
TEST(TippingRims, DeadEdgesAreLeft) {
    Random random(9);
    int left = 0;
    for (int i = 0; i < 1000; ++i) {
        auto data = scene(0.01, 1, 0, kRadius * (1.02 + random.unit<double>()));
        const double a = 3 * random.unit<double>() - 1.5;
        add(data, Vec(data.motion.rims[0].radius + 0.01, 0),
            random.magnitude<double>(-2, 2) * Vec(-std::cos(a), std::sin(a)));
        Engine engine(data);
        const Status status = engine.run({20, 1000});
        EXPECT_TRUE(status == Status::at_rest || status == Status::time_limit)
            << i << " " << to_string(status);
        for (const auto& event : engine.recorder().events) {
            const auto& was = event.before[0].stay;
            const auto& is = event.after[0].stay;
            left += was && is && was->end() == TippingEnd::edge && !is->on_edge();
        }
        expect_clean(data, engine, std::to_string(i));
    }
    EXPECT_GT(left, 50);
}

/// Two balls and a hole in a random scene, whatever happens.
template <class T>
void random_scenes(int count_of_scenes, int seed) {
    Counts all;
    int hits = 0;
    constexpr double kRims[]{1.1 * kRadius, kRim, 4 * kRadius};
    for (int i = 0; i < count_of_scenes; ++i) {
        Random random(static_cast<std::uint64_t>(seed + i));
        auto data =
            scene<T>(i % 2 == 0 ? 0.01 : 0, i % 3 == 0 ? 1 : 0.8, i % 5 * 0.25, kRims[i % 7 % 3]);
        const double rim = kRims[i % 7 % 3];
        const double inertia = i % 4 < 2 ? 0.4 : 0;
        const Vec first =
            random.uniform<double>(rim - 0.9 * kRadius, rim + 0.1) * random.direction<double>();
        add(data, first, random.magnitude<double>(-8, 2) * random.direction<double>(), inertia);
        for (;;) {
            const Vec second = random.uniform<double>(rim - 0.9 * kRadius, rim + 0.15) *
                               random.direction<double>();
            if (math::norm<double>(Vec(first - second)) < 2 * kRadius) continue;
            add(data, second, random.magnitude<double>(-8, 2) * random.direction<double>(),
                inertia);
            break;
        }
        engine::Engine<T> engine(data);
        const Status status = engine.run({5, 200000});
        EXPECT_TRUE(status == Status::at_rest || status == Status::time_limit)
            << "scene " << i << ": " << to_string(status) << " at " << engine.time().hi << " after "
            << engine.event_count();
        EXPECT_LT(engine.event_count(), 20000U) << i;
        const Counts counts = count(engine);
        all.falls += counts.falls;
        all.exits += counts.exits;
        all.edges += counts.edges;
        all.lifts += counts.lifts;
        for (const auto& event : engine.recorder().events) hits += event.kind == engine::kBallBall;
        expect_clean(data, engine, std::to_string(i));
    }
    EXPECT_GT(all.falls, count_of_scenes / 20);
    EXPECT_GT(all.exits, count_of_scenes / 20);
    EXPECT_GT(all.edges, count_of_scenes / 20);
    EXPECT_GT(all.lifts, count_of_scenes / 20);
    EXPECT_GT(hits, count_of_scenes / 20);
}
TEST(TippingRims, RandomScenesEndAndAreClean) {
    random_scenes<Type>(200, 3);
}
TEST(TippingRims, SymmetricRandomScenesEndAndAreClean) {
    random_scenes<SymmetricType>(200, 4);
}

/// A ball that stands on the rim, one that hangs on the edge, and one on its way down, struck.
TEST(TippingRims, ABallOnTheEdgeIsStruck) {
    for (const double x : {-kRim, -kRim + 1e-4, -kRim + 0.01}) {
        for (const double edge : {0.0, 0.5, 1.0}) {
            auto data = scene(0.01, 0.95, edge);
            add(data, Vec(x, 0), Vec(0, 0), 0.4);
            add(data, Vec(-0.2, 0.02), Vec(1.5, 0), 0.4);
            Engine engine(data);
            const Status status = engine.run({60, 10000});
            EXPECT_TRUE(status == Status::at_rest || status == Status::time_limit);
            int contacts = 0;
            for (const auto& event : engine.recorder().events) {
                if (event.kind != engine::kBallBall) continue;
                ++contacts;
                EXPECT_NEAR(math::norm<double>(event.normal), 2 * kRadius, 1e-15);
                // The impact is one in the plane: what it does in space comes after it.
                for (std::size_t k = 0; k < 2; ++k) {
                    EXPECT_EQ(event.before[k].height, event.after[k].height);
                    EXPECT_EQ(event.before[k].climb, event.after[k].climb);
                }
            }
            EXPECT_GE(contacts, 1);
            expect_clean(data, engine, std::to_string(x));
        }
    }
}

/// The edge leads them against each other, at once and again and again, until one has fallen.
TEST(TippingRims, TwoBallsInOneRim) {
    for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
        for (const double gap : {0.0, 1e-9, 1e-3}) {
            auto data = scene(0.01, restitution, restitution, 0.06);
            data.motion.contact_time = data.contact_time = 1e-3;
            const double x = kRadius + gap / 2;
            add(data, Vec(x, 0.045), Vec(0, 0), 0.4);
            add(data, Vec(-x, 0.0451), Vec(0, 0), 0.4);
            Engine engine(data);
            EXPECT_EQ(engine.run({10, 200000}), Status::at_rest) << restitution << " " << gap;
            int contacts = 0;
            for (const auto& event : engine.recorder().events) {
                if (event.kind != engine::kBallBall) continue;
                ++contacts;
                const auto sum = [](const auto& of) { return energy(of[0]) + energy(of[1]); };
                // What parting may take from gravity: (a tau)^2 / 8 each.
                EXPECT_LE(sum(event.after), sum(event.before) + 2 * 1e-6 * kGravity * kGravity / 8);
            }
            EXPECT_GE(contacts, 1);
            EXPECT_LT(engine.event_count(), 2000U);
            EXPECT_EQ(count(engine).falls, 2);
            expect_clean(data, engine, std::to_string(restitution));
        }
    }
}

/// What the audit says of a run that somebody has tampered with.
TEST(TippingRims, AnAuditFindsFaults) {
    auto data = scene(0, 1, 0.5);
    add(data, Vec(0.2, 0.02), Vec(-0.45, 0));
    add(data, Vec(-0.2, 0.001), Vec(1.2, 0));
    Engine engine(data);
    engine.run({60, 10000});
    const Counts counts = count(engine);
    ASSERT_GE(counts.edges, 1);
    ASSERT_GE(counts.lifts, 1);
    const auto audit = [&](const Type::Recorder& record) {
        return engine::audit<Type>(data, record, engine.bodies(), engine.time());
    };
    EXPECT_TRUE(audit(engine.recorder()).clean);
    for (const bool on_edge : {false, true}) {
        const auto tampered = [&](auto&& change) {
            auto record = engine.recorder();
            for (auto& piece : record.pieces) {
                if (!piece.state.stay || piece.state.stay->on_edge() != on_edge) continue;
                change(piece.state);
                break;
            }
            return audit(record);
        };
        EXPECT_FALSE(tampered([](auto& state) { state.velocity.x() += 1e-12; }).clean);
        EXPECT_FALSE(tampered([](auto& state) { state.climb += 1e-12; }).clean);
        EXPECT_FALSE(tampered([](auto& state) { state.height += 1e-12; }).clean);
        EXPECT_FALSE(tampered([](auto& state) { state.since += 1e-9; }).clean);
        EXPECT_FALSE(tampered([](auto& state) { state.position.x.hi += 1e-12; }).clean);
        // Gravity that is a millionth stronger.
        EXPECT_FALSE(tampered([](auto& state) {
                         state.stay = std::make_shared<const motion::RimTippingStay<double>>(
                             state.stay->rim(), kGravity * (1 + 1e-6), kRadius, 1,
                             motion::Hovering<double>{state.position, state.velocity, state.height,
                                                      state.climb},
                             state.stay->on_edge() ? motion::TippingStart::touches
                                                   : motion::TippingStart::lifts_off);
                     }).clean);
    }
    // An edge that is hit does not push along, and not more than its restitution says.
    const auto hit = [&](auto&& change) {
        auto record = engine.recorder();
        for (auto& event : record.events) {
            const auto& stay = event.before[0].stay;
            if (event.kind != engine::kTransition || !stay) continue;
            if (stay->end() != TippingEnd::edge) continue;
            change(event.after[0]);
            break;
        }
        return audit(record);
    };
    EXPECT_TRUE(hit([](auto&) {}).clean);
    EXPECT_FALSE(hit([](auto& after) { after.velocity.y() += 1e-9; }).clean);
    EXPECT_FALSE(hit([](auto& after) { after.climb += 1e-9; }).clean);
    auto softer = data;
    softer.motion.restitutions = {0.49};
    EXPECT_FALSE(
        engine::audit<Type>(softer, engine.recorder(), engine.bodies(), engine.time()).clean);
}

/// On the saddle, with no digit to tell, the run ends with a status.
TEST(TippingRims, ABallBalancedOnTheSeparatrixDoesNotHang) {
    // Level with the rim but for a rounding, and moving by none.
    auto data = scene();
    add(data, Vec(std::nextafter(kRim, 0.0), 0), Vec(0, 0));
    Engine engine(data);
    EXPECT_EQ(engine.run({60, 1000}), Status::at_rest);  // it falls the way it leans
    EXPECT_EQ(count(engine).falls, 1);

    // The two speeds next to the separatrix: the one falls, the other leaves.
    double in = 0, out = 1;
    const auto falls = [](double along, std::uint64_t& events) {
        auto scene_there = scene();
        add(scene_there, Vec(kRim + 0.01, 0), Vec(-0.2, along));
        Engine there(scene_there);
        there.run({5, 1000});
        events = there.event_count();
        return !there.bodies()[0].present;
    };
    for (int i = 0; i < 60; ++i) {
        std::uint64_t events = 0;
        const double middle = in + (out - in) / 2;
        (falls(middle, events) ? in : out) = middle;
        EXPECT_LT(events, 20U);
    }
    EXPECT_LE(out, std::nextafter(in, 1.0));
}

}  // namespace

#include <functional>

#include <gtest/gtest.h>

#include "support/cloth_tables.hpp"
#include "support/scalars.hpp"
#include "support/spinning.hpp"

// The audit of curved pieces: it passes what the engine does, and finds what was done to its record
// on purpose, every kind of fault by what is meant for it.
namespace osculo::support {
namespace {

using Scene = ClothTable<double>;
using Vec = math::Vec<double>;
using engine::RunAudit;
using motion::ClothPhase;
using State = motion::Cloth::State<double>;
using Piece = engine::PieceOf<Scene>;
using EventRecord = engine::EventOf<Scene>;
constexpr engine::Kind kSegment = engine::kFirstObstacle + 1;

TEST(CurvedAudit, PassesRandomTables) {
    double events = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const RunAudit rolling =
            play<RollingTable<double>>(rolling_table<double>(seed), 20, 1000).audit();
        EXPECT_TRUE(rolling.clean) << "seed " << seed << ": " << describe(rolling);
        const Played<Scene> played = play<Scene>(cloth_table<double>(seed), 20, 1000);
        const RunAudit audit = played.audit();
        EXPECT_TRUE(audit.clean) << "seed " << seed << ": " << describe(audit);
        EXPECT_GT(audit.worst_gap, -1e-12);
        EXPECT_LT(audit.largest_jump, 1e-12);
        events += static_cast<double>(played.events);
    }
    EXPECT_GT(events, 80'000);
}

// Found by a fuzzer: an impact that leaves a ball 1e-149 m/s, which is gone before instants can
// tell.
TEST(CurvedAudit, APhaseTooShortForInstantsMayEndWhereItBegins) {
    Builder<RollingTable<double>> builder;
    builder.scene.motion.deceleration = 0.01 * 9.81;
    builder.scene.contact_time = 1e-4;
    builder.box(-2, -2, 2, 2);
    builder.ball({-1, 0.007874015748031496}, {-1e-150, -1}, 0.1, 3);
    builder.ball({-1, -1}, {0, -1}, 0.1, 1);
    const Played<RollingTable<double>> played = play<RollingTable<double>>(builder.scene, 10, 100);
    const auto& events = played.record.events;
    const auto stop = std::ranges::find(events, engine::kTransition,
                                        &engine::EventOf<RollingTable<double>>::kind);
    ASSERT_NE(stop, events.end());
    EXPECT_EQ(stop->when, std::prev(stop)->when);
    EXPECT_NE(stop->before[0].velocity, stop->after[0].velocity);
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

template <class S>
class CurvedAuditOfScalar : public ::testing::Test {};
TYPED_TEST_SUITE(CurvedAuditOfScalar, AllScalars, ScalarName);

TYPED_TEST(CurvedAuditOfScalar, MeasuresInTheRoundingOfTheScalar) {
    using S = TypeParam;
    const double epsilon = math::to_double<S>(math::epsilon<S>());
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const RunAudit audit = play<ClothTable<S>>(cloth_table<S>(seed), S(20), 60).audit();
        EXPECT_TRUE(audit.clean) << "seed " << seed << ": " << describe(audit);
        EXPECT_GT(audit.worst_gap, -1000 * epsilon);
        EXPECT_LT(audit.largest_jump, 1000 * epsilon);
        EXPECT_LT(audit.largest_energy_gain, 20 * epsilon);
    }
}

TEST(CurvedAudit, ItsBoundsAreNotTenTimesTooLarge) {
    double change = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Played<Scene> played = play<Scene>(cloth_table<double>(seed), 20, 1000);
        for (const Piece& piece : played.record.pieces) {
            const State end = engine::end_of(piece);
            const double t = math::duration<double>(piece.from, piece.to);
            for (const EventRecord& event : played.record.events) {
                if (event.first != piece.ball || !(event.when == piece.to)) continue;
                change = std::max(change, engine::motion_change<double>(end, event.before[0]) /
                                              engine::motion_scale<double>(piece.state, t));
            }
        }
    }
    EXPECT_GT(change, math::kMotionNoise * math::epsilon<double>() / 10);

    Random random(31);
    double momentum = 0;
    for (int i = 0; i < 200'000; ++i) {
        Ball one = random_ball(random);
        Ball other = random_ball(random);
        const double sum = one.mass * one.velocity.norm() + other.mass * other.velocity.norm();
        const impact::Frictional<double> law{1, {random.uniform<double>(0, 4)}};
        Ball struck = one;
        Ball pushed = other;
        law.resolve(random.direction<double>(), struck, pushed);
        const Vec change_of_one = one.mass * (struck.velocity - one.velocity);
        const Vec change_of_other = other.mass * (pushed.velocity - other.velocity);
        if (!(sum > 0)) continue;
        momentum = std::max(momentum, (change_of_one + change_of_other).norm() / sum);
    }
    EXPECT_GT(momentum, math::kFrictionMomentum * math::epsilon<double>() / 10);
    EXPECT_LT(momentum, math::kFrictionMomentum * math::epsilon<double>());
}

/// A table on which everything happens: a run to rest.
Played<Scene> busy_table() {
    Builder<Scene> builder;
    builder.box(0, 0, 2, 1).arc({0.6, 0.45}, 0.1, {1, 0}, {-1, 0}, false).rim({1, 0.7}, 0.05);
    const double radius = 0.03;
    builder.ball({0.3, 0.5}, {5, 0.4}, radius, 0.17).ball({1.2, 0.62}, {0, 0}, radius, 0.17);
    builder.ball({1.3, 0.5}, {0, 0}, radius, 0.17).ball({1.5, 0.2}, {-1, 1}, radius, 0.2);
    builder.ball({0.5, 0.8}, {0.5, -2}, radius, 0.17);
    builder.ball({0.05, 0.05}, {0, 0}, radius, 0.17);
    for (auto& body : builder.scene.bodies) body.state.radius = radius;
    builder.scene.bodies[0].state.spin = {30, 80, 90};
    builder.scene.bodies[4].state.spin = {0, 0, -60};
    builder.scene.bodies[5].state.spin = {0, 0, 20};
    builder.scene.motion = {2, 0.1, 0.1};
    builder.scene.contact_time = 1e-4;
    builder.scene.friction.ball_ball = {0.95, {0.06, 0, 0}};
    builder.scene.friction.ball_cushion = {0.85, 0.2, 0.036};
    return play<Scene>(builder.scene, 100);
}

/// A fault, and what the audit must say of it.
struct Fault {
    const char* name;
    std::function<void(Played<Scene>&)> plant;
    std::function<bool(const RunAudit&)> found;
};

Piece& piece_in(Played<Scene>& played, ClothPhase phase, double least_time = 0.01) {
    for (Piece& piece : played.record.pieces) {
        const bool first = piece.from.hi == 0 && phase != ClothPhase::spinning;
        if (piece.state.phase == phase && !first &&
            math::duration<double>(piece.from, piece.to) > least_time) {
            return piece;
        }
    }
    throw std::runtime_error("no such piece");
}
/// The phase of the ball in event k of a kind, counted from 0.
EventRecord& event_of(Played<Scene>& played, engine::Kind kind, int k = 0) {
    for (EventRecord& event : played.record.events) {
        if (event.kind == kind && k-- == 0) return event;
    }
    throw std::runtime_error("no such event");
}
EventRecord& transition_from(Played<Scene>& played, ClothPhase phase) {
    for (EventRecord& event : played.record.events) {
        if (event.kind == engine::kTransition && event.before[0].phase == phase) return event;
    }
    throw std::runtime_error("no such transition");
}
/// Lets the law begin the ball's motion anew in the last piece before an event and leaves out the
/// event and what follows for the ball: it goes on as if nothing had been there.
void miss(Played<Scene>& played, EventRecord& event) {
    const engine::BallIndex ball = event.first;
    auto& pieces = played.record.pieces;
    std::size_t before = 0;
    while (pieces[before].ball != ball || !(pieces[before].to == event.when)) ++before;
    std::size_t after = 0;
    while (pieces[after].ball != ball || !(pieces[after].from == event.when)) ++after;
    pieces[before].to = pieces[before].from + pieces[before].state.remaining;
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(after));
    played.record.events.erase(played.record.events.begin() +
                               (&event - played.record.events.data()));
}

/// What is done to pieces only, so that nothing but the motion law can tell.
Fault unlawful(const char* name, ClothPhase phase, std::function<void(Piece&)> change) {
    return {name, [=](Played<Scene>& played) { change(piece_in(played, phase)); },
            [](const RunAudit& a) { return a.unexplained > 0; }};
}

std::vector<Fault> faults() {
    const auto gap = [](const RunAudit& a) { return a.worst_gap < -1e-3; };
    const auto jump = [](const RunAudit& a) { return a.largest_jump > 1e-10; };
    const auto unexplained = [](const RunAudit& a) { return a.unexplained > 0; };
    return {
        {"a ball goes through a cushion",
         [](Played<Scene>& played) { miss(played, event_of(played, kSegment)); },
         [=](const RunAudit& a) {
             return gap(a) && unexplained(a) && a.worst_second.kind == kSegment;
         }},
        {"a ball goes through another one",
         [](Played<Scene>& played) { miss(played, event_of(played, engine::kBallBall)); },
         [=](const RunAudit& a) { return gap(a) && unexplained(a); }},
        {"a transition is missing, the pieces are right",
         [](Played<Scene>& played) {
             auto& events = played.record.events;
             events.erase(events.begin() +
                          (&transition_from(played, ClothPhase::sliding) - events.data()));
         },
         [=](const RunAudit& a) { return unexplained(a) && a.worst_gap > -1e-13; }},
        {"a transition is too late by 1e-9 s",
         [](Played<Scene>& played) {
             auto& event = transition_from(played, ClothPhase::rolling);
             event.when = event.when + 1e-9;
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"a transition changes the velocity",
         [](Played<Scene>& played) {
             transition_from(played, ClothPhase::sliding).after[0].velocity.x() += 1e-9;
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"a transition changes the spin",
         [](Played<Scene>& played) {
             transition_from(played, ClothPhase::rolling).after[0].spin.z() += 1e-9;
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"a transition moves the ball",
         [](Played<Scene>& played) {
             auto& x = transition_from(played, ClothPhase::sliding).after[0].position.x;
             x = x + 1e-9;
         },
         [=](const RunAudit& a) { return jump(a); }},
        {"a spin changes in its last digit without an event",
         [](Played<Scene>& played) {
             double& w = piece_in(played, ClothPhase::sliding).state.spin.z();
             w = std::nextafter(w, 1e9);
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"a velocity changes in its last digit without an event",
         [](Played<Scene>& played) {
             double& v = piece_in(played, ClothPhase::rolling).state.velocity.y();
             v = std::nextafter(v, 1e9);
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        unlawful("a slide is 1e-12 too weak", ClothPhase::sliding,
                 [](Piece& p) { p.state.half_acceleration *= 1 - 1e-12; }),
        unlawful("a slide turns by 1e-12", ClothPhase::sliding,
                 [](Piece& p) {
                     Vec& a = p.state.half_acceleration;
                     a += 1e-12 * Vec(-a.y(), a.x());
                 }),
        unlawful("a slide twists 1e-12 too much", ClothPhase::sliding,
                 [](Piece& p) { p.state.spin_rate *= 1 + 1e-12; }),
        unlawful("rolling does not slow down", ClothPhase::rolling,
                 [](Piece& p) {
                     p.state.half_acceleration = {0, 0};
                 }),
        unlawful("rolling speeds up", ClothPhase::rolling,
                 [](Piece& p) { p.state.half_acceleration *= -1; }),
        unlawful("spin wears off 1e-12 too fast", ClothPhase::sliding,
                 [](Piece& p) { p.state.spin_decay *= 1 + 1e-12; }),
        unlawful("a sliding ball is said to roll", ClothPhase::sliding,
                 [](Piece& p) { p.state.phase = ClothPhase::rolling; }),
        unlawful("a rolling ball is said to slide", ClothPhase::rolling,
                 [](Piece& p) { p.state.phase = ClothPhase::sliding; }),
        unlawful("a rolling ball is said to rest", ClothPhase::rolling,
                 [](Piece& p) { p.state.phase = ClothPhase::rest; }),
        unlawful("a spinning ball creeps", ClothPhase::spinning,
                 [](Piece& p) { p.state.half_acceleration.x() = 1e-12; }),
        unlawful("a ball grows", ClothPhase::rolling, [](Piece& p) { p.state.radius *= 1.001; }),
        {"a slide goes on for too long",
         [](Played<Scene>& played) {
             miss(played, transition_from(played, ClothPhase::sliding));
             for (Piece& piece : played.record.pieces) {
                 if (piece.state.phase == ClothPhase::sliding) piece.to = piece.to + 1e-6;
             }
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"an impact makes energy of spin",
         [](Played<Scene>& played) {
             EventRecord& event = event_of(played, kSegment);
             event.after[0].spin = event.before[0].spin * 20;
         },
         [=](const RunAudit& a) { return a.largest_energy_gain > 1e-3 && unexplained(a); }},
        {"an impact loses momentum, as does its piece",
         [](Played<Scene>& played) {
             EventRecord& event = event_of(played, engine::kBallBall);
             event.after[0].velocity *= 1 - 1e-9;
             for (Piece& piece : played.record.pieces) {
                 if (piece.ball != event.first || !(piece.from == event.when)) continue;
                 piece.state.velocity = event.after[0].velocity;
                 motion::Cloth::begin(played.scene.motion, piece.state);
             }
         },
         [=](const RunAudit& a) { return a.largest_momentum_error > 1e-11; }},
        {"things that touch go on approaching",
         [](Played<Scene>& played) {
             EventRecord& event = event_of(played, engine::kBallBall);
             event.after = event.before;
         },
         [=](const RunAudit& a) { return a.unexplained > 2; }},
        {"an impact far from everything",
         [](Played<Scene>& played) {
             EventRecord& event = event_of(played, engine::kBallBall);
             event.before[1].position.x = event.before[1].position.x + event.normal.x();
             event.after[1].position = event.before[1].position;
         },
         [=](const RunAudit& a) { return a.largest_contact_error > 1e-2 && jump(a); }},
        {"a capture changes the velocity",
         [](Played<Scene>& played) {
             event_of(played, engine::kFirstObstacle).after[0].velocity *= 0.5;
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"the final state is another one",
         [](Played<Scene>& played) { played.bodies[1].state.spin.z() += 1; },
         [=](const RunAudit& a) { return a.unexplained == 1; }},
        {"the run ended elsewhere",
         [](Played<Scene>& played) { played.bodies[1].state.position.y.hi += 1e-9; },
         [=](const RunAudit& a) { return jump(a) && a.unexplained == 0; }},
    };
}

TEST(CurvedAudit, FindsEveryFault) {
    const Played<Scene> clean = busy_table();
    EXPECT_TRUE(clean.audit().clean) << describe(clean.audit());
    EXPECT_EQ(clean.status, Status::at_rest);
    EXPECT_GT(clean.events, 25u);
    for (const Fault& fault : faults()) {
        Played<Scene> played = clean;
        fault.plant(played);
        const RunAudit audit = played.audit();
        EXPECT_FALSE(audit.clean) << fault.name << ": " << describe(audit);
        EXPECT_TRUE(fault.found(audit)) << fault.name << ": " << describe(audit);
    }
}

/// Runs that are right for other laws than those they are held against.
TEST(CurvedAudit, FindsRunsUnderOtherLaws) {
    const Played<Scene> clean = busy_table();
    const auto unexplained_after = [&](auto change) {
        Played<Scene> played = clean;
        change(played.scene);
        return played.audit().unexplained;
    };
    const double other = 1 + 1e-12;
    EXPECT_GT(unexplained_after([&](auto& scene) { scene.motion.sliding *= other; }), 5u);
    EXPECT_GT(unexplained_after([&](auto& scene) { scene.motion.rolling *= other; }), 5u);
    EXPECT_GT(unexplained_after([&](auto& scene) { scene.motion.spinning *= other; }), 5u);
    EXPECT_GT(unexplained_after([&](auto& scene) {
                  for (auto& body : scene.bodies) body.state.inertia *= other;
              }),
              5u);
}

/// Runs on a table that lacks something of the table they are held against: all that is wrong is
/// that they go through it.
TEST(CurvedAudit, FindsObstaclesThatAreNotThere) {
    const auto audit_with = [](auto add) {
        Builder<Scene> builder;
        builder.ball({0, 0}, {2, 0}, 0.1, 1);
        builder.scene.bodies[0].state.radius = 0.1;
        builder.scene.bodies[0].state.spin = {-60, 0, 0};  // curves to (2/3, 1/3) and on
        builder.scene.motion = {4, 0.1, 0.1};
        Played<Scene> played = play<Scene>(builder.scene, 10);
        EXPECT_TRUE(played.audit().clean);
        add(builder, played.record.pieces[0]);
        played.scene.obstacles = builder.scene.obstacles;
        return played.audit();
    };
    const auto on_the_way = [](const Piece& piece) {
        return Vec(engine::stretch(piece, piece.from, piece.from)
                       .at(math::Wide<double>(piece.state.remaining / 2))
                       .rounded());
    };
    const auto through = [](const RunAudit& audit, engine::Kind kind, double gap) {
        EXPECT_FALSE(audit.clean);
        EXPECT_EQ(audit.unexplained, 0u);
        EXPECT_EQ(audit.worst_second.kind, engine::kFirstObstacle + kind);
        EXPECT_NEAR(audit.worst_gap, gap, 1e-12) << describe(audit);
    };
    through(audit_with([&](auto& builder, const Piece& p) { builder.point(on_the_way(p)); }), 3,
            -1);
    through(audit_with([&](auto& builder, const Piece& p) {
                builder.wall(on_the_way(p) + Vec(-0.4, 0.4), on_the_way(p) + Vec(0.4, -0.4));
            }),
            1, -1);
    through(audit_with([&](auto& builder, const Piece& p) {
                builder.circle(on_the_way(p) + Vec(0.3, 0.4), 0.5);
            }),
            2, -1);
    through(audit_with([&](auto& builder, const Piece& p) { builder.rim(on_the_way(p), 0.02); }), 0,
            -0.2);
}

/// A ball rolls into a hole, but is not captured.
TEST(CurvedAudit, FindsAMissedCapture) {
    using Type = RollingTable<double>;
    Builder<Type> builder;
    builder.rim({0, 0}, 1).ball({-5, 0.3}, {3, 0}, 0.5);
    builder.scene.motion.deceleration = 0.5;
    Played<Type> played = play<Type>(builder.scene, 20);
    ASSERT_EQ(played.events, 1u);
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    EXPECT_GE(played.audit().worst_gap, -1e-15);

    played.record.events.clear();
    auto& piece = played.record.pieces[0];
    piece.to = math::Instant<double>(6.0);
    played.end = piece.to;
    played.bodies[0].present = true;
    played.bodies[0].state = engine::end_of(piece);
    const RunAudit audit = played.audit();
    EXPECT_FALSE(audit.clean);
    EXPECT_EQ(audit.unexplained, 0u) << describe(audit);
    EXPECT_NEAR(audit.worst_gap, -0.7 / 0.5, 1e-12);
    EXPECT_NEAR(audit.worst_gap_time, 2, 1e-12);  // 3 t - t^2 / 4 = 5
}

/// Energy counts the spin.
TEST(CurvedAudit, EnergyIsThatOfMovingAndTurning) {
    Builder<Scene> builder;
    builder.ball({0, 0}, {3, 4}, 0.5, 2);
    builder.scene.bodies[0].state.radius = 0.5;
    builder.scene.bodies[0].state.spin = {2, 4, -4};
    builder.scene.motion = {1, 0.5, 0.25};
    const RunAudit audit = play<Scene>(builder.scene, 100).audit();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_DOUBLE_EQ(audit.energy_initial, (25 + 0.4 * 9));
    EXPECT_EQ(audit.energy_final, 0);
}

}  // namespace
}  // namespace osculo::support

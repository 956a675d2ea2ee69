#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/random_tables.hpp"
#include "support/scalars.hpp"

// The audit passes what the engine does, and finds what was done to its record on purpose: every
// kind of fault, by the figure that is meant for it.
namespace osculo::support {
namespace {

using Scene = TableScene<double>;
using Vec = math::Vec<double>;
using engine::RunAudit;
using Record = engine::PieceRecorder<double>;

Played<Scene> sixteen_disks() {
    return play<Scene>(gas<Scene>(16, 0.3, 5).scene, 1e9, 400);
}

TEST(Audit, PassesARun) {
    const Played<Scene> played = sixteen_disks();
    const RunAudit audit = played.audit();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_EQ(audit.unexplained, 0u);
    EXPECT_LT(audit.worst_gap, 1e-14);
    EXPECT_GT(audit.worst_gap, -1e-14);
    EXPECT_LT(audit.largest_jump, 1e-14);
    EXPECT_LT(audit.largest_contact_error, 1e-14);
    EXPECT_NEAR(audit.energy_final / audit.energy_initial, 1, 1e-13);
}

TEST(Audit, ItsBoundsAreNotTenTimesTooLarge) {
    // Over ten thousand events something comes within a tenth of each.
    const Played<Scene> played = play<Scene>(gas<Scene>(16, 0.3, 5).scene, 1e9, 10'000);
    const RunAudit audit = played.audit();
    const double epsilon = math::epsilon<double>();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_GT(audit.largest_energy_gain, math::kImpactEnergy * epsilon / 10);
    EXPECT_GT(audit.largest_momentum_error, math::kImpactMomentum * epsilon / 10);
    double longest = 0;
    for (const auto& piece : played.record.pieces) {
        longest = std::max(longest, engine::path_length<double>(piece));
    }
    const double radius = played.scene.bodies[0].radius;
    EXPECT_GT(audit.largest_jump, math::kPieceJump * epsilon * longest / radius / 10);
}

template <class S>
class AuditOfScalar : public ::testing::Test {};
TYPED_TEST_SUITE(AuditOfScalar, AllScalars, ScalarName);

TYPED_TEST(AuditOfScalar, MeasuresInTheRoundingOfTheScalar) {
    using Type = TableScene<TypeParam>;
    const Played<Type> played = play<Type>(gas<Type>(6, 0.3, 5).scene, TypeParam(1e9), 60);
    const RunAudit audit = played.audit();
    const double epsilon = math::to_double<TypeParam>(math::epsilon<TypeParam>());
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_GT(audit.worst_gap, -100 * epsilon);
    EXPECT_LT(audit.largest_jump, 100 * epsilon);
    EXPECT_LT(audit.largest_energy_gain, 20 * epsilon);
}

// The slower of the two is not what resolves their gap: where each of them is has the rounding of
// its own speed times the instant.
TYPED_TEST(AuditOfScalar, AllowsFastBallsTheResolutionOfWhereTheyAre) {
    using S = TypeParam;
    using V = math::Vec<S>;
    for (const bool fast_first : {true, false}) {
        Builder<TableScene<S>> builder;
        builder.wall(V(S(0), S(9)), V(S(0), S(-9)), true);
        const auto add = [&](bool fast) {
            fast ? builder.ball(V(S(1), S(0)), V(S(0), S(0)), S(0.5), S(1))
                 : builder.ball(V(S(4), S(0)), V(S(-1), S(0)), S(0.5), S(1e15));
        };
        add(fast_first);
        add(!fast_first);
        const auto played = play<TableScene<S>>(builder.scene, S(1e3), 1000);
        EXPECT_EQ(played.events, 1000u);
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    }
}

TEST(Audit, ReportsTheSmallestGapWhenNothingTouches) {
    Builder<Scene> builder;
    builder.ball({0, 0}, {1, 0}, 1).ball({10, 5}, {-1, 0}, 2).ball({5, -40}, {0, 0}, 3);
    const RunAudit audit = play<Scene>(builder.scene, 10).audit();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_DOUBLE_EQ(audit.worst_gap, 2);  // closest at distance 5, with radii 1 + 2, over 1
    EXPECT_DOUBLE_EQ(audit.worst_gap_time, 5);
    EXPECT_EQ(audit.worst_first.index + audit.worst_second.index, 1u);
    EXPECT_EQ(audit.worst_second.kind, engine::kBallBall);
}

TEST(Audit, HasNoGapWithoutTwoThings) {
    Builder<Scene> builder;
    builder.ball({0, 0}, {1, 0});
    const RunAudit audit = play<Scene>(builder.scene, 10).audit();
    EXPECT_TRUE(audit.clean);
    EXPECT_TRUE(std::isinf(audit.worst_gap));
    EXPECT_EQ(audit.worst_second.kind, engine::kNothing);
    EXPECT_DOUBLE_EQ(audit.energy_initial, 0.5);
    EXPECT_DOUBLE_EQ(audit.energy_final, 0.5);
}

/// A fault, and what the audit must say of it.
struct Fault {
    const char* name;
    std::function<void(Played<Scene>&)> plant;
    std::function<bool(const RunAudit&)> found;
};

/// A piece of the middle of the run that is followed by another one of the same ball, and that one.
std::pair<std::size_t, std::size_t> successive_pieces(const Record& record) {
    const std::size_t first = record.pieces.size() / 2;
    std::size_t second = first + 1;
    while (record.pieces[second].ball != record.pieces[first].ball) ++second;
    return {first, second};
}
std::size_t middle_event(const Record& record, engine::Kind kind) {
    std::size_t k = record.events.size() / 2;
    while (record.events[k].kind != kind) ++k;
    return k;
}
constexpr engine::Kind kSegment = engine::kFirstObstacle + 1;

/// Takes event k out of the record and lets its balls go on as if nothing had been there until
/// their next event.
void drop_event(Record& record, std::size_t k) {
    const engine::EventRecord<double> event = record.events[k];
    record.events.erase(record.events.begin() + static_cast<std::ptrdiff_t>(k));
    std::vector<engine::BallIndex> balls{event.first};
    if (event.kind == engine::kBallBall) balls.push_back(event.second);
    for (const engine::BallIndex ball : balls) {
        std::size_t before = 0;
        while (record.pieces[before].ball != ball || !(record.pieces[before].to == event.when)) {
            ++before;
        }
        std::size_t after = 0;
        while (record.pieces[after].ball != ball || !(record.pieces[after].from == event.when)) {
            ++after;
        }
        record.pieces[before].to = record.pieces[after].to;
        record.pieces.erase(record.pieces.begin() + static_cast<std::ptrdiff_t>(after));
    }
}

std::vector<Fault> faults() {
    const auto gap = [](const RunAudit& audit) { return audit.worst_gap < -1e-3; };
    const auto jump = [](const RunAudit& audit) { return audit.largest_jump > 1e-10; };
    const auto unexplained = [](const RunAudit& audit) { return audit.unexplained > 0; };
    return {
        {"an event of two balls is missing and they go straight on",
         [](Played<Scene>& played) {
             drop_event(played.record, middle_event(played.record, engine::kBallBall));
         },
         [=](const RunAudit& a) { return gap(a) && jump(a) && unexplained(a); }},
        {"a ball goes through a wall",
         [](Played<Scene>& played) {
             drop_event(played.record, middle_event(played.record, kSegment));
         },
         [=](const RunAudit& a) {
             return gap(a) && jump(a) && unexplained(a) && a.worst_second.kind == kSegment;
         }},
        {"an event is missing, the pieces are right",
         [](Played<Scene>& played) {
             played.record.events.erase(played.record.events.begin() + 100);
         },
         [=](const RunAudit& a) { return unexplained(a) && a.worst_gap > -1e-14; }},
        {"an event is too late by 1e-9 s",
         [](Played<Scene>& played) {
             auto& event = played.record.events[100];
             event.when = event.when + 1e-9;
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"a piece begins too late by 1e-9 s",
         [](Played<Scene>& played) {
             const auto [first, second] = successive_pieces(played.record);
             auto& piece = played.record.pieces[second];
             piece.from = piece.from + 1e-9;
         },
         [=](const RunAudit& a) { return unexplained(a) && jump(a); }},
        {"a contact and all that belongs to it is too late by 1e-9 s",
         [](Played<Scene>& played) {
             Record& record = played.record;
             auto& event = record.events[middle_event(record, engine::kBallBall)];
             const math::Instant<double> late = event.when + 1e-9;
             for (auto& piece : record.pieces) {
                 const bool first = piece.ball == event.first;
                 if (!first && piece.ball != event.second) continue;
                 auto& moment = event.before[first ? 0 : 1];
                 if (piece.to == event.when) {
                     piece.to = late;
                     moment.position =
                         math::displaced<double>(moment.position, piece.velocity, 1e-9);
                     event.after[first ? 0 : 1].position = moment.position;
                 }
             }
             for (auto& piece : record.pieces) {
                 const bool first = piece.ball == event.first;
                 if (!first && piece.ball != event.second) continue;
                 if (piece.from == event.when) {
                     piece.from = late;
                     piece.position = event.before[first ? 0 : 1].position;
                 }
             }
             event.when = late;
         },
         [=](const RunAudit& a) { return a.worst_gap < -1e-10 && a.unexplained == 0; }},
        {"a velocity changes by 1e-6 without an event",
         [](Played<Scene>& played) {
             played.record.pieces[successive_pieces(played.record).second].velocity.x() += 1e-6;
         },
         [=](const RunAudit& a) { return unexplained(a) && a.largest_jump > 1e-9; }},
        {"a velocity changes in its last digit without an event",
         [](Played<Scene>& played) {
             double& v = played.record.pieces[successive_pieces(played.record).second].velocity.x();
             v = std::nextafter(v, 2);
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"an event hands over another velocity, as does its piece",
         [](Played<Scene>& played) {
             Record& record = played.record;
             auto& event = record.events[middle_event(record, engine::kBallBall)];
             event.after[0].velocity.x() += 1e-6;
             for (auto& piece : record.pieces) {
                 if (piece.ball == event.first && piece.from == event.when) {
                     piece.velocity = event.after[0].velocity;
                 }
             }
         },
         [=](const RunAudit& a) { return a.largest_momentum_error > 1e-8 && jump(a); }},
        {"an event makes energy",
         [](Played<Scene>& played) {
             auto& event = played.record.events[middle_event(played.record, kSegment)];
             event.after[0].velocity *= 1 + 1e-9;
         },
         [=](const RunAudit& a) { return a.largest_energy_gain > 1e-9 && unexplained(a); }},
        {"balls that touch go on approaching",
         [](Played<Scene>& played) {
             auto& event = played.record.events[middle_event(played.record, engine::kBallBall)];
             event.after[0].velocity = event.before[0].velocity;
             event.after[1].velocity = event.before[1].velocity;
         },
         [=](const RunAudit& a) { return a.unexplained > 2; }},
        {"a ball is moved by a thousandth of its radius",
         [](Played<Scene>& played) {
             auto& piece = played.record.pieces[successive_pieces(played.record).second];
             piece.position.x = piece.position.x + 1e-3 * played.scene.bodies[0].radius;
         },
         [=](const RunAudit& a) {
             return std::abs(a.largest_jump - 1e-3) < 1e-9 && a.unexplained == 0;
         }},
        {"a piece is missing",
         [](Played<Scene>& played) {
             const auto [first, second] = successive_pieces(played.record);
             auto& pieces = played.record.pieces;
             pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(second));
         },
         [=](const RunAudit& a) { return unexplained(a) && jump(a); }},
        {"a piece is there twice",
         [](Played<Scene>& played) { played.record.pieces.push_back(played.record.pieces.back()); },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"two events of one ball are in the wrong order",
         [](Played<Scene>& played) {
             std::swap(played.record.events[100], played.record.events[101]);
         },
         [=](const RunAudit& a) { return unexplained(a); }},
        {"two things collide at a distance",
         [](Played<Scene>& played) {
             auto& event = played.record.events[middle_event(played.record, engine::kBallBall)];
             const Vec away = 1e-3 * event.normal;
             event.before[1].position.x = event.before[1].position.x + away.x();
             event.before[1].position.y = event.before[1].position.y + away.y();
             event.after[1].position = event.before[1].position;
         },
         [=](const RunAudit& a) { return a.largest_contact_error > 1e-4 && jump(a); }},
        {"the final state is another one",
         [](Played<Scene>& played) { played.bodies[3].state.velocity.y() *= 1.5; },
         [=](const RunAudit& a) { return a.unexplained == 1; }},
        {"the run ended elsewhere",
         [](Played<Scene>& played) { played.bodies[3].state.position.y.hi += 1e-9; },
         [=](const RunAudit& a) { return jump(a) && a.unexplained == 0; }},
        {"the run ended later", [](Played<Scene>& played) { played.end = played.end + 1.0; },
         [=](const RunAudit& a) { return a.unexplained == 16; }},
    };
}

TEST(Audit, FindsEveryFault) {
    for (const Fault& fault : faults()) {
        Played<Scene> played = sixteen_disks();
        fault.plant(played);
        const RunAudit audit = played.audit();
        EXPECT_FALSE(audit.clean) << fault.name << ": " << describe(audit);
        EXPECT_TRUE(fault.found(audit)) << fault.name << ": " << describe(audit);
    }
}

TEST(Audit, FindsAMissedCapture) {
    Builder<Scene> builder;
    builder.rim({0, 0}, 1).ball({-5, 0.3}, {1, 0}, 0.5);
    Played<Scene> played = play<Scene>(builder.scene, 20);
    ASSERT_EQ(played.events, 1u);
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());

    played.record.events.clear();
    played.record.pieces[0].to = math::Instant<double>(20.0);
    played.bodies[0].present = true;
    played.bodies[0].state.position = math::WidePoint<double>(Vec(15, 0.3));
    const RunAudit audit = played.audit();
    EXPECT_FALSE(audit.clean);
    EXPECT_EQ(audit.unexplained, 1u) << describe(audit);  // the run ended at its capture
    EXPECT_NEAR(audit.worst_gap, -0.7 / 0.5, 1e-12);
    EXPECT_EQ(audit.worst_second, (engine::Thing{engine::kFirstObstacle, 0}));
}

TEST(Audit, FindsACaptureBesideTheRim) {
    Builder<Scene> builder;
    builder.rim({0, 0}, 1).ball({-5, 0.3}, {1, 0}, 0.5);
    Played<Scene> played = play<Scene>(builder.scene, 20);
    played.scene.bodies[0].state.position.x = -6.0;
    for (auto* moments : {&played.record.events[0].before, &played.record.events[0].after}) {
        for (auto& moment : *moments) moment.position.x = moment.position.x - 1.0;
    }
    played.record.pieces[0].position.x = -6.0;
    played.bodies[0].state.position.x = played.bodies[0].state.position.x - 1.0;
    const RunAudit audit = played.audit();
    EXPECT_FALSE(audit.clean);
    EXPECT_EQ(audit.unexplained, 0u) << describe(audit);
    EXPECT_GT(audit.largest_contact_error, 1);
}

TEST(Audit, AllowsTheOverlapThatASceneStartsWith) {
    for (const double overlap : {1e-16, 1e-12, 1e-9, 9e-8}) {
        Builder<Scene> builder;
        builder.ball({0, 0}, {-1, 0}, 1).ball({2 - overlap, 0}, {1, 0}, 1);
        const RunAudit audit = play<Scene>(builder.scene, 1).audit();
        EXPECT_TRUE(audit.clean) << describe(audit);
        EXPECT_NEAR(audit.worst_gap, -overlap, 3e-16);
    }
    Builder<Scene> builder;
    builder.ball({0, 0}, {-1, 0}, 1).ball({2 - 1e-5, 0}, {1, 0}, 1);
    EXPECT_FALSE(play<Scene>(builder.scene, 1).audit().clean);
}

TEST(Audit, WhatIsNoNumberStaysTheLargest) {
    RunAudit audit;
    double figure = 1;
    audit.note(figure, std::nan(""), false);
    audit.note(figure, 2, true);
    EXPECT_TRUE(std::isnan(figure));
    EXPECT_FALSE(audit.clean);
}

}  // namespace
}  // namespace osculo::support

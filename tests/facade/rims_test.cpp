#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "osculo/simulate.hpp"

/// Rims with the law paper, as the facade offers them.
namespace osculo {
namespace {

/// A hole of 60 mm, with a jaw on each side of its mouth, and two balls.
Scene hole(MotionLaw motion) {
    Scene scene;
    scene.motion = motion;
    scene.rims = {{"hole", {0, 0}, 0.06, RimLaw::paper}, {"far", {1, 0}, 0.06, RimLaw::capture}};
    scene.segments = {{"left", {-0.3, -0.08}, {0.02, -0.08}},
                      {"right", {-0.3, 0.08}, {0.02, 0.08}}};
    scene.arcs = {{"back", {0, 0}, 0.2, -1, 1}};
    const double radius = 0.028575;
    scene.balls = {{"a", 0.17, radius, {-0.25, 0.01}, {0.7, 0.02}},
                   {"b", 0.17, radius, {-0.06, 0}, {0, 0}}};
    scene.impacts.ball_ball.restitution = 0.95;
    scene.impacts.ball_cushion.restitution = 0.8;
    scene.limits.time = 20;
    return scene;
}

const Event* first_of(const Run& run, EventKind kind) {
    for (const Event& event : run.events) {
        if (event.kind == kind) return &event;
    }
    return nullptr;
}

double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(PaperRims, BallsComeInFallAndLeave) {
    Scene scene = hole(UniformMotion{});
    scene.balls.resize(1);
    const auto run = simulate(scene);
    EXPECT_EQ(run.status, Status::at_rest);
    const Event* entry = first_of(run, EventKind::rim_entry);
    const Event* fall = first_of(run, EventKind::capture);
    ASSERT_TRUE(entry && fall);
    EXPECT_EQ(run.ids(*entry)[1], "hole");
    EXPECT_NEAR(distance(entry->point, {0, 0}), 0.06, 1e-16);
    EXPECT_NEAR(distance(fall->point, {0, 0}), 0.06 - 0.028575, 1e-16);
    EXPECT_EQ(run.balls[0].fate, BallFate::captured);
    EXPECT_EQ(run.balls[0].rim, 0U);

    scene.balls[0].position = {-0.06 - 0.1, 0.04};
    scene.balls[0].velocity = {1, 0};
    const auto pass = simulate(scene);
    const Event* exit = first_of(pass, EventKind::rim_exit);
    ASSERT_TRUE(exit);
    EXPECT_EQ(pass.ids(*exit)[1], "hole");
    EXPECT_NEAR(distance(exit->point, {0, 0}), 0.06, 1e-16);
    EXPECT_NEAR(std::hypot(exit->after[0].velocity.x, exit->after[0].velocity.y), 1, 1e-15);
}

TEST(PaperRims, PiecesFollowEachOther) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        const auto run = simulate(hole(motion));
        std::vector<const Piece*> last(2, nullptr);
        int in_rims = 0;
        for (const Piece& piece : run.pieces) {
            in_rims += piece.phase == Phase::rim;
            if (const Piece* before = last[piece.ball]) {
                EXPECT_EQ(before->to, piece.from);
                const BallState end = run.along(*before, {before->to - before->from}).front();
                EXPECT_LE(distance(end.position, piece.position), 1e-15);
            }
            last[piece.ball] = &piece;
            const double middle = (piece.from + piece.to) / 2;
            const auto state = run.at(piece.ball, middle);
            ASSERT_TRUE(state);
            if (piece.phase == Phase::rim) {
                EXPECT_EQ(piece.rim, 0U);
                EXPECT_LE(distance(state->position, {0, 0}), 0.06 * (1 + 1e-15));
                EXPECT_GE(distance(state->position, {0, 0}), (0.06 - 0.028575) * (1 - 1e-15));
            }
        }
        EXPECT_GE(in_rims, 1);
        EXPECT_TRUE(first_of(run, EventKind::ball_ball));
    }
}

TEST(PaperRims, AreAuditedClean) {
    for (const MotionLaw& motion : {MotionLaw(UniformMotion{}), MotionLaw(RollingMotion{0.01})}) {
        const auto run = simulate(hole(motion), {.audit = true});
        ASSERT_TRUE(run.audit);
        EXPECT_TRUE(run.audit->clean) << run.audit->worst_gap << " " << run.audit->unexplained;
        EXPECT_LT(std::abs(run.audit->worst_gap), 1e-13);  // something touched
        EXPECT_LE(run.audit->energy_final, run.audit->energy_initial * (1 + 1e-14));
    }
}

/// The same events whatever the precision, at the same times.
TEST(PaperRims, PrecisionsAgree) {
    const Scene scene = hole(RollingMotion{0.01});
    const auto run = simulate(scene);
    for (const Precision precision : {Precision::extended, Precision::quad, Precision::digits50}) {
        const auto wider = simulate(scene, {.precision = precision});
        ASSERT_EQ(wider.events.size(), run.events.size()) << to_string(precision);
        for (std::size_t i = 0; i < run.events.size(); ++i) {
            EXPECT_EQ(wider.events[i].kind, run.events[i].kind);
            EXPECT_NEAR(wider.events[i].time, run.events[i].time, 1e-9);
        }
    }
}

TEST(PaperRims, EnginesAreAsNarrowAsWithoutThem) {
    Scene scene = hole(UniformMotion{});
    EXPECT_NE(choose_engine(scene).name.find("rolling+rims"), std::string::npos);
    scene.rims[0].law = RimLaw::capture;
    EXPECT_EQ(choose_engine(scene).name.find("+rims/"), std::string::npos);
}

TEST(PaperRims, ScenesThatMakeNoSenseAreRefused) {
    struct Case {
        const char* path;
        std::function<void(Scene&)> spoil;
    };
    const Case cases[] = {
        {"rims[0].law", [](Scene& s) { s.motion = ClothMotion{}; }},
        {"gravity", [](Scene& s) { s.gravity = 0; }},
        {"balls[0].radius", [](Scene& s) { s.rims[0].radius = s.balls[1].radius; }},
        {"rims[1].center",
         [](Scene& s) {
             s.rims[1] = {"near", {0.1, 0}, 0.06, RimLaw::paper};
         }},
        {"balls[1].position",
         [](Scene& s) {
             s.balls[1].position = {-0.02, 0};
         }},
    };
    for (const Case& c : cases) {
        Scene scene = hole(UniformMotion{});
        EXPECT_NO_THROW(validate(scene));
        c.spoil(scene);
        try {
            validate(scene);
            FAIL() << "accepted: " << c.path;
        } catch (const SceneError& error) {
            EXPECT_EQ(error.path(), c.path) << error.what();
        }
    }
}

/// A rim that balls may cross closes nothing.
TEST(PaperRims, CloseNoOutline) {
    Scene scene = hole(UniformMotion{});
    scene.balls.resize(1);
    scene.balls[0].position = {0.5, 0.5};
    scene.arcs.clear();
    scene.segments = {{"1", {0, 0}, {0.9, 0}},
                      {"2", {1, 0.1}, {1, 1}},
                      {"3", {1, 1}, {0, 1}},
                      {"4", {0, 1}, {0, 0}}};
    scene.rims = {{"hole", {1, 0}, 0.11, RimLaw::capture}};
    scene.closed = true;
    EXPECT_NO_THROW(validate(scene));
    scene.rims[0].law = RimLaw::paper;
    EXPECT_THROW(validate(scene), SceneError);
}

}  // namespace
}  // namespace osculo

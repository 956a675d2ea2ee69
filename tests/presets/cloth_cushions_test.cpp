#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "support/random.hpp"

// Random shots with five balls on a pool table, with each law that a cushion can have on cloth.
namespace osculo {
namespace {

constexpr int kShots = 300;

/// Five balls apart from each other, on the 7 ft table's bed.
Scene random_shot(support::Random& random, CushionLaw law) {
    Scene scene;
    presets::add_table(scene, "pool-7ft");
    scene.motion = ClothMotion{0.2, 0.01, 0.0127};
    scene.impacts.ball_ball = {BallBallLaw::frictional, 0.95, {0.009951, 0.108, 1.088}};
    scene.impacts.ball_cushion = {law, 0.85, law == CushionLaw::restitution ? 0 : 0.2, 0.036576};
    if (random.coin()) scene.impacts.ball_cushion.cloth_friction = 0.15;
    for (int i = 0; i < 5; ++i) {
        Ball ball{std::to_string(i), 0.17, 0.028575, {}, {}};
        bool apart = false;
        while (!apart) {
            ball.position = {random.uniform(0.05, 0.9), random.uniform(0.05, 1.9)};
            apart = true;
            for (const Ball& other : scene.balls) {
                apart = apart && std::hypot(ball.position.x - other.position.x,
                                            ball.position.y - other.position.y) > 0.06;
            }
        }
        scene.balls.push_back(ball);
    }
    if (random.coin()) {
        Cue cue;
        cue.ball = "0";
        cue.speed = random.uniform(0.5, 6.0);
        cue.azimuth = random.uniform(0.0, 6.28);
        cue.elevation = random.uniform(0.0, 0.3);
        cue.offset = {random.uniform(-0.35, 0.35), random.uniform(-0.35, 0.35)};
        cue.allow_obstructed = true;
        scene.cue = cue;
    } else {  // all at once, with any spin
        for (Ball& ball : scene.balls) {
            const math::Vec<double> v = random.direction<double>() * random.uniform(0.0, 4.0);
            ball.velocity = {v.x(), v.y()};
            for (double& w : ball.spin) w = random.uniform(-100.0, 100.0);
        }
    }
    return scene;
}

/// Kinetic energy [J].
double energy(const Ball& ball, const BallState& state) {
    const double v2 = state.velocity.x * state.velocity.x + state.velocity.y * state.velocity.y;
    double w2 = 0;
    for (const double w : state.spin) w2 += w * w;
    return ball.mass / 2 * (v2 + ball.inertia * ball.radius * ball.radius * w2);
}

bool is_finite(const BallState& s) {
    return std::isfinite(s.position.x + s.position.y + s.velocity.x + s.velocity.y + s.spin[0] +
                         s.spin[1] + s.spin[2]);
}

class ClothCushions : public testing::TestWithParam<CushionLaw> {};
INSTANTIATE_TEST_SUITE_P(Law, ClothCushions,
                         testing::Values(CushionLaw::restitution, CushionLaw::han_2005,
                                         CushionLaw::mathavan_2010, CushionLaw::stronge),
                         [](const auto& law) { return std::string(to_string(law.param)); });

TEST_P(ClothCushions, ShotsComeToRestWithoutGainingEnergy) {
    support::Random random(61);
    int at_cushions = 0;
    for (int i = 0; i < kShots; ++i) {
        const Scene scene = random_shot(random, GetParam());
        const auto run = simulate(scene, {.record = Record::events});
        ASSERT_EQ(run.status, Status::at_rest) << "shot " << i << " at " << run.time << " s";
        for (const FinalBall& ball : run.balls) ASSERT_TRUE(is_finite(ball.state)) << i;
        double last = 0;
        for (const Event& event : run.events) {
            ASSERT_GE(event.time, last) << i;
            last = event.time;
            double before = 0;
            double after = 0;
            const bool pair = event.kind == EventKind::ball_ball;
            for (std::size_t k = 0; k < (pair ? 2 : 1); ++k) {
                const Ball& ball = scene.balls[k == 0 ? event.ball : event.other];
                ASSERT_TRUE(is_finite(event.before[k]) && is_finite(event.after[k])) << i;
                before += energy(ball, event.before[k]);
                after += energy(ball, event.after[k]);
            }
            // Balls that are pressed together may gain a little (osculo/impact/pressing.hpp).
            const double sliding = std::get<ClothMotion>(scene.motion).sliding_friction;
            const double speed =
                (pair ? 2 : 1) * sliding * scene.gravity * scene.impacts.contact_time;
            const double mass = scene.balls[event.ball].mass / (pair ? 2 : 1);
            EXPECT_LE(after, before * (1 + 1e-12) + mass * speed * speed / 8)
                << "shot " << i << " at " << event.time << " s, kind "
                << static_cast<int>(event.kind);
            at_cushions += event.kind == EventKind::ball_segment;
        }
    }
    EXPECT_GT(at_cushions, kShots);
}

TEST_P(ClothCushions, HaveAnEngineOfTheirOwn) {
    support::Random random(62);
    const EngineInfo info = choose_engine(random_shot(random, GetParam()), {});
    const std::string law =
        GetParam() == CushionLaw::restitution ? "simple" : std::string(to_string(GetParam()));
    EXPECT_NE(info.name.find("cloth/" + law + "/"), std::string::npos) << info.name;
}

}  // namespace
}  // namespace osculo

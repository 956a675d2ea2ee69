#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

// The three stages, and shots at random on them: as many as OSCULO_SHOTS says, on each.
namespace osculo {
namespace {

constexpr const char* kStages[]{"stage-funnel", "stage-islands", "stage-bumpers"};

int shots() {
    const char* const given = std::getenv("OSCULO_SHOTS");
    return given != nullptr ? std::atoi(given) : 100;
}

/// The stage with its player going anywhere at 0.05 to 6 m/s.
Scene random_shot(const char* name, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Scene scene = presets::make(name);
    const double speed = 0.05 + 5.95 * uniform();
    const double angle = 6.283185307179586 * uniform();
    scene.balls[0].velocity = {speed * std::cos(angle), speed * std::sin(angle)};
    return scene;
}

/// Whether what has kept the run from coming to rest is in holes: nothing slows a ball down there,
/// and one that has been struck in one may circle for ever.
bool only_circles(const osculo::Run& run) {
    std::vector<const Piece*> last(run.balls.size(), nullptr);
    for (const Piece& piece : run.pieces) last[piece.ball] = &piece;
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        const bool moves = run.balls[i].fate == BallFate::moving;
        if (moves && (last[i] == nullptr || last[i]->phase != Phase::rim)) return false;
    }
    return run.status == Status::time_limit;
}

TEST(Stages, HaveHolesAndBallsOfSeveralSizes) {
    for (const char* name : kStages) {
        const Scene scene = presets::make(name);
        EXPECT_TRUE(scene.closed) << name;
        EXPECT_FALSE(scene.rims.empty()) << name;
        EXPECT_FALSE(scene.arcs.empty()) << name;
        double least = 1e9;
        double most = 0;
        for (const Ball& ball : scene.balls) {
            least = std::min(least, ball.mass);
            most = std::max(most, ball.mass);
        }
        EXPECT_GT(most, 4 * least) << name;
        EXPECT_EQ(presets::make(name, {.speed = 1.0}).balls[0].velocity.x * 2,
                  presets::make(name, {.speed = 2.0}).balls[0].velocity.x);
    }
}

TEST(Stages, EndAtRest) {
    for (const char* name : kStages) {
        const osculo::Run run = simulate(presets::make(name));
        EXPECT_EQ(run.status, Status::at_rest) << name;
        EXPECT_GT(run.event_count, 10U) << name;
    }
}

TEST(Stages, RandomShotsEndAndTheirAuditIsClean) {
    int fallen = 0;
    for (const char* name : kStages) {
        for (int shot = 0; shot < shots(); ++shot) {
            const auto seed = static_cast<std::uint64_t>(shot);
            const Scene scene = random_shot(name, seed);
            Options options;
            options.audit = true;
            const osculo::Run run = simulate(scene, options);
            ASSERT_TRUE(run.status == Status::at_rest || only_circles(run))
                << name << ", seed " << seed << ": " << to_string(run.status);
            ASSERT_TRUE(run.audit->clean)
                << name << ", seed " << seed << ": gap " << run.audit->worst_gap << ", energy "
                << run.audit->largest_energy_gain << ", unexplained " << run.audit->unexplained;
            for (const FinalBall& ball : run.balls) fallen += ball.fate == BallFate::captured;
        }
    }
    EXPECT_GT(fallen, shots() / 10);
}

}  // namespace
}  // namespace osculo

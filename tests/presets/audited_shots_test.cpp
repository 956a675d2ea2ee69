#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

// Random breaks and shots on the 7 ft table, with every curved motion: nothing overlaps, nothing is
// made from nothing, and every piece is what its law says.
namespace osculo {
namespace {

class Shots {
public:
    explicit Shots(unsigned seed) : random_(seed) {}

    /// A number in [low, high).
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }

    /// A rack, broken from anywhere behind the head string.
    Scene broken_rack() {
        Scene scene = table();
        const double gap = random_() % 2 == 0 ? 0 : number(0, 1e-3);
        place("cue", scene, number(0.1, 0.9), number(0.1, 0.5));
        presets::add_rack(scene, "eight-ball", {.gap = gap});
        return aimed(scene, number(1.5, 1.65));
    }

    /// A few balls anywhere.
    Scene shot() {
        Scene scene = table();
        const auto balls = 2 + random_() % 8;
        for (unsigned k = 0; k < balls; ++k) {
            const std::string id = k == 0 ? "cue" : std::to_string(k);
            for (bool placed = false; !placed;) {
                placed = place(id, scene, number(0.04, 0.95), number(0.04, 1.94));
            }
        }
        return aimed(scene, number(0, 6.28));
    }

private:
    static Scene table() {
        Scene scene;
        presets::add_table(scene, "pool-7ft");
        scene.limits.time = 60;
        return scene;
    }

    /// False if there is a ball already.
    static bool place(const std::string& id, Scene& scene, double x, double y) {
        for (const Ball& other : scene.balls) {
            if (std::hypot(other.position.x - x, other.position.y - y) < 0.0573) return false;
        }
        Ball ball;
        ball.id = id;
        ball.mass = 0.170097;
        ball.radius = 0.028575;
        ball.position = {x, y};
        scene.balls.push_back(ball);
        return true;
    }

    /// With laws, and a strike.
    Scene aimed(Scene& scene, double azimuth) {
        const double speed = number(0.3, 10);
        BallBallImpact& balls = scene.impacts.ball_ball;
        CushionImpact& cushion = scene.impacts.ball_cushion;
        balls.restitution = number(0.9, 1);
        cushion.restitution = number(0.7, 0.95);
        if (random_() % 4 == 0) {
            scene.motion = RollingMotion{number(0.005, 0.05)};
            for (Ball& ball : scene.balls) {
                if (ball.id != "cue") continue;
                ball.velocity = {speed * std::cos(azimuth), speed * std::sin(azimuth)};
            }
            return scene;
        }
        scene.motion = ClothMotion{number(0.1, 0.3), number(0.005, 0.02), number(0.005, 0.02)};
        if (random_() % 4 != 0) {
            balls.law = BallBallLaw::frictional;
            balls.friction = {0.009951, 0.108, 1.088};
        }
        if (random_() % 4 != 0) {
            cushion.law = CushionLaw::han_2005;
            cushion.friction = number(0, 0.3);
            cushion.height = 0.028575 * number(1, 1.4);
        }
        scene.cue = Cue{};
        scene.cue->ball = "cue";
        scene.cue->speed = speed;
        scene.cue->azimuth = azimuth;
        scene.cue->allow_obstructed = true;
        scene.cue->elevation = random_() % 2 == 0 ? 0 : number(0, 0.6);
        scene.cue->offset = {number(-0.35, 0.35), number(-0.35, 0.35)};
        return scene;
    }

    std::mt19937_64 random_;
};

void expect_clean(const Scene& scene, unsigned seed, std::uint64_t& events) {
    const Run run = simulate(scene, {.audit = true});
    ASSERT_TRUE(run.audit);
    const Audit& audit = *run.audit;
    EXPECT_TRUE(audit.clean) << "seed " << seed << ", gap " << audit.worst_gap << ", energy "
                             << audit.largest_energy_gain << ", jump " << audit.largest_jump
                             << ", unexplained " << audit.unexplained;
    EXPECT_GE(audit.worst_gap, -1e-12) << "seed " << seed;
    EXPECT_LT(audit.largest_jump, 1e-12) << "seed " << seed;
    EXPECT_EQ(audit.unexplained, 0U) << "seed " << seed;
    EXPECT_LE(audit.energy_final, audit.energy_initial) << "seed " << seed;
    EXPECT_GT(audit.energy_initial, 0) << "seed " << seed;
    events += run.event_count;
}

TEST(AuditedShots, RandomBreaksAreClean) {
    std::uint64_t events = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        expect_clean(Shots(seed).broken_rack(), seed, events);
    }
    EXPECT_GT(events, 20'000U);
}

TEST(AuditedShots, RandomShotsAreClean) {
    std::uint64_t events = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
        expect_clean(Shots(seed + 1000).shot(), seed, events);
    }
    EXPECT_GT(events, 8'000U);
}

}  // namespace
}  // namespace osculo

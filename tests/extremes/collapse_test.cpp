#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/extreme_scenes.hpp"

// Accumulating impacts: they are treated, or the run ends with `zeno`; the number of events is
// bounded, and energy never grows.
namespace osculo::support {
namespace {

constexpr std::uint64_t kBound = 20'000;

Scene lossy(double e) {
    Scene scene;
    scene.impacts.ball_ball.restitution = e;
    scene.impacts.ball_cushion.restitution = e;
    scene.limits = {1000, 1'000'000};
    return scene;
}

/// Ends properly, and at no event is there more energy than before it.
void expect_bounded(const Run& run, const std::string& name) {
    EXPECT_TRUE(run.status == Status::time_limit || run.status == Status::zeno) << name;
    EXPECT_LT(run.event_count, kBound) << name;
    EXPECT_TRUE(run.audit->clean) << name;
    EXPECT_LE(run.audit->energy_final, run.audit->energy_initial * (1 + 1e-13)) << name;
    for (const Event& event : run.events) {
        double gain = 0, scale = 0;
        for (std::size_t k = 0; k < (event.kind == EventKind::ball_ball ? 2U : 1U); ++k) {
            const std::size_t index = k == 0 ? event.ball : event.other;
            const Point u = event.before[k].velocity, v = event.after[k].velocity;
            const double mass = run.scene.balls[index].mass;
            gain += mass * (v.x * v.x + v.y * v.y - u.x * u.x - u.y * u.y);
            scale += mass * (u.x * u.x + u.y * u.y);
        }
        ASSERT_LE(gain, 1e-14 * scale) << name;
    }
}

TEST(Collapse, RowsOfThreeToTwenty) {
    for (const double e : {0.0, 0.1, 0.5}) {
        for (int count = 3; count <= 20; ++count) {
            for (const double gap : {0.0, 1e-12, 0.5}) {
                Scene scene = lossy(e);
                for (int k = 0; k < count; ++k) {
                    scene.balls.push_back(disk(std::to_string(k),
                                               {k == 0 ? -5 : (k - 1) * (2 + gap), 0},
                                               {k == 0 ? 1. : 0., 0}));
                }
                const auto run = played(scene);
                const std::string name = std::to_string(count) + " balls, e " + std::to_string(e) +
                                         ", gap " + std::to_string(gap);
                expect_bounded(run, name);
                double momentum = 0;
                for (std::size_t k = 0; k < run.balls.size(); ++k) {
                    momentum += run.balls[k].state.velocity.x;
                    if (k == 0) continue;  // still in their order, and none in another one
                    const double apart =
                        run.balls[k].state.position.x - run.balls[k - 1].state.position.x;
                    EXPECT_GE(apart, 2 - 1e-12) << name;
                }
                EXPECT_NEAR(momentum, 1, 1e-13) << name;
            }
        }
    }
}

TEST(Collapse, GasesCool) {
    for (const double e : {0.1, 0.5, 0.9}) {
        Scene scene = lossy(e);
        scene.segments = {{"bottom", {0, 0}, {18, 0}, Side::left},
                          {"right", {18, 0}, {18, 18}, Side::left},
                          {"top", {18, 18}, {0, 18}, Side::left},
                          {"left", {0, 18}, {0, 0}, Side::left}};
        for (int k = 0; k < 36; ++k) {
            const double turn = 2.399963229728653 * k;
            scene.balls.push_back(disk(std::to_string(k),
                                       {1.5 + 3.0 * (k % 6), 1.5 + 3.0 * (k / 6)},
                                       {std::cos(turn), std::sin(turn)}));
        }
        expect_bounded(played(scene), "e = " + std::to_string(e));
    }
}

/// Whether neighbours of a row have ended up together, or the run said so.
bool collapsed(const Run& run) {
    if (run.status == Status::zeno) return true;
    for (std::size_t k = 0; k + 1 < run.balls.size(); ++k) {
        const double v = run.balls[k].state.velocity.x - run.balls[k + 1].state.velocity.x;
        if (std::abs(v) < 1e-12) return true;
    }
    return false;
}

/// Three balls, or two and a wall, that come back to the same closing speeds times lambda after
/// each cycle, if e is below the threshold. An impact at one gap turns its closing speed u into -e
/// u and adds (1 + e) u to that of the other gap, or half of it where a ball is between two others.
struct Trio {
    bool wall;
    double e;
    double h = (1 + e) / 2;       ///< what an impact at the first gap adds to the second
    double g = wall ? 2 * h : h;  ///< and the other way round
    double half_trace = (g * h - 2 * e) / 2;
    double root = half_trace * half_trace - e * e;
    double lambda = half_trace + (root > 0 ? std::sqrt(root) : 0);
    double second = (lambda + e - g * h) / g;  ///< for 1 m/s at the first gap

    [[nodiscard]] Scene scene() const {
        Scene scene = lossy(e);
        scene.balls = {disk("0", {-2, 0}, {1 + second, 0}), disk("1", {0, 0}, {second, 0})};
        if (wall) {
            scene.segments = {wall_at(1.5)};
        } else {
            scene.balls.push_back(disk("2", {2.5, 0}));
        }
        return scene;
    }
    /// Impacts until nothing approaches, at most [most].
    [[nodiscard]] std::uint64_t count(std::uint64_t most) const {
        double u = 1, w = second;
        for (std::uint64_t n = 0; n < most; ++n) {
            double& own = n % 2 == 0 ? u : w;
            double& other = n % 2 == 0 ? w : u;
            if (!(own > 0)) return n;
            other += own * (n % 2 == 0 ? h : g);
            own *= -e;
        }
        return most;
    }
};

// Three balls collapse up to 7 - 4 sqrt(3), two and a wall up to 3 - 2 sqrt(2) (McNamara & Young
// 1992): a percent above, the number of impacts is that of the recursion.
TEST(Collapse, ThreeBallsAndTwoWithAWallHaveTheirThresholds) {
    for (const bool wall : {false, true}) {
        const double threshold = wall ? 3 - 2 * std::sqrt(2.0) : 7 - 4 * std::sqrt(3.0);
        for (const Precision precision :
             {Precision::double_precision, Precision::extended, Precision::quad}) {
            for (const double part : {0.2, 0.5, 0.9, 0.99}) {
                const auto run = played(Trio{wall, part * threshold}.scene(), precision);
                expect_bounded(run, std::to_string(part));
                EXPECT_TRUE(collapsed(run)) << wall << " " << part;
            }
            for (const double part : {1.01, 1.1, 1.5, 3.0}) {
                const Trio trio{wall, part * threshold};
                const auto run = played(trio.scene(), precision);
                expect_bounded(run, std::to_string(part));
                EXPECT_FALSE(collapsed(run)) << wall << " " << part;
                EXPECT_EQ(run.event_count, trio.count(1000)) << wall << " " << part;
            }
        }
    }
}

// N beads thrown at a wall collapse up to tan^2(pi / 4 (1 - 1 / N)) (Bernu & Mazighi 1990), give or
// take what the start makes of it.
TEST(Collapse, BeadsAtAWallHaveTheirThreshold) {
    for (const int beads : {4, 6, 10, 15}) {
        const double threshold = std::pow(std::tan(std::numbers::pi / 4 * (1 - 1.0 / beads)), 2);
        for (const double part : {0.93, 1.07}) {
            Scene scene = lossy(part * threshold);
            scene.segments = {wall_at(101)};
            for (int k = 0; k < beads; ++k) {
                scene.balls.push_back(disk(std::to_string(k), {2.5 * k, 0}, {1, 0}));
            }
            const auto run = played(scene);
            expect_bounded(run, std::to_string(beads));
            EXPECT_EQ(collapsed(run), part < 1) << beads << " beads, " << part;
        }
    }
}

// A light ball between a wall and a heavy one that rolls towards it and slows down.
TEST(Collapse, BetweenAWallAndASlowingBall) {
    for (const double e : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        for (const double speed : {0.05, 0.5, 5.0}) {
            Scene scene = lossy(e);
            scene.motion = RollingMotion{0.01};
            scene.segments = {wall_at(0)};
            scene.balls = {disk("light", {0.3, 0}, {}, 1, 0.1),
                           disk("heavy", {1, 0}, {-speed, 0}, 1000, 0.1)};
            const auto run = played(scene);
            EXPECT_TRUE(run.status == Status::at_rest || run.status == Status::zeno) << e;
            EXPECT_LT(run.event_count, kBound) << e << " " << speed;
            EXPECT_TRUE(run.audit->clean) << e << " " << speed;
            EXPECT_GE(run.balls[0].state.position.x, 0.1 - 1e-12);
            EXPECT_GE(run.balls[1].state.position.x, run.balls[0].state.position.x + 0.2 - 1e-12);
        }
    }
}

}  // namespace
}  // namespace osculo::support

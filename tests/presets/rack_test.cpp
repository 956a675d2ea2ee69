#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"

namespace osculo::presets {
namespace {

constexpr double kRadius = 0.028575;

std::vector<Ball> rack(double gap) {
    Scene scene;
    add_table(scene, "pool-7ft");
    add_rack(scene, "eight-ball", gap);
    return scene.balls;
}

const Ball& ball(const std::vector<Ball>& balls, const std::string& id) {
    return *std::ranges::find(balls, id, &Ball::id);
}

TEST(EightBallRack, HasFifteenNumberedBalls) {
    const std::vector<Ball> balls = rack(0);
    std::set<std::string> ids;
    for (const Ball& each : balls) ids.insert(each.id);
    EXPECT_EQ(ids.size(), 15U);
    for (int i = 1; i <= 15; ++i) EXPECT_EQ(ids.count(std::to_string(i)), 1U);
}

TEST(EightBallRack, StandsOnTheFootSpotAroundTheEight) {
    const std::vector<Ball> balls = rack(0);
    EXPECT_EQ(balls[0].position, (Point{0.4953, 1.4859}));
    EXPECT_DOUBLE_EQ(ball(balls, "8").position.x, 0.4953);
    EXPECT_DOUBLE_EQ(ball(balls, "8").position.y, 1.4859 + 2 * std::sqrt(3.0) * kRadius);
    // One solid and one striped ball in the corners of the last row.
    const int left = std::stoi(balls[10].id);
    const int right = std::stoi(balls[14].id);
    EXPECT_NE(left > 8, right > 8);
}

TEST(EightBallRack, NeighboursAreTheGapApart) {
    for (const double gap : {0.0, 1e-12, 1e-4, 0.02}) {
        const std::vector<Ball> balls = rack(gap);
        int neighbours = 0;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double distance = std::hypot(balls[i].position.x - balls[j].position.x,
                                                   balls[i].position.y - balls[j].position.y);
                EXPECT_GT(distance, 2 * kRadius + gap - 1e-15);
                if (distance < 2 * kRadius + gap + 1e-15) ++neighbours;
            }
        }
        EXPECT_EQ(neighbours, 30) << gap;  // the sides of the 16 small triangles, each once
    }
}

TEST(EightBallRack, FitsTheTableWithAnyGap) {
    for (const double gap : {0.0, kRadius}) {
        Scene scene;
        add_table(scene, "pool-7ft");
        add_rack(scene, "eight-ball", gap);
        EXPECT_NO_THROW(validate(scene)) << gap;
    }
    EXPECT_THROW(rack(-1e-9), SceneError);
    EXPECT_THROW(rack(0.03), SceneError);
    EXPECT_THROW(rack(std::nan("")), SceneError);
}

TEST(EightBallRack, NeedsAPoolTable) {
    Scene scene;
    EXPECT_THROW(add_rack(scene, "eight-ball", 0), SceneError);
    add_table(scene, "carom-10ft");
    EXPECT_THROW(add_rack(scene, "eight-ball", 0), SceneError);
    EXPECT_THROW(add_rack(scene, "nine-ball", 0), SceneError);
}

}  // namespace
}  // namespace osculo::presets

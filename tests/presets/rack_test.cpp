#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "osculo/presets.hpp"

namespace osculo::presets {
namespace {

constexpr double kRadius = 0.028575;

std::vector<Ball> rack(const char* table, const char* name, const RackOptions& options) {
    Scene scene;
    add_table(scene, table);
    add_rack(scene, name, options);
    EXPECT_NO_THROW(validate(scene)) << table << ' ' << name;
    return scene.balls;
}

std::vector<Ball> eight_ball(double gap) {
    return rack("pool-7ft", "eight-ball", {.gap = gap});
}

const Ball& ball(const std::vector<Ball>& balls, const std::string& id) {
    return *std::ranges::find(balls, id, &Ball::id);
}

std::set<std::string> ids(const std::vector<Ball>& balls) {
    std::set<std::string> result;
    for (const Ball& each : balls) result.insert(each.id);
    return result;
}

// Pairs whose surfaces are that far apart, within rounding; none may be nearer.
int neighbours(const std::vector<Ball>& balls, double gap) {
    int count = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double between = std::hypot(balls[i].position.x - balls[j].position.x,
                                              balls[i].position.y - balls[j].position.y) -
                                   balls[i].radius - balls[j].radius;
            EXPECT_GT(between, gap - 1e-15);
            if (between < gap + 1e-15) ++count;
        }
    }
    return count;
}

std::string error_of(const char* table, const char* name, const RackOptions& options = {}) {
    Scene scene;
    if (std::strlen(table) > 0) add_table(scene, table);
    try {
        add_rack(scene, name, options);
        return "no error";
    } catch (const SceneError& error) {
        return error.what();
    }
}

TEST(EightBallRack, HasFifteenNumberedBallsAndTheCueBall) {
    const std::vector<Ball> balls = eight_ball(0);
    EXPECT_EQ(balls.size(), 16U);
    EXPECT_EQ(ids(balls).size(), 16U);
    for (int i = 1; i <= 15; ++i) EXPECT_EQ(ids(balls).count(std::to_string(i)), 1U);
    EXPECT_EQ(ball(balls, "cue").position, (Point{0.4953, 0.4953}));  // the head spot
}

TEST(EightBallRack, StandsOnTheFootSpotAroundTheEight) {
    const std::vector<Ball> balls = eight_ball(0);
    EXPECT_EQ(balls[0].position, (Point{0.4953, 1.4859}));
    EXPECT_DOUBLE_EQ(ball(balls, "8").position.x, 0.4953);
    EXPECT_DOUBLE_EQ(ball(balls, "8").position.y, 1.4859 + 2 * std::sqrt(3.0) * kRadius);
    // One solid and one striped ball in the corners of the last row.
    const int left = std::stoi(balls[10].id);
    const int right = std::stoi(balls[14].id);
    EXPECT_NE(left > 8, right > 8);
}

TEST(Racks, NeighboursAreTheGapApart) {
    for (const double gap : {0.0, 1e-12, 1e-4, 0.02}) {
        // The sides of the 16 small triangles, each once.
        EXPECT_EQ(neighbours(eight_ball(gap), gap), 30) << gap;
        EXPECT_EQ(neighbours(rack("pool-9ft", "nine-ball", {.gap = gap}), gap), 16) << gap;
        // The reds are a triangle too, and the pink is behind one of them.
        EXPECT_EQ(neighbours(rack("snooker-12ft", "snooker", {.gap = gap}), gap), 31) << gap;
    }
}

TEST(Racks, FitEveryTableOfTheirGameWithAnyGap) {
    for (const double gap : {0.0, kRadius}) {
        for (const char* table : {"pool-7ft", "pool-8ft", "pool-9ft"}) {
            for (const char* name : {"eight-ball", "nine-ball"}) {
                static_cast<void>(rack(table, name, {.gap = gap}));
            }
        }
    }
    static_cast<void>(rack("snooker-12ft", "snooker", {.gap = 0.02619375}));
    for (const double gap : {-1e-9, 0.03, std::nan("")}) {
        EXPECT_NE(error_of("pool-7ft", "eight-ball", {.gap = gap}), "no error");
    }
}

TEST(NineBallRack, IsADiamondWithTheOneAtItsApexAndTheNineInIt) {
    const std::vector<Ball> balls = rack("pool-9ft", "nine-ball", {});
    EXPECT_EQ(ids(balls),
              (std::set<std::string>{"1", "2", "3", "4", "5", "6", "7", "8", "9", "cue"}));
    EXPECT_EQ(ball(balls, "1").position, (Point{0.635, 1.905}));
    EXPECT_DOUBLE_EQ(ball(balls, "9").position.x, 0.635);
    EXPECT_DOUBLE_EQ(ball(balls, "9").position.y, 1.905 + std::sqrt(3.0) * (2 * kRadius + 1e-4));
    EXPECT_EQ(ball(balls, "cue").position, (Point{0.635, 0.635}));
}

TEST(SnookerRack, HasItsColoursOnTheirSpots) {
    const std::vector<Ball> balls = rack("snooker-12ft", "snooker", {});
    EXPECT_EQ(balls.size(), 22U);
    EXPECT_EQ(ids(balls).size(), 22U);
    const auto place = [&](const char* id) { return ball(balls, id).position; };
    EXPECT_EQ(place("brown"), (Point{0.889, 0.737}));
    EXPECT_EQ(place("yellow"), (Point{0.889 + 0.292, 0.737}));
    EXPECT_EQ(place("green"), (Point{0.889 - 0.292, 0.737}));
    EXPECT_EQ(place("blue"), (Point{0.889, 3.569 / 2}));
    EXPECT_EQ(place("pink"), (Point{0.889, 0.75 * 3.569}));
    EXPECT_EQ(place("black"), (Point{0.889, 3.569 - 0.324}));
    EXPECT_NEAR(place("red-1").y - place("pink").y, 2 * 0.02619375 + 1e-4, 1e-15);
    const Point cue = place("cue");
    EXPECT_LE(std::hypot(cue.x - 0.889, cue.y - 0.737), 0.292);
    EXPECT_LE(cue.y, 0.737);
    EXPECT_EQ(ball(balls, "cue").mass, 0.14);
}

TEST(ThreeCushionRack, IsTheStartingPosition) {
    const std::vector<Ball> balls = rack("carom-10ft", "three-cushion", {});
    EXPECT_EQ(balls.size(), 3U);
    EXPECT_EQ(ball(balls, "red").position, (Point{0.71, 2.13}));
    EXPECT_EQ(ball(balls, "yellow").position, (Point{0.71, 0.71}));
    EXPECT_EQ(ball(balls, "cue").position, (Point{0.71 + 0.1825, 0.71}));
    EXPECT_EQ(ball(balls, "cue").radius, 0.03075);
}

TEST(Racks, LeaveOutTheCueBallIfThereIsOne) {
    Scene scene;
    add_table(scene, "pool-9ft");
    scene.balls.push_back({"cue", 0.17, 0.028, {0.3, 0.4}, {}, {}});
    add_rack(scene, "nine-ball");
    EXPECT_EQ(scene.balls.size(), 10U);
    EXPECT_EQ(scene.balls[0].position, (Point{0.3, 0.4}));
}

TEST(Racks, ASeedDisplacesEachBallWithinTheGap) {
    const struct {
        const char *table, *name;
    } kinds[]{{"pool-9ft", "eight-ball"}, {"pool-9ft", "nine-ball"}, {"snooker-12ft", "snooker"}};
    for (const auto& [table, name] : kinds) {
        const std::vector<Ball> regular = rack(table, name, {.gap = 2e-4});
        EXPECT_NE(rack(table, name, {.gap = 2e-4, .seed = 8}),
                  rack(table, name, {.gap = 2e-4, .seed = 7}));
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            const std::vector<Ball> shaken = rack(table, name, {.gap = 2e-4, .seed = seed});
            EXPECT_EQ(shaken, rack(table, name, {.gap = 2e-4, .seed = seed}));
            EXPECT_EQ(neighbours(shaken, 0), 0) << seed;
            int moved = 0;
            for (std::size_t i = 0; i < regular.size(); ++i) {
                const double by = std::hypot(shaken[i].position.x - regular[i].position.x,
                                             shaken[i].position.y - regular[i].position.y);
                EXPECT_LE(by, 1e-4);
                moved += by > 0;
            }
            EXPECT_EQ(moved, regular.size() == 10 ? 9 : 15);  // what has a spot stays on it
        }
        EXPECT_EQ(rack(table, name, {.gap = 0, .seed = 5}), rack(table, name, {.gap = 0}));
    }
}

// The same bits with every compiler and machine: this was computed once.
TEST(Racks, ASeedGivesTheSameBitsEverywhere) {
    const std::vector<Ball> balls = rack("pool-9ft", "eight-ball", {.gap = 2e-4, .seed = 7});
    EXPECT_EQ(balls[0].position.x, 0x1.45185c43dbb05p-1);
    EXPECT_EQ(balls[14].position.y, 0x1.0d43f27791cd2p+1);
}

TEST(Racks, NeedTheTableOfTheirGame) {
    EXPECT_EQ(error_of("", "eight-ball"),
              "rack: needs a pool table to stand on, but it is \"eight-ball\" without one");
    EXPECT_EQ(error_of("carom-10ft", "eight-ball"),
              "rack: needs a pool table to stand on, but it is \"eight-ball\" on carom-10ft");
    EXPECT_EQ(error_of("pool-9ft", "snooker"),
              "rack: needs a snooker table to stand on, but it is \"snooker\" on pool-9ft");
    EXPECT_EQ(error_of("snooker-12ft", "three-cushion"),
              "rack: needs a carom table to stand on, but it is \"three-cushion\" on snooker-12ft");
    EXPECT_EQ(error_of("carom-10ft", "three-cushion", {.seed = 3}),
              "rack: must have neighbours to take a gap or a seed, but it is \"three-cushion\"");
    EXPECT_EQ(error_of("pool-9ft", "nine-bal"),
              "rack: must be \"eight-ball\", \"nine-ball\", \"snooker\" or \"three-cushion\", did "
              "you mean nine-ball?, but it is \"nine-bal\"");
}

}  // namespace
}  // namespace osculo::presets

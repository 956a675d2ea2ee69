#include <algorithm>

#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"

// Frozen combinations: rows and racks of balls at spacings from 0 to a millimetre. The outcome may
// depend on the spacing; that nothing passes through anything and that the run ends may not.
namespace osculo::support {
namespace {

constexpr double kSpacings[] = {0,    1e-15, 1e-14, 1e-13, 1e-12, 1e-10,
                                1e-8, 1e-7,  1e-6,  1e-5,  1e-4,  1e-3};

TEST(Frozen, RowsOfTwoToEight) {
    for (const double angle : {0.0, 0.7}) {
        const Point along{std::cos(angle), std::sin(angle)};
        for (int balls = 2; balls <= 8; ++balls) {
            for (const double spacing : kSpacings) {
                for (const double speed : {1.0, 6.0}) {
                    Scene scene = cloth_scene();
                    const auto at = [&along](double distance) {
                        return Point{distance * along.x, distance * along.y};
                    };
                    scene.balls.push_back(pool_ball("0", at(-0.5), at(speed)));
                    for (int k = 0; k < balls; ++k) {
                        scene.balls.push_back(pool_ball(std::string(1, static_cast<char>('1' + k)),
                                                        at(k * (2 * kPoolRadius + spacing))));
                    }
                    const auto run = settled(scene);
                    OSCULO_EXPECT_SOUND(run);
                    EXPECT_LE(run.event_count, 20'000U) << balls << " at " << spacing;
                    // They are still in the order of the row.
                    double last = -1e9;
                    for (const FinalBall& ball : run.balls) {
                        const Point p = ball.state.position;
                        const double place = p.x * along.x + p.y * along.y;
                        EXPECT_GT(place, last) << balls << " at " << spacing;
                        last = place;
                    }
                    // The last one has been sent off.
                    const Point p = run.balls.back().state.position;
                    EXPECT_GT(std::hypot(p.x, p.y), (balls - 1) * 2 * kPoolRadius + 1e-3);
                }
            }
        }
    }
}

TEST(Frozen, RacksAtEverySpacing) {
    for (const double spacing : kSpacings) {
        for (const double aside : {0.0, 0.003}) {
            Scene scene = cloth_scene();
            presets::add_table(scene, "pool-7ft");
            scene.balls.push_back(pool_ball("cue", {0.9906 / 2 + aside, 0.5}, {0, 8}));
            const double row_height = (2 * kPoolRadius + spacing) * std::sqrt(0.75);
            for (int row = 0, id = 1; row < 5; ++row) {
                for (int column = 0; column <= row; ++column, ++id) {
                    scene.balls.push_back(
                        pool_ball(std::string("b").append(std::to_string(id)),
                                  {0.9906 / 2 + (column - row / 2.0) * (2 * kPoolRadius + spacing),
                                   1.4859 + row * row_height}));
                }
            }
            const auto run = settled(scene);
            OSCULO_EXPECT_SOUND(run);
            EXPECT_LE(run.event_count, 20'000U) << spacing << " " << aside;
            EXPECT_GE(count(run, EventKind::ball_ball), 20) << spacing << " " << aside;
        }
    }
}

}  // namespace
}  // namespace osculo::support

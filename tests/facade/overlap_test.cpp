#include "overlap.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace osculo::facade {
namespace {

bool overlap(const Ball& a, const Ball& b, double allowed) {
    return a.radius + b.radius -
               std::hypot(a.position.x - b.position.x, a.position.y - b.position.y) >
           allowed * std::min(a.radius, b.radius);
}

TEST(Overlap, AgreesWithLookingAtEveryPair) {
    int with = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        std::mt19937_64 random(seed);
        const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
        std::vector<Ball> balls;
        for (int i = 0; i < 12; ++i) {
            // Radii over six powers of ten.
            balls.push_back(test::ball(std::to_string(i), {4 * uniform() - 2, 4 * uniform() - 2},
                                       {}, std::pow(10, -6 * uniform() - 0.5)));
        }
        bool any = false;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) any = any || overlap(balls[i], balls[j], 1e-7);
        }
        const auto found = find_overlap(balls, 1e-7);
        ASSERT_EQ(found.has_value(), any) << "seed " << seed;
        if (!found) continue;
        ++with;
        EXPECT_LT(found->first, found->second);
        EXPECT_TRUE(overlap(balls[found->first], balls[found->second], 1e-7)) << "seed " << seed;
    }
    EXPECT_GT(with, 100);
    EXPECT_LT(with, 1900);
}

TEST(Overlap, TouchingBallsDoNot) {
    std::vector<Ball> balls;
    for (int i = 0; i < 100; ++i) balls.push_back(test::ball(std::to_string(i), {1.0 * i, 7}));
    EXPECT_FALSE(find_overlap(balls, 1e-7));
    balls[57].position.x += 1e-6;
    const auto found = find_overlap(balls, 1e-7);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first, 57U);
    EXPECT_EQ(found->second, 58U);
    EXPECT_NEAR(found->depth, 1e-6, 1e-12);
}

}  // namespace
}  // namespace osculo::facade

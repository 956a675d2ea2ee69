#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"

namespace osculo::io {
namespace {

TEST(Large, AHundredThousandBallsRoundTrip) {
    const Scene scene = presets::make("gas", {.balls = 100'000});
    const std::string text = scene_to_json(scene);
    EXPECT_GT(text.size(), 10'000'000U);
    EXPECT_EQ(scene_from_json(text), scene);
}

}  // namespace
}  // namespace osculo::io

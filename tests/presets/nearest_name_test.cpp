#include "presets/nearest_name.hpp"

#include <array>

#include <gtest/gtest.h>

namespace osculo {
namespace {

constexpr std::array<std::string_view, 4> kNames{"velocity", "position", "mass", "id"};

TEST(NearestName, FindsSlips) {
    EXPECT_EQ(nearest_name("velocty", kNames), "velocity");
    EXPECT_EQ(nearest_name("positoin", kNames), "position");
    EXPECT_EQ(nearest_name("Mass", kNames), "mass");
    EXPECT_EQ(nearest_name("di", kNames), "id");
}

TEST(NearestName, SuggestsNothingForOtherWords) {
    EXPECT_EQ(nearest_name("colour", kNames), "");
    EXPECT_EQ(nearest_name("", kNames), "");
    EXPECT_EQ(nearest_name(std::string(100'000, 'v'), kNames), "");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(NearestName, MakesAQuestion) {
    EXPECT_EQ(did_you_mean("velocty", kNames), ", did you mean velocity?");
    EXPECT_EQ(did_you_mean("colour", kNames), "");
}

}  // namespace
}  // namespace osculo

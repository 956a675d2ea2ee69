#include "osculo/engine/obstacle_boxes.hpp"

#include <set>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace osculo::engine {
namespace {

using Box = geometry::Box<double>;
using Points = std::tuple<std::vector<geometry::Point<double>>>;
using Rims = std::tuple<std::vector<geometry::Rim<double>>>;

// Against a look at each one: nothing near is left out, nothing apart is visited.
TEST(ObstacleBoxes, FindsWhatIsNear) {
    support::Random random(1);
    for (int scene = 0; scene < 200; ++scene) {
        Rims rims;
        const int count = random.between(0, 200);  // more than the 64 of one word
        for (int k = 0; k < count; ++k) {
            std::get<0>(rims).push_back(
                {math::Vec<double>(random.unit<double>(), random.unit<double>()),
                 0.1 * random.unit<double>()});
        }
        const ObstacleBoxes<double, Rims> boxes(rims);
        for (int query = 0; query < 100; ++query) {
            const math::Vec<double> a(random.uniform<double>(-0.5, 1.5),
                                      random.uniform<double>(-0.5, 1.5));
            const math::Vec<double> b(random.uniform<double>(-0.5, 1.5),
                                      random.uniform<double>(-0.5, 1.5));
            const Box swept = query == 0 ? Box::everything() : Box::around(a, b);
            std::vector<std::size_t> found, expected;
            boxes.for_each_near<0>(swept, [&](std::size_t k) { found.push_back(k); });
            for (std::size_t k = 0; k < std::get<0>(rims).size(); ++k) {
                if (!bounding_box(std::get<0>(rims)[k]).apart(swept)) expected.push_back(k);
            }
            ASSERT_EQ(found, expected) << "scene " << scene << " query " << query;
        }
    }
}

// What the visit makes smaller while it goes on is looked at as it then is.
TEST(ObstacleBoxes, ASmallerBoxVisitsLess) {
    Points points;
    for (int k = 0; k < 10; ++k) std::get<0>(points).push_back({math::Vec<double>(k, 0)});
    const ObstacleBoxes<double, Points> boxes(points);
    Box swept{-1, 20, -1, 1};
    std::vector<std::size_t> found;
    boxes.for_each_near<0>(swept, [&](std::size_t k) {
        found.push_back(k);
        swept.high_x = 3;
    });
    EXPECT_EQ(found, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(ObstacleBoxes, ABoxThatIsNotANumberIsNearEverything) {
    Points points;
    for (int k = 0; k < 3; ++k) std::get<0>(points).push_back({math::Vec<double>(k, k)});
    const ObstacleBoxes<double, Points> boxes(points);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::size_t visits = 0;
    boxes.for_each_near<0>(Box{-math::never<double>(), nan, -1, nan},
                           [&](std::size_t) { ++visits; });
    EXPECT_LE(visits, 3U);  // no access beyond the tables
}

}  // namespace
}  // namespace osculo::engine

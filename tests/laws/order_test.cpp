#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/scalars.hpp"

// One ball meets two others within a sixtieth of a second. Who is first decides everything, and a
// simulation that moves everything by 1/60 s and then looks for overlaps takes the wrong one.
namespace osculo::support {
namespace {

struct Disk {
    double x, y, vx, vy;
};
constexpr double kRadius = 0.028;
// Ball 0 reaches ball 2 first, at 0.1445 s, and would have reached ball 1 at 0.1479 s.
constexpr Disk kDisks[] = {{0.03, 0, 6, 0}, {0.970, 0.020, 0, 0}, {0.943, -0.032, 0, 0}};

template <math::Scalar S>
Played<TableScene<S>> event_driven() {
    using Vec = math::Vec<S>;
    Builder<TableScene<S>> builder;
    for (const Disk& disk : kDisks) {
        builder.ball(Vec(S(disk.x), S(disk.y)), Vec(S(disk.vx), S(disk.vy)), S(kRadius));
    }
    return play<TableScene<S>>(builder.scene, S(0.25));
}

/// The usual game loop: move, then push every overlapping pair that approaches, in order of index.
/// Returns the pairs in the order of their impacts.
std::vector<std::pair<int, int>> stepped(double step, std::vector<Disk>& disks) {
    std::vector<std::pair<int, int>> impacts;
    const auto steps = static_cast<int>(std::round(0.25 / step));
    for (int k = 0; k < steps; ++k) {
        for (Disk& disk : disks) {
            disk.x += disk.vx * step;
            disk.y += disk.vy * step;
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = i + 1; j < 3; ++j) {
                Disk& a = disks[static_cast<std::size_t>(i)];
                Disk& b = disks[static_cast<std::size_t>(j)];
                const double nx = b.x - a.x, ny = b.y - a.y;
                const double square = nx * nx + ny * ny;
                const double closing = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny;
                if (square >= 4 * kRadius * kRadius || closing <= 0) continue;
                const double factor = closing / square;
                a.vx -= factor * nx;
                a.vy -= factor * ny;
                b.vx += factor * nx;
                b.vy += factor * ny;
                impacts.emplace_back(i, j);
            }
        }
    }
    return impacts;
}

TEST(Order, TheSteppedSimulationTakesTheWrongPairFirst) {
    std::vector<Disk> disks(std::begin(kDisks), std::end(kDisks));
    const auto impacts = stepped(1.0 / 60, disks);
    ASSERT_FALSE(impacts.empty());
    EXPECT_EQ(impacts.front(), std::make_pair(0, 1));
}

TEST(Order, OursIsThatOfAHundredDigits) {
    const auto exact = event_driven<Digits100>();
    const auto ours = event_driven<double>();
    ASSERT_GE(exact.events, 2u);
    EXPECT_EQ(exact.record.events[0].first, 0u);
    EXPECT_EQ(exact.record.events[0].second, 2u);
    ASSERT_EQ(ours.events, exact.events);
    for (std::size_t k = 0; k < ours.events; ++k) {
        EXPECT_EQ(ours.record.events[k].first, exact.record.events[k].first);
        EXPECT_EQ(ours.record.events[k].second, exact.record.events[k].second);
        EXPECT_NEAR(math::narrow(ours.record.events[k].when),
                    static_cast<double>(exact.record.events[k].when), 1e-15);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(ours.velocity(i).x(), static_cast<double>(exact.velocity(i).x()), 1e-13);
        EXPECT_NEAR(ours.velocity(i).y(), static_cast<double>(exact.velocity(i).y()), 1e-13);
    }
    EXPECT_TRUE(ours.audit().clean) << describe(ours.audit());
}

TEST(Order, AStepOfAMillionthFindsItTooAndEndsThere) {
    // Not a fault of the reference program, then, but of its step.
    std::vector<Disk> disks(std::begin(kDisks), std::end(kDisks));
    const auto impacts = stepped(1e-6, disks);
    const auto ours = event_driven<double>();
    ASSERT_EQ(impacts.size(), ours.events);
    EXPECT_EQ(impacts.front(), std::make_pair(0, 2));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(disks[i].vx, ours.velocity(i).x(), 1e-2);
        EXPECT_NEAR(disks[i].vy, ours.velocity(i).y(), 1e-2);
    }
}

}  // namespace
}  // namespace osculo::support

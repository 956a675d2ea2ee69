#include "osculo/impact/cue_strike.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/spinning.hpp"

namespace osculo::impact {
namespace {

using support::Ball;
constexpr double kDegree = std::numbers::pi / 180;

Ball struck(const CueStrike<double>& strike, double inertia = 0.4) {
    Ball ball{0.17, 0.028575, inertia, {0, 0}, {0, 0, 0}};
    EXPECT_EQ(strike.fault(), StrikeFault::none);
    strike.resolve(ball);
    return ball;
}
CueStrike<double> strike(double side = 0, double height = 0) {
    return {2, 0, 0, side, height, 0.54, 0, 1, 0.9};
}

// NUMERICS 7.4.
TEST(CueStrike, Squirt) {
    const double rows[][3] = {{20, 1.485, 2.709}, {30, 1.040, 1.886}, {50, .650, 1.173}};
    for (const auto& [ratio, quarter, half] : rows) {
        for (const bool is_half : {false, true}) {
            for (const double sign : {-1., 1.}) {
                auto s = strike(sign * (is_half ? 0.5 : 0.25));
                s.end_mass = 0.17 / ratio;
                const Ball ball = struck(s);
                // Struck on the left, the ball goes to the right.
                const double angle =
                    -sign * std::atan2(ball.velocity.y(), ball.velocity.x()) / kDegree;
                EXPECT_NEAR(angle, is_half ? half : quarter, 6e-4);
            }
        }
    }
    EXPECT_EQ(struck(strike(0.5)).velocity.y(), 0) << "no end mass, no squirt";
}

TEST(CueStrike, Speed) {
    auto s = strike();
    s.restitution = 0.73;
    EXPECT_NEAR(struck(s).velocity.x() / s.speed, 1.316, 5e-4);
    // Momentum and energy of cue and ball at a centre hit without loss.
    s.restitution = 1;
    const double v = struck(s).velocity.x();
    const double cue = s.speed - 0.17 / 0.54 * v;
    EXPECT_NEAR(0.54 * cue * cue + 0.17 * v * v, 0.54 * s.speed * s.speed, 1e-14);
}

// Without loss the energy is kept wherever the ball is struck, if the ball may leave the table.
TEST(CueStrike, EnergyWithSpinAndElevation) {
    for (const double k : {0.4, 2. / 3}) {
        for (const double elevation : {0., 0.5, 1.5}) {
            auto s = strike(0.3, -0.4);
            s.elevation = elevation;
            s.azimuth = 2;
            const Ball ball = struck(s, k);
            const double v = ball.velocity.norm() / std::cos(elevation);
            const double cue = s.speed - 0.17 / 0.54 * v;
            const double spin = 0.17 * k * 0.028575 * 0.028575 * ball.spin.squaredNorm();
            EXPECT_NEAR(0.54 * cue * cue + 0.17 * v * v + spin, 0.54 * s.speed * s.speed, 1e-14);
        }
    }
}

TEST(CueStrike, Directions) {
    // Struck at 2/5 of the radius above the centre, a ball rolls from the start.
    Ball ball = struck(strike(0, 0.4));
    EXPECT_NEAR(ball.spin.y() * ball.radius, ball.velocity.x(), 1e-14);
    EXPECT_EQ(ball.spin.z(), 0);
    // On the left: clockwise seen from above.
    EXPECT_LT(struck(strike(0.4)).spin.z(), 0);
    // Any azimuth: the same turned.
    auto s = strike(0.2, 0.3);
    s.elevation = 0.7;
    s.end_mass = 0.006;
    const Ball straight = struck(s);
    s.azimuth = 2.5;
    const Ball turned = struck(s);
    const Eigen::Rotation2D<double> turn(2.5);
    EXPECT_LT((turned.velocity - turn * straight.velocity).norm(), 1e-14);
    EXPECT_LT((turned.spin.head<2>() - turn * straight.spin.head<2>()).norm(), 1e-12);
    EXPECT_EQ(turned.spin.z(), straight.spin.z());
}

TEST(CueStrike, Faults) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [](auto change) {
        auto s = strike(0.3, 0.3);
        change(s);
        return s.fault();
    };
    EXPECT_EQ(with([](auto&) {}), StrikeFault::none);
    for (const double speed : {0., -1., nan}) {
        EXPECT_EQ(with([&](auto& s) { s.speed = speed; }), StrikeFault::speed);
    }
    for (const double elevation : {-0.01, 1.6, nan}) {
        EXPECT_EQ(with([&](auto& s) { s.elevation = elevation; }), StrikeFault::elevation);
    }
    EXPECT_EQ(with([](auto& s) { s.elevation = std::numbers::pi / 2; }), StrikeFault::none);
    for (const double side : {1., -2., 0.96, 1e200, nan}) {
        EXPECT_EQ(with([&](auto& s) { s.side = side; }), StrikeFault::outside) << side;
    }
    for (const double height : {1., 0.96, -1e200, nan}) {
        EXPECT_EQ(with([&](auto& s) { s.height = height; }), StrikeFault::outside) << height;
    }
    const auto limited = [&](double side, double limit) {
        return with([&](auto& s) {
            s.side = side;
            s.height = 0;
            s.miscue_limit = limit;
        });
    };
    EXPECT_EQ(limited(0.56, CueStrike<double>::kMiscueLimit), StrikeFault::miscue);
    EXPECT_EQ(limited(0.55, CueStrike<double>::kMiscueLimit), StrikeFault::none);
    EXPECT_EQ(limited(0.99, 1), StrikeFault::none);
    EXPECT_EQ(limited(1, 1), StrikeFault::outside);
}

TEST(CueStrike, TinyAndHugeSpeeds) {
    for (const double speed : {1e-200, 50., 1e150}) {
        auto s = strike(0.3, 0.2);
        s.end_mass = 0.006;
        const Ball unit = struck(s);
        s.speed = speed;
        const Ball ball = struck(s);
        EXPECT_NEAR(ball.velocity.x() / speed, unit.velocity.x() / 2, 1e-15);
        EXPECT_NEAR(ball.spin.z() / speed, unit.spin.z() / 2, 1e-12);
    }
}

}  // namespace
}  // namespace osculo::impact

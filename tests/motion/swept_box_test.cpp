#include "osculo/motion/swept_box.hpp"

#include <gtest/gtest.h>

#include "support/exact.hpp"
#include "support/random.hpp"

namespace osculo::motion {
namespace {

using support::Exact;
using Vec = math::Vec<double>;

// The path at sampled times, in 100 digits, is in its box; the box of a path is not much larger
// than the path.
TEST(SweptBox, HoldsTheParabolaAndLittleElse) {
    support::Random random(1);
    for (int k = 0; k < 20'000; ++k) {
        const double size = random.magnitude<double>(-20, 20);
        const double time = random.magnitude<double>(-20, 20);
        ParabolicPath<double> path;
        path.position = math::WidePoint<double>(
            math::DoubleDouble<double>(size * random.signed_unit<double>(), size * 1e-17),
            math::DoubleDouble<double>(1e3 * size * random.signed_unit<double>()));
        path.velocity = (size / time) * random.signed_unit<double>() * random.direction<double>();
        path.half_acceleration =
            (size / (time * time)) * random.signed_unit<double>() * random.direction<double>();
        path.end = time * random.uniform<double>(0.1, 4);
        const double until = random.coin() ? math::never<double>() : time;
        const auto box = swept_box(path, until);
        Exact low_x = box.high_x, high_x = box.low_x;
        const double last = std::min(until, path.end);
        for (int sample = 0; sample <= 16; ++sample) {
            const Exact t = Exact(last) * sample / 16;
            const auto at = [&t](const math::DoubleDouble<double>& x, double v, double a) {
                return Exact(Exact(x.hi) + Exact(x.lo) + t * (Exact(v) + t * Exact(a)));
            };
            const Exact x = at(path.position.x, path.velocity.x(), path.half_acceleration.x());
            const Exact y = at(path.position.y, path.velocity.y(), path.half_acceleration.y());
            ASSERT_TRUE(x >= box.low_x && x <= box.high_x && y >= box.low_y && y <= box.high_y)
                << "case " << k << " sample " << sample;
            low_x = std::min(low_x, x);
            high_x = std::max(high_x, x);
        }
        // A parabola reaches at least half way to the corner of its tangents.
        ASSERT_LE(box.high_x - box.low_x, static_cast<double>(high_x - low_x) * 2.1 + 1e-11 * size)
            << "case " << k;
    }
}

TEST(SweptBox, OfAnEndlessPathIsEndlessWhereItGoes) {
    const LinearPath<double> path{math::WidePoint<double>(Vec(1, 2)), Vec(3, 0)};
    const auto box = swept_box(path, math::never<double>());
    EXPECT_FALSE(math::is_finite(box.high_x));
    EXPECT_NEAR(box.low_x, 1, 1e-14);
    EXPECT_NEAR(box.low_y, 2, 1e-14);
    EXPECT_NEAR(box.high_y, 2, 1e-14);
    const ParabolicPath<double> at_rest{math::WidePoint<double>(Vec(1, 2)), Vec(0, 0), Vec(0, 0),
                                        math::never<double>()};
    EXPECT_TRUE(at_rest.stands());
    EXPECT_NEAR(swept_box(at_rest, math::never<double>()).high_x, 1, 1e-14);
}

// Beyond the range of the scalar type nothing is ruled out.
TEST(SweptBox, OfWhatOverflowsIsEverything) {
    const ParabolicPath<double> path{math::WidePoint<double>(Vec(0, 0)), Vec(1e300, 0),
                                     Vec(-1e300, 0), 1e100};
    const auto box = swept_box(path, math::never<double>());
    EXPECT_FALSE(math::is_finite(box.low_y));
    EXPECT_FALSE(math::is_finite(box.high_x));
}

}  // namespace
}  // namespace osculo::motion

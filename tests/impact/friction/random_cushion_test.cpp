#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/cushion_stronge.hpp"
#include "support/spinning.hpp"

// A million random impacts on each cushion. Mathavan's law has a test of its own.
namespace osculo::impact {
namespace {

using support::Ball;
using support::distance;
using support::mirrored;
using support::Point;
using support::same_bits;
constexpr int kCases = 1000000;
constexpr double kEpsilon = 0x1p-52;

/// The nose's height is in radii.
struct Parameters {
    double restitution = 0, friction = 0, height = 1, ratio = 1.8;
};
void resolve_simple(const Parameters& p, const Point& n, Ball& b) {
    CushionSimple<double>{p.restitution, p.friction}.resolve(n, b);
}
void resolve_han(const Parameters& p, const Point& n, Ball& b) {
    CushionHan2005<double>{p.restitution, p.friction, p.height * b.radius}.resolve(n, b);
}
void resolve_stronge(const Parameters& p, const Point& n, Ball& b) {
    CushionStronge<double>{p.restitution, p.friction, p.height * b.radius, p.ratio}.resolve(n, b);
}

template <class Resolve>
void test(const Resolve& resolve, std::uint64_t seed, double mirror_bound) {
    support::Random random(seed);
    double gain = 0, approach = 0, mirror = 0;
    for (int i = 0; i < kCases; ++i) {
        const Ball start = support::random_ball(random);
        Point normal = random.magnitude<double>(-5, 5) * random.direction<double>();
        if (math::dot<double>(start.velocity, normal) < 0) normal = -normal;
        Parameters p;
        const double ends[] = {0, 1, 0.85};
        p.restitution = random.coin() ? random.unit<double>() : ends[random.below(3)];
        p.friction = random.below(8) == 0 ? 0 : random.magnitude<double>(-8, 1);
        p.height = random.coin() ? 1.28 : random.uniform(0.1, 1.9);
        p.ratio = random.coin() ? 1.8 : random.uniform(1.01, 1.99);
        std::ostringstream label;
        label << "case " << i << std::hexfloat << ": e " << p.restitution << " mu " << p.friction
              << " h " << p.height << " rho " << p.ratio << " normal " << normal.transpose() << ' '
              << support::described(start);

        Ball ball = start;
        resolve(p, normal, ball);
        const Point unit = normal / math::norm<double>(normal);
        const double before = support::energy(start);
        const double scale = support::speed_scale(start) + 1e-300;
        const double gained = before > 0 ? (support::energy(ball) - before) / before / kEpsilon : 0;
        ASSERT_LT(gained, 10) << label.str();
        gain = std::max(gain, gained);
        approach = std::max(approach, math::dot<double>(ball.velocity, unit) / scale / kEpsilon);

        const Point axis(0, 1);
        Ball reflected = mirrored(start, axis);
        resolve(p, mirrored(normal, axis), reflected);
        ASSERT_TRUE(same_bits(reflected, mirrored(ball, axis))) << label.str();
        const Point m = random.direction<double>();
        Ball turned = mirrored(start, m);
        resolve(p, mirrored(normal, m), turned);
        const double off = distance(turned, mirrored(ball, m)) / scale / kEpsilon;
        ASSERT_LT(off, mirror_bound) << label.str();
        mirror = std::max(mirror, off);
    }
    std::printf("  in epsilons: gain %.2f, approach %.2f, mirror %.2f\n", gain, approach, mirror);
    EXPECT_LE(approach, 5);
}

TEST(RandomCushion, Simple) {
    test(resolve_simple, 31, 40);
}
TEST(RandomCushion, Han) {
    test(resolve_han, 32, 40);
}
TEST(RandomCushion, Stronge) {
    test(resolve_stronge, 33, 40);
}

}  // namespace
}  // namespace osculo::impact

#include "osculo/motion/relative_jerk.hpp"

#include <gtest/gtest.h>

#include "support/resisted_families.hpp"

namespace osculo::motion {
namespace {

using Wider = long double;
using WideVec = math::Vec<Wider>;

/// f'(v) f(v) along the velocity, at s.
WideVec third_derivative(const ResistedPath<double>& path, double s) {
    const Wider q = path.slowed(s).q;
    const Wider slowing = path.slowing.m + q * (path.slowing.k + q * Wider(path.slowing.c));
    const Wider slope = path.slowing.k + 2 * q * Wider(path.slowing.c);
    return (slope * slowing) * WideVec(path.velocity.cast<Wider>());
}

TEST(RelativeJerk, IsNoLessThanTheDifference) {
    support::Random random(20297);
    int closer = 0;
    for (int round = 0; round < 6000; ++round) {
        const auto family =
            static_cast<support::ResistedFamily>(random.below(support::kResistedFamilies));
        auto pair = support::random_pair(family, round, random);
        if (random.coin()) {  // side by side
            const auto velocity =
                math::Vec<double>(pair.first.velocity +
                                  random.direction<double>() * random.magnitude<double>(-46, -1));
            const double speed = math::norm<double>(pair.first.velocity);
            const Resistance<double> law{pair.first.slowing.m * speed, pair.first.slowing.k,
                                         pair.first.slowing.c / speed};
            pair.second = support::resisted_path({1, 0}, velocity, law);
        }
        const double end = std::min({pair.first.end, pair.second.end, 20.0});
        const double t = end * random.unit<double>();
        const double h = (end - t) * random.magnitude<double>(-20, 0);
        const double bound = relative_jerk_bound(pair.first, pair.second, t, h);
        const double sum = pair.first.jerk_bound(t, h) + pair.second.jerk_bound(t, h);
        ASSERT_LE(bound, sum);
        if (bound < sum / 100) ++closer;
        for (int i = 0; i <= 8; ++i) {
            const double s = std::min(t + h * i / 8, end);
            const WideVec off = third_derivative(pair.first, s) - third_derivative(pair.second, s);
            ASSERT_LE(math::norm<Wider>(off), bound * (1 + 1e-12L)) << round << " at " << s;
        }
    }
    EXPECT_GT(closer, 500);
}

/// What two balls that go side by side need not share is their jerk.
TEST(RelativeJerk, IsAsSmallAsTheVelocitiesDiffer) {
    const Resistance<double> law{0.01, 1, 0.01};
    const auto one = support::resisted_path({0, 0}, {2, 0}, law);
    for (const double apart : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const auto other = support::resisted_path({0, 1}, {2, apart}, law);
        const double sum = one.jerk_bound(0.5, 0.1) + other.jerk_bound(0.5, 0.1);
        EXPECT_LE(relative_jerk_bound(one, other, 0.5, 0.1), 2 * apart * sum) << apart;
        EXPECT_GT(relative_jerk_bound(one, other, 0.5, 0.1), 0) << apart;
    }
}

}  // namespace
}  // namespace osculo::motion

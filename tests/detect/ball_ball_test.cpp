#include "osculo/detect/ball_ball.hpp"

#include <gtest/gtest.h>

#include "osculo/detect/ball_point.hpp"
#include "support/contact_families.hpp"
#include "support/exact_obstacles.hpp"
#include "support/exact_scalars.hpp"
#include "support/tally.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCases = 5000;

/// Two balls whose relative motion is that of the case but for the rounding of their own places
/// and velocities; [far] of the origin.
template <class S>
struct Pair {
    motion::LinearPath<S> first;
    motion::LinearPath<S> second;
    S reach;

    Pair(const PointCase<S>& p, Random& random, const S& far) : reach(p.s) {
        const math::Vec<S> place = random.direction<S>() * far;
        const math::Vec<S> drift = random.direction<S>() * math::norm<S>(p.b);
        const math::WidePoint<S> at{math::Wide<S>(math::two_sum(S(place.x()), S(p.c.y()))),
                                    math::Wide<S>(math::two_sum(S(place.y()), S(p.c.x())))};
        first = {{math::Wide<S>(at.x + S(p.c.x())), math::Wide<S>(at.y + S(p.c.y()))}, p.b + drift};
        second = {at, drift};
    }

    /// What detection gets to see: differences rounded once.
    [[nodiscard]] PointCase<S> seen() const {
        return {
            {rounded<S>(Exact(exact<Exact>(first.position.x) - exact<Exact>(second.position.x))),
             rounded<S>(Exact(exact<Exact>(first.position.y) - exact<Exact>(second.position.y)))},
            first.velocity - second.velocity,
            reach};
    }
};

template <class S>
class BallBall : public testing::Test {};
TYPED_TEST_SUITE(BallBall, BuiltinScalars, ScalarName);

TYPED_TEST(BallBall, IsExactlyDecidedNearAndFarFromTheOrigin) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        if (std::string(family.name) == "any scale") continue;  // nothing is far beside 1e9 m
        for (const S far : {S(0), S(1e8)}) {
            SCOPED_TRACE(family.name);
            Random random(41);
            Tally tally;
            for (int i = 0; i < kCases; ++i) {
                const Pair<S> pair(family.make(random), random, far);
                const S t = detect::first_contact<S>(pair.first, pair.second, pair.reach, {},
                                                     math::never<S>());
                ASSERT_TRUE(tally.add<S>(t, exact_entry(pair.seen()))) << bits(pair.seen());
                EXPECT_EQ(t, detect::first_contact<S>(pair.second, pair.first, pair.reach, {},
                                                      math::never<S>()))
                    << bits(pair.seen());
            }
            EXPECT_LE(tally.quantile(1), 1.0);
        }
    }
}

TYPED_TEST(BallBall, FarFromTheOriginIsAsGoodAsAtTheOrigin) {
    using S = TypeParam;
    Random random(42);
    for (int i = 0; i < kCases; ++i) {
        PointCase<S> p = grazing_hit<S>(random);
        const motion::LinearPath<S> still{math::WidePoint<S>(math::Vec<S>(S(0), S(0))),
                                          math::Vec<S>(S(0), S(0))};
        const motion::LinearPath<S> moving{math::WidePoint<S>(p.c), p.b};
        const S t = detect::first_contact<S>(moving, still, p.s, {}, math::never<S>());
        // Coordinates up to 2^27 m as high parts, everything else as low parts: exact.
        const S far = power_of_two<S>(27);
        const auto shifted = [&](motion::LinearPath<S> path) {
            path.position = {math::Wide<S>(path.position.x + far),
                             math::Wide<S>(path.position.y - far)};
            return path;
        };
        EXPECT_EQ(
            t, detect::first_contact<S>(shifted(moving), shifted(still), p.s, {}, math::never<S>()))
            << bits(p);
    }
}

TYPED_TEST(BallBall, APointIsABallWithoutRadiusAtRest) {
    using S = TypeParam;
    Random random(43);
    for (int i = 0; i < kCases; ++i) {
        const PointCase<S> p = kContactFamilies<S>[static_cast<std::size_t>(i % 13)].make(random);
        const math::Vec<S> at(S(3), S(-7));
        const math::Vec<S> zero(S(0), S(0));
        const math::WidePoint<S> place{math::Wide<S>(math::two_sum(S(p.c.x()), S(at.x()))),
                                       math::Wide<S>(math::two_sum(S(p.c.y()), S(at.y())))};
        const motion::LinearPath<S> path{place, p.b};
        const motion::LinearPath<S> still{math::WidePoint<S>(at), zero};
        EXPECT_EQ(detect::first_contact<S>(path, still, p.s, {}, math::never<S>()),
                  detect::first_contact<S>(path, p.s, geometry::Point<S>{at}, {}, math::never<S>()))
            << bits(p);
    }
}

/// The quick rejection may only drop what the full prediction would not find either.
TYPED_TEST(BallBall, CertainlyApartMeansNoContactBeforeTheHorizon) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        Random random(44);
        int rejected = 0;
        int misses = 0;
        for (int i = 0; i < kCases; ++i) {
            const S far = random.coin() ? S(0) : S(1e8);
            Pair<S> pair(family.make(random), random, far);
            // One of the two has its state at an earlier instant.
            const S shift = random.coin() ? S(0) : random.magnitude<S>(-20, 1);
            Pair<S> earlier = pair;
            earlier.second.shift(-shift);
            pair = earlier;
            pair.second.shift(shift);
            const S t =
                detect::first_contact<S>(pair.first, pair.second, pair.reach, {}, math::never<S>());
            const auto apart = [&](const S& horizon) {
                return detect::certainly_apart<S>(pair.first, S(0), earlier.second, shift,
                                                  pair.reach, horizon);
            };
            if (math::is_finite<S>(t)) {
                EXPECT_FALSE(apart(t)) << bits(pair.seen()) << " shift " << bits(shift);
                EXPECT_FALSE(apart(math::never<S>())) << bits(pair.seen()) << bits(shift);
            } else {
                ++misses;
                rejected += apart(math::never<S>());
            }
        }
        if (!family.adversarial) {
            EXPECT_GE(rejected, 0.99 * misses) << family.name;
        }
    }
}

TEST(BallBall, TouchingPairsCollideIfAndOnlyIfTheyApproach) {
    const double ulp = math::epsilon<double>();
    for (const double gap : {0.0, ulp, -ulp, 1e-12, -1e-12, 1e-9, -1e-9}) {
        for (int k = 0; k < 32; ++k) {
            const double angle = k * 0.19634954084936207;  // 2 pi / 32
            math::Vec<double> v(std::cos(angle), std::sin(angle));
            if (k % 16 == 8) v.x() = 0;  // exactly sideways
            const motion::LinearPath<double> first{math::WidePoint<double>(math::Vec<double>(0, 0)),
                                                   math::Vec<double>(0, 0)};
            const motion::LinearPath<double> second{
                math::WidePoint<double>(math::Vec<double>(1 + gap, 0)), v};
            const double t =
                detect::first_contact<double>(first, second, 1.0, {}, math::never<double>());
            if (v.x() >= 0) {
                EXPECT_FALSE(math::is_finite(t)) << gap << " " << k;
            } else if (gap <= 0) {
                EXPECT_EQ(0.0, t) << gap << " " << k;
            } else {
                EXPECT_GT(t, 0.0) << gap << " " << k;
                EXPECT_LE(t * -v.x(), gap * 1.01) << gap << " " << k;
            }
        }
    }
}

}  // namespace

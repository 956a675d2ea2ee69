#include <gtest/gtest.h>

#include "osculo/impact/restitution.hpp"
#include "support/exact_scalars.hpp"
#include "support/random.hpp"

/// Rounding must not act like a restitution a little above or below 1: over many impacts it is to
/// cancel, not to add up. A million impacts of doubles keep the energy to 1e-12. (The types that
/// are their own wide type divide by a rounded n.n, which is close to 1: that rounds upwards more
/// often than not, and gains up to a quarter of their epsilon at an impact.)
namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
inline constexpr int kImpacts = std::is_same_v<S, double> ? 1000000 : 20000;

template <class S>
S bound() {
    return math::epsilon<S>() * S(math::Builtin<S> ? 4500 : kImpacts<S> / 4);
}

template <class S>
class Drift : public testing::Test {};
TYPED_TEST_SUITE(Drift, NativeScalars, ScalarName);

TYPED_TEST(Drift, NoneOffOneSlantedWall) {
    using S = TypeParam;
    Random random(91);
    for (int wall = 0; wall < 8; ++wall) {
        const math::Vec<S> normal = random.direction<S>();
        math::Vec<S> v(random.signed_unit<S>(), random.signed_unit<S>());
        const S energy = math::dot<S>(v, v);
        S worst(0);
        for (int i = 0; i < kImpacts<S> / 8; ++i) {
            impact::Restitution::resolve<S>(S(1), normal, v);
            worst = std::max<S>(worst, math::abs<S>(math::dot<S>(v, v) / energy - 1));
        }
        EXPECT_LE(worst, bound<S>()) << bits<S>(normal);
    }
}

TYPED_TEST(Drift, NoneOffWallsOfAnyDirection) {
    using S = TypeParam;
    Random random(92);
    math::Vec<S> v(random.signed_unit<S>(), random.signed_unit<S>());
    const S energy = math::dot<S>(v, v);
    for (int i = 0; i < kImpacts<S>; ++i) {
        impact::Restitution::resolve<S>(S(1), random.direction<S>(), v);
    }
    const S drift = math::abs<S>(math::dot<S>(v, v) / energy - 1);
    EXPECT_LE(drift, bound<S>());
}

TYPED_TEST(Drift, NoneInPairsOfAnyMasses) {
    using S = TypeParam;
    Random random(93);
    for (int pair = 0; pair < 8; ++pair) {
        const S m1 = random.magnitude<S>(-2, 2);
        const S m2 = pair == 0 ? m1 : random.magnitude<S>(-2, 2);
        math::Vec<S> v1(random.signed_unit<S>(), random.signed_unit<S>());
        math::Vec<S> v2(random.signed_unit<S>(), random.signed_unit<S>());
        const auto energy = [&] { return m1 * math::dot<S>(v1, v1) + m2 * math::dot<S>(v2, v2); };
        const S start = energy();
        for (int i = 0; i < kImpacts<S> / 8; ++i) {
            impact::Restitution::resolve<S>(S(1), m1, m2, random.direction<S>(), v1, v2);
        }
        const S drift = math::abs<S>(energy() / start - 1);
        EXPECT_LE(drift, bound<S>()) << bits<S>(m1) << " " << bits<S>(m2);
    }
}

}  // namespace

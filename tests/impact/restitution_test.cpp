#include "osculo/impact/restitution.hpp"

#include <gtest/gtest.h>

#include "osculo/math/error_bounds.hpp"
#include "support/exact_obstacles.hpp"
#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

/// A million impacts of doubles; the others are slow.
template <class S>
inline constexpr int kImpacts = std::is_same_v<S, double> ? 1000000 : 2000;

template <class S>
struct Pair {
    S e;
    S m1;
    S m2;
    math::Vec<S> normal;
    math::Vec<S> v1;
    math::Vec<S> v2;

    explicit Pair(Random& random) {
        e = random.below(4) == 0 ? S(1) : random.below(4) == 0 ? S(0) : random.unit<S>();
        m1 = random.magnitude<S>(-25, 25);  // ratios up to 2^50, or 1e15
        m2 = random.below(4) == 0 ? m1 : random.magnitude<S>(-25, 25);
        normal = random.direction<S>() * random.magnitude<S>(-30, 30);
        v1 = random.direction<S>() * random.magnitude<S>(-10, 10);
        v2 = random.below(4) == 0
                 ? math::Vec<S>(S(0), S(0))
                 : math::Vec<S>(random.direction<S>() * random.magnitude<S>(-10, 10));
    }

    [[nodiscard]] Pair resolved() const {
        Pair after = *this;
        impact::Restitution::resolve<S>(e, m1, m2, normal, after.v1, after.v2);
        return after;
    }
};

template <class S>
std::string describe(const Pair<S>& p) {
    std::ostringstream text;
    text << "e=" << bits<S>(p.e) << " m1=" << bits<S>(p.m1) << " m2=" << bits<S>(p.m2)
         << " normal=" << bits<S>(p.normal) << " v1=" << bits<S>(p.v1) << " v2=" << bits<S>(p.v2);
    return text.str();
}

template <class S>
class Restitution : public testing::Test {};
TYPED_TEST_SUITE(Restitution, AllScalars, ScalarName);

/// Every law of the impact at once, each to the rounding of what it is made of.
TYPED_TEST(Restitution, ConservesReflectsAndKeeps) {
    using S = TypeParam;
    // Enough digits for these sums, and quick.
    using R = std::conditional_t<std::is_same_v<S, double>, long double, ExactFor<S>>;
    using std::abs;
    Random random(81);
    const R eps = exact<R>(math::epsilon<S>());
    R worst_energy = 0;
    R worst_momentum = 0;
    R worst_normal = 0;
    R worst_tangential = 0;
    for (int i = 0; i < kImpacts<S>; ++i) {
        const Pair<S> before(random);
        const Pair<S> after = before.resolved();
        using V = ExactVec<R>;
        const V n(before.normal);
        const V v1(before.v1);
        const V v2(before.v2);
        const V w1(after.v1);
        const V w2(after.v2);
        const R m1 = exact<R>(before.m1);
        const R m2 = exact<R>(before.m2);
        const R e = exact<R>(before.e);
        const R length = n.norm();
        const R speeds = v1.norm() + v2.norm();

        const R energy = m1 * v1.dot(v1) + m2 * v2.dot(v2);
        const R gain = m1 * w1.dot(w1) + m2 * w2.dot(w2) - energy;
        const R in_energy = gain / (eps * energy);
        EXPECT_LE(in_energy, math::kImpactEnergy) << describe(before);
        if (before.e == S(1)) {
            EXPECT_GE(in_energy, -math::kImpactEnergy) << describe(before);
        }
        worst_energy = std::max(worst_energy, in_energy);

        const R size = m1 * v1.norm() + m2 * v2.norm();
        const R px = m1 * (w1.x - v1.x) + m2 * (w2.x - v2.x);
        const R py = m1 * (w1.y - v1.y) + m2 * (w2.y - v2.y);
        const R in_momentum = (abs(px) + abs(py)) / (eps * size);
        EXPECT_LE(in_momentum, math::kImpactMomentum) << describe(before);
        worst_momentum = std::max(worst_momentum, in_momentum);

        const R closing = (v1.dot(n) - v2.dot(n)) / length;
        const R opening = (w1.dot(n) - w2.dot(n)) / length;
        const R in_normal = abs(R(opening + e * closing)) / (eps * speeds);
        EXPECT_LE(in_normal, 8) << describe(before);
        worst_normal = std::max(worst_normal, in_normal);

        for (const auto& [v, w] : {std::pair(v1, w1), std::pair(v2, w2)}) {
            const R slip = abs(R(n.cross(w) - n.cross(v))) / length;
            worst_tangential = std::max(worst_tangential, R(slip / (eps * (v.norm() + w.norm()))));
        }
    }
    EXPECT_GT(worst_energy, R(math::kImpactEnergy) / 10);
    EXPECT_GT(worst_momentum, R(math::kImpactMomentum) / 10);
    EXPECT_LE(worst_tangential, 2);
}

TYPED_TEST(Restitution, DoesNotDependOnTheOrderOfTheBalls) {
    using S = TypeParam;
    Random random(82);
    for (int i = 0; i < kImpacts<S> / 10; ++i) {
        const Pair<S> pair(random);
        Pair<S> swapped = pair;
        std::swap(swapped.m1, swapped.m2);
        std::swap(swapped.v1, swapped.v2);
        swapped.normal = -pair.normal;
        const Pair<S> a = pair.resolved();
        const Pair<S> b = swapped.resolved();
        EXPECT_TRUE(a.v1 == b.v2 && a.v2 == b.v1) << describe(pair);
    }
}

TYPED_TEST(Restitution, IsTheSameInAMirrorBitForBit) {
    using S = TypeParam;
    using V = math::Vec<S>;
    Random random(83);
    const auto across = [](const V& v) { return V(-v.x(), v.y()); };
    const auto diagonal = [](const V& v) { return V(v.y(), v.x()); };
    for (int i = 0; i < kImpacts<S> / 10; ++i) {
        const Pair<S> pair(random);
        const Pair<S> after = pair.resolved();
        const auto mirrored = [&](auto map) {
            Pair<S> image = pair;
            image.normal = map(pair.normal);
            image.v1 = map(pair.v1);
            image.v2 = map(pair.v2);
            const Pair<S> result = image.resolved();
            EXPECT_TRUE(result.v1 == map(after.v1) && result.v2 == map(after.v2)) << describe(pair);
            V v = map(pair.v1);
            V w = pair.v1;
            impact::Restitution::resolve<S>(pair.e, image.normal, v);
            impact::Restitution::resolve<S>(pair.e, pair.normal, w);
            EXPECT_TRUE(v == map(w)) << describe(pair);
        };
        mirrored(across);
        mirrored(diagonal);
    }
}

TYPED_TEST(Restitution, ScalesWithPowersOfTwoBitForBit) {
    using S = TypeParam;
    Random random(84);
    for (int i = 0; i < kImpacts<S> / 10; ++i) {
        const Pair<S> pair(random);
        Pair<S> scaled = pair;
        const S mass = power_of_two<S>(random.between(-100, 100));
        const S speed = power_of_two<S>(random.between(-100, 100));
        scaled.m1 *= mass;
        scaled.m2 *= mass;
        scaled.v1 *= speed;
        scaled.v2 *= speed;
        scaled.normal *= power_of_two<S>(random.between(-100, 100));
        const Pair<S> a = pair.resolved();
        const Pair<S> b = scaled.resolved();
        EXPECT_TRUE(math::Vec<S>(a.v1 * speed) == b.v1 && math::Vec<S>(a.v2 * speed) == b.v2)
            << describe(pair);
    }
}

TYPED_TEST(Restitution, EqualBallsExchangeTheirNormalVelocities) {
    using S = TypeParam;
    using V = math::Vec<S>;
    V v1(S(3), S(1));
    V v2(S(-2), S(5));
    impact::Restitution::resolve<S>(S(1), S(7), S(7), V(S(0.25), S(0)), v1, v2);
    EXPECT_TRUE(v1 == V(S(-2), S(1)) && v2 == V(S(3), S(5)));
    impact::Restitution::resolve<S>(S(0), S(1), S(3), V(S(0), S(2)), v1, v2);
    EXPECT_TRUE(v1 == V(S(-2), S(4)) && v2 == V(S(3), S(4)));
}

TYPED_TEST(Restitution, AWallTurnsTheNormalVelocityRound) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(85);
    const R eps = exact<R>(math::epsilon<S>());
    for (int i = 0; i < std::min(kImpacts<S>, 10000); ++i) {
        const Pair<S> p(random);
        math::Vec<S> after = p.v1;
        impact::Restitution::resolve<S>(p.e, p.normal, after);
        const ExactVec<R> n(p.normal);
        const ExactVec<R> v(p.v1);
        const ExactVec<R> w(after);
        const R bound = 8 * eps * v.norm() * n.norm();
        EXPECT_LE(abs(R(w.dot(n) + exact<R>(p.e) * v.dot(n))), bound) << describe(p);
        EXPECT_LE(abs(R(w.cross(n) - v.cross(n))), bound) << describe(p);
    }
}

}  // namespace

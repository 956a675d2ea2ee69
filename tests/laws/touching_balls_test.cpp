#include <gtest/gtest.h>

#include "support/laws.hpp"

// Two balls that touch, or overlap by a little, or are apart by a little.
namespace osculo::support {
namespace {

/// Two balls of radius 1 whose boundaries are [gap] apart in the direction [n]: the first one sits
/// at the origin, the place of the second keeps the gap however small it is.
template <class Type, math::Scalar S>
engine::SceneData<Type> pair(const math::Vec<S>& n, const S& gap, const math::Vec<S>& v1,
                             const math::Vec<S>& v2) {
    const math::Vec<S> origin(S(0), S(0));
    Builder<Type> builder;
    builder.ball(origin, v1, S(1), S(3)).ball(origin, v2, S(1), S(1));
    auto& position = builder.scene.bodies[1].state.position;
    for (const S& part : {S(2), gap}) position = math::displaced<S>(position, n, part);
    return builder.scene;
}

template <class U>
class TouchingBalls : public ::testing::Test {};
TYPED_TEST_SUITE(TouchingBalls, AllUnderBoth, UnderName);

constexpr double kOverlaps[] = {0, 1e-16, 1e-15, 1e-12, 1e-9, 5e-8};

template <math::Scalar S>
std::vector<math::Vec<S>> lines_of_centres() {
    using Vec = math::Vec<S>;
    std::vector<Vec> all{Vec(S(1), S(0)), Vec(S(0), S(-1)), Vec(S(3) / S(5), S(4) / S(5))};
    for (const double angle : {0.1, 1.0, 2.0, 4.4}) {
        const Vec raw(S(std::cos(angle)), S(std::sin(angle)));
        all.push_back(raw / math::norm<S>(raw));
    }
    return all;
}

TYPED_TEST(TouchingBalls, ShotApartDoNotCollide) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& n : lines_of_centres<S>()) {
        for (const double overlap : kOverlaps) {
            for (const double speed : {1.0, 1e-9, 1e9}) {
                const Vec apart = S(speed) * n;
                const auto scene = pair<Type, S>(n, S(-overlap), -apart, apart);
                const auto played = play<Type>(scene, S(1));
                ASSERT_EQ(played.events, 0u) << overlap << " " << speed;
                ASSERT_EQ(played.velocity(1), apart);
                ASSERT_TRUE(played.audit().clean) << describe(played.audit());
            }
        }
    }
}

TYPED_TEST(TouchingBalls, ShotTogetherCollideAtOnce) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& n : lines_of_centres<S>()) {
        for (const double overlap : kOverlaps) {
            for (const double speed : {1.0, 1e-9, 1e9}) {
                const Vec towards = S(speed) * n;
                const auto scene = pair<Type, S>(n, S(-overlap), towards, -towards);
                const auto played = play<Type>(scene, S(1));
                ASSERT_EQ(played.events, 1u) << overlap << " " << speed;
                // At once, or when rounding of the direction has left a gap of its own.
                const S when = math::narrow(played.record.events[0].when) * S(speed);
                ASSERT_LT(in_epsilons<S>(when), 4) << overlap << " " << speed;
                // Masses 3 and 1 at +-v: the centre moves at v / 2, so 0 and 2 v remain.
                ASSERT_LT(in_epsilons<S>(math::norm<S>(played.velocity(0)) / S(speed)), 8);
                ASSERT_LT(
                    in_epsilons<S>(math::norm<S>(played.velocity(1) - S(2) * towards) / S(speed)),
                    8);
                ASSERT_TRUE(played.audit().clean) << describe(played.audit());
            }
        }
    }
}

TYPED_TEST(TouchingBalls, ShotAlongEachOtherSeparate) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& n : lines_of_centres<S>()) {
        const Vec tangent(-n.y(), n.x());
        for (const double overlap : kOverlaps) {
            const auto scene = pair<Type, S>(n, S(-overlap), tangent, -tangent);
            const auto played = play<Type>(scene, S(10));
            // Rounding of n decides whether they just touch; a touch without approach is no event,
            // and a collision that slow changes nothing.
            ASSERT_LE(played.events, 1u);
            ASSERT_LT(in_epsilons<S>(math::norm<S>(played.velocity(0) - tangent)), 4);
            ASSERT_LT(in_epsilons<S>(math::norm<S>(played.velocity(1) + tangent)), 4);
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
    // Where nothing rounds it is no event.
    const auto exact = pair<Type, S>(Vec(S(1), S(0)), S(0), Vec(S(0), S(1)), Vec(S(0), S(-1)));
    EXPECT_EQ(play<Type>(exact, S(10)).events, 0u);
}

TYPED_TEST(TouchingBalls, MovingTogetherDoNotCollide) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& n : lines_of_centres<S>()) {
        for (const double gap : {-1e-9, -1e-16, 0.0, 1e-16}) {
            const Vec v(S(0.3), S(-1.7));
            const auto played = play<Type>(pair<Type, S>(n, S(gap), v, v), S(1e6));
            ASSERT_EQ(played.events, 0u);
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
}

TYPED_TEST(TouchingBalls, NearMissesAndNearTouchesAreToldApart) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& n : lines_of_centres<S>()) {
        for (const double gap : {1e-15, 1e-12, 1e-9}) {
            const auto scene = pair<Type, S>(n, S(gap), n, Vec(S(0), S(0)));
            const auto played = play<Type>(scene, S(10));
            ASSERT_EQ(played.events, 1u);
            const S when = math::narrow(played.record.events[0].when);
            ASSERT_NEAR(math::to_double<S>(when), gap, 1e-15);
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
}

TYPED_TEST(TouchingBalls, SquashedBetweenAWallAndABallGetOut) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    // A ball frozen to a wall, and one thrown at it: T8 of the literature returns (-v, 0).
    Builder<Type> builder;
    builder.wall(Vec(S(1), S(-9)), Vec(S(1), S(9)))
        .ball(Vec(S(0), S(0)), Vec(S(0), S(0)), S(1))
        .ball(Vec(S(-5), S(0)), Vec(S(1), S(0)), S(1));
    const auto played = play<Type>(builder.scene, S(10));
    // In turn, or as one cluster of two contacts.
    EXPECT_EQ(played.events, TypeParam::kSymmetric ? 2u : 3u);
    EXPECT_EQ(played.velocity(0), Vec(S(0), S(0)));
    EXPECT_EQ(played.velocity(1), Vec(S(-1), S(0)));
    EXPECT_TRUE(played.audit().clean) << describe(played.audit());
}

}  // namespace
}  // namespace osculo::support

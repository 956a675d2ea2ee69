#include <gtest/gtest.h>

#include "support/laws.hpp"

// A ball at its radius from a wall, more or less: it must neither stick nor pass.
namespace osculo::support {
namespace {

/// Unit vectors to rounding, at [count] angles; those along the axes exactly.
template <math::Scalar S>
std::vector<math::Vec<S>> directions(int count) {
    std::vector<math::Vec<S>> all;
    for (int k = 0; k < count; ++k) {
        const double angle = 6.283185307179586 * k / count;
        const auto component = [](double x) { return S(std::abs(x) < 1e-12 ? 0.0 : x); };
        const math::Vec<S> raw(component(std::cos(angle)), component(std::sin(angle)));
        all.push_back(raw / math::norm<S>(raw));
    }
    return all;
}

constexpr double kGaps[] = {0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-6, -1e-6};

template <class U>
class TouchingWall : public ::testing::Test {};
TYPED_TEST_SUITE(TouchingWall, NativeUnderBoth, UnderName);

TYPED_TEST(TouchingWall, IsNeverPassedAtAnyAngle) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    const S radius(16);  // 1e-6 of overlap is still data
    const bool quick = !std::is_same_v<S, math::Quad>;
    for (const Vec& along : directions<S>(quick ? 40 : 12)) {
        for (const bool one_sided : {true, false}) {
            for (const double gap : kGaps) {
                for (const Vec& heading : directions<S>(quick ? 48 : 16)) {
                    Builder<Type> builder;
                    const Vec center(S(3), S(-5));
                    builder.wall(center - S(5000) * along, center + S(5000) * along, one_sided);
                    const geometry::Segment<S>& wall = std::get<1>(builder.scene.obstacles).front();
                    builder.ball(Vec(S(0), S(0)), heading, radius);
                    auto& position = builder.scene.bodies[0].state.position;
                    position = math::WidePoint<S>(center);
                    for (const S& part : {radius, S(gap)}) {
                        position = math::displaced<S>(position, wall.normal, part);
                    }
                    const auto played = play<Type>(builder.scene, S(100), 50);
                    const S inward = -math::accurate_dot<S>(heading, wall.normal);

                    const engine::RunAudit audit = played.audit();
                    ASSERT_TRUE(audit.clean) << describe(audit) << " gap " << gap << " inward "
                                             << math::to_double<S>(inward);
                    ASSERT_EQ(played.status, Status::time_limit);
                    const S distance =
                        math::dot<S>(Vec(played.position(0) - center), wall.normal) - radius;
                    ASSERT_GE(math::to_double<S>(distance), std::min(0.0, gap) - 1e-13);
                    if (inward > S(1e-12)) {
                        ASSERT_EQ(played.events, 1u);
                        const S outward = math::dot<S>(played.velocity(0), wall.normal);
                        ASSERT_LE(math::abs<S>(outward - inward), S(4) * math::epsilon<S>());
                    }
                    if (inward < S(-1e-12)) {
                        ASSERT_EQ(played.events, 0u);
                    }
                }
            }
        }
    }
}

template <class U>
class Corner : public ::testing::Test {};
TYPED_TEST_SUITE(Corner, NativeUnderBoth, UnderName);

TYPED_TEST(Corner, BothWallsAtOnceReturnTheBall) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const int corner : {0, 1, 2, 3}) {
        const Vec heading(S(corner % 2 ? 1 : -1), S(corner / 2 ? 1 : -1));
        Builder<Type> builder;
        builder.box(S(-5), S(-5), S(5), S(5)).ball(Vec(S(0), S(0)), heading, S(1));
        const auto played = play<Type>(builder.scene, S(13));
        ASSERT_EQ(played.events, 4u);  // at 4 s and, in the opposite corner, at 12 s
        EXPECT_EQ(played.record.events[0].when, played.record.events[1].when);
        EXPECT_EQ(played.record.events[1].after[0].velocity, Vec(-heading));
        EXPECT_TRUE(played.audit().clean) << describe(played.audit());
    }
}

TYPED_TEST(Corner, OfASlantedSquare) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const Vec& axis : directions<S>(std::is_same_v<S, double> ? 360 : 12)) {
        const Vec across(-axis.y(), axis.x());
        const Vec diagonal = axis + across;
        Builder<Type> builder;
        builder
            .outline({Vec(-S(5) * axis - S(5) * across), Vec(S(5) * axis - S(5) * across),
                      Vec(S(5) * axis + S(5) * across), Vec(-S(5) * axis + S(5) * across)})
            .ball(Vec(S(0), S(0)), diagonal, S(1));
        const auto played = play<Type>(builder.scene, S(99));
        const engine::RunAudit audit = played.audit();
        ASSERT_TRUE(audit.clean) << describe(audit);
        // Two walls each time, at 4, 12, .. 92 s, in whatever order rounding takes them.
        ASSERT_EQ(played.events, 24u);
        ASSERT_EQ(played.status, Status::time_limit);
        const Vec expected = S(3) * diagonal;  // 7 s after it was at -4 diagonals
        ASSERT_LT(in_epsilons<S>(math::norm<S>(played.position(0) - expected)), 1000);
    }
}

TYPED_TEST(Corner, InelasticWallsKeepTheBallIn) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const double restitution : {0.0, 0.3, 0.9}) {
        Builder<Type> builder;
        builder.restitution(S(restitution), S(restitution))
            .box(S(-5), S(-5), S(5), S(5))
            .ball(Vec(S(0), S(0)), Vec(S(1), S(1)), S(1));
        const auto played = play<Type>(builder.scene, S(4.5));
        EXPECT_EQ(played.events, 2u);
        const engine::RunAudit audit = played.audit();
        EXPECT_TRUE(audit.clean) << describe(audit);
        const S left = -S(restitution);
        EXPECT_LE(in_epsilons<S>(math::norm<S>(played.velocity(0) - Vec(left, left))), 2);
    }
}

TYPED_TEST(Corner, EndPointsStopBallsFromEverySide) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    for (const bool one_sided : {true, false}) {
        for (const Vec& heading : directions<S>(24)) {
            if (heading.x() < S(0)) continue;  // along the face
            Builder<Type> builder;
            builder.wall(Vec(S(0), S(0)), Vec(S(100), S(0)), one_sided)
                .ball(Vec(-S(5) * heading), heading, S(1));
            const auto played = play<Type>(builder.scene, S(8), 10);
            // Head-on it comes straight back, be it by the face or by the end.
            ASSERT_EQ(played.events, 1u)
                << math::to_double<S>(heading.x()) << " " << math::to_double<S>(heading.y());
            ASSERT_LT(in_epsilons<S>(math::norm<S>(played.velocity(0) + heading)), 8);
            ASSERT_LT(in_epsilons<S>(math::norm<S>(played.position(0) + S(5) * heading)), 32);
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
}

TYPED_TEST(Corner, TheEdgeOfAFaceIsNoGap) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    // Straight down within rounding of where the face ends and the end point takes over.
    for (const double offset : {0.0, 1e-30, -1e-30, 1e-17, -1e-17, 1e-12, -1e-12, 1e-6, -1e-6}) {
        for (const double slope : {0.0, 1e-17, -1e-17, 1e-9, -1e-9, 1e-3, -1e-3}) {
            Builder<Type> builder;
            builder.wall(Vec(S(0), S(0)), Vec(S(100), S(0)), true)
                .ball(Vec(S(offset), S(5)), Vec(S(slope), S(-1)), S(1));
            const auto played = play<Type>(builder.scene, S(100), 10);
            ASSERT_EQ(played.events, 1u) << offset << " " << slope;
            ASSERT_GT(played.velocity(0).y(), S(0.9));
            ASSERT_TRUE(played.audit().clean) << describe(played.audit());
        }
    }
}

TYPED_TEST(Corner, BetweenTwoWallsOneDiameterApart) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    using Vec = math::Vec<S>;
    const auto corridor = [](const S& room, const Vec& heading) {
        Builder<Type> builder;
        builder.wall(Vec(S(-1000), S(0)), Vec(S(1000), S(0)), true)
            .wall(Vec(S(1000), S(2) + room), Vec(S(-1000), S(2) + room), true)
            .ball(Vec(S(0), S(1)), heading, S(1));
        return builder.scene;
    };
    // Along: nothing happens.
    const auto along = play<Type>(corridor(S(0), Vec(S(1), S(0))), S(100));
    EXPECT_EQ(along.events, 0u);
    EXPECT_EQ(along.position(0), Vec(S(100), S(1)));
    // Across: jammed. In turn, that is said, and the ball is still there; at once, it loses what
    // takes it across.
    const auto across = play<Type>(corridor(S(0), Vec(S(1), S(-1))), S(100));
    EXPECT_EQ(across.status, TypeParam::kSymmetric ? Status::time_limit : Status::zeno);
    EXPECT_EQ(across.position(0), Vec(S(TypeParam::kSymmetric ? 100 : 0), S(1)));
    EXPECT_TRUE(across.audit().clean) << describe(across.audit());
    // With a little room it bounces, and gets along.
    for (const double room : {1e-3, 1e-9, 1e-12}) {
        const auto bouncing = play<Type>(corridor(S(room), Vec(S(1), S(-1))), S(1), 1000);
        EXPECT_TRUE(bouncing.audit().clean) << describe(bouncing.audit());
        EXPECT_GE(bouncing.events, 998u);
        // Each passage takes it as far along as across.
        const S passages = bouncing.position(0).x() / S(room);
        EXPECT_NEAR(math::to_double<S>(passages), static_cast<double>(bouncing.events), 1.001);
    }
}

}  // namespace
}  // namespace osculo::support

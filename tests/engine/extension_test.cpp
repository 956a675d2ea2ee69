#include <gtest/gtest.h>

#include "support/builder.hpp"

// A kind of obstacle and an impact law that osculo knows nothing of, added from outside: this file
// is all that they need.
namespace outside {

using osculo::math::Scalar;
using osculo::math::Vec;
using osculo::math::WidePoint;

/// A wall without ends, along the y axis at x, that balls on its left cannot pass.
template <Scalar S>
struct EndlessWall {
    S x;
};

template <Scalar S>
S first_contact(const osculo::motion::LinearPath<S>& path, const S& radius,
                const EndlessWall<S>& wall, const osculo::math::ContactHistory<S>& history,
                const S&) {
    if (history.just_resolved || !(path.velocity.x() > S(0))) return osculo::math::never<S>();
    const S gap = wall.x - radius - osculo::math::narrow(path.position.x);
    return gap > S(0) ? S(gap / path.velocity.x()) : S(0);
}

template <Scalar S>
Vec<S> contact_normal(const WidePoint<S>&, const EndlessWall<S>&) {
    return Vec<S>(S(1), S(0));
}

/// A drain: balls are gone as soon as their centre is to the right of x.
template <Scalar S>
struct Drain {
    S x;
};

template <Scalar S>
S first_contact(const osculo::motion::LinearPath<S>& path, const S&, const Drain<S>& drain,
                const osculo::math::ContactHistory<S>& history, const S&) {
    return first_contact(path, S(0), EndlessWall<S>{drain.x}, history, S(0));
}

template <Scalar S>
Vec<S> contact_normal(const WidePoint<S>&, const Drain<S>&) {
    return Vec<S>(S(1), S(0));
}

// What the audit asks of a kind of obstacle.
template <Scalar S>
Vec<S> origin(const EndlessWall<S>& wall) {
    return Vec<S>(wall.x, S(0));
}
template <Scalar S>
osculo::engine::Box box_around(const EndlessWall<S>& wall) {
    const double x = osculo::math::to_double<S>(wall.x);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {x, kInfinity, -kInfinity, kInfinity};
}
template <Scalar S>
S contact_gap(const WidePoint<S>& from_wall, const S& radius, const EndlessWall<S>&) {
    return -osculo::math::narrow(from_wall.x) - radius;
}
template <Scalar S>
osculo::engine::GapAt<S> smallest_gap(const osculo::engine::RelativePath<S>& path, const S& radius,
                                      const EndlessWall<S>& wall) {
    osculo::engine::GapAt<S> gap{contact_gap(path.start, radius, wall), S(0)};
    gap.keep_smaller(contact_gap(path.at(path.time), radius, wall), path.time);
    return gap;
}

/// Balls swap velocities whatever their masses; walls stop them dead.
struct Exchange {
    static constexpr const char* kName = "exchange";
    template <Scalar S>
    static void resolve(const S&, const S&, const S&, const Vec<S>&, Vec<S>& v1, Vec<S>& v2) {
        const Vec<S> first = v1;
        v1 = v2;
        v2 = first;
    }
    template <Scalar S>
    static void resolve(const S&, const Vec<S>&, Vec<S>& v) {
        v = Vec<S>(S(0), S(0));
    }
};

}  // namespace outside

template <osculo::math::Scalar S>
inline constexpr osculo::engine::Effect osculo::engine::kEffect<outside::Drain<S>> =
    osculo::engine::Effect::capture;

namespace osculo::support {
namespace {

template <class ObstacleKinds, class ImpactLaw>
using OwnScene = engine::SceneType<double, motion::Uniform, ObstacleKinds, ImpactLaw,
                                   impact::Sequential, engine::PieceRecorder, engine::AllPairs>;
using Vec = math::Vec<double>;

TEST(Extension, AnObstacleFromOutside) {
    using Type =
        OwnScene<engine::Obstacles<outside::EndlessWall, geometry::Point>, impact::Restitution>;
    Builder<Type> builder;
    std::get<0>(builder.scene.obstacles).push_back({10});
    builder.ball({0, 0}, {1, 0.5}).ball({-5, 0}, {0, 0});
    const auto played = play<Type>(builder.scene, 100);
    ASSERT_EQ(played.events, 1u);
    EXPECT_EQ(played.record.events[0].kind, engine::kFirstObstacle);
    EXPECT_EQ(played.record.events[0].when, math::Instant<double>(9.0));
    EXPECT_EQ(played.velocity(0), Vec(-1, 0.5));
    const engine::RunAudit audit = played.audit();
    EXPECT_TRUE(audit.clean) << describe(audit);
    EXPECT_EQ(audit.worst_gap, 0);
}

TEST(Extension, AnObstacleFromOutsideThatTakesBalls) {
    using Type = engine::SceneType<double, motion::Uniform, engine::Obstacles<outside::Drain>,
                                   impact::Restitution, impact::Sequential, engine::EventRecorder,
                                   engine::CellGrid>;
    Builder<Type> builder;
    std::get<0>(builder.scene.obstacles).push_back({10});
    builder.ball({0, 0}, {1, 0}).ball({-8, 0.5}, {2, 0}).ball({0, 9}, {0, 0});
    const auto played = play<Type>(builder.scene, 100);
    EXPECT_EQ(played.status, Status::at_rest);
    EXPECT_FALSE(played.bodies[0].present);
    EXPECT_FALSE(played.bodies[1].present);
    EXPECT_TRUE(played.bodies[2].present);
}

TEST(Extension, AnImpactLawFromOutside) {
    using Type = OwnScene<engine::Walls, outside::Exchange>;
    Builder<Type> builder;
    builder.wall({20, -9}, {20, 9}).ball({0, 0}, {3, 1}, 1, 5).ball({10, 3}, {0, 0.25}, 1, 1);
    const auto played = play<Type>(builder.scene, 100);
    ASSERT_EQ(played.events, 2u);
    EXPECT_EQ(played.record.events[0].after[0].velocity, Vec(0, 0.25));
    EXPECT_EQ(played.record.events[0].after[1].velocity, Vec(3, 1));
    EXPECT_EQ(played.velocity(1), Vec(0, 0));
    // The audit is not fooled by a law that keeps neither momentum nor energy.
    EXPECT_GT(played.audit().largest_momentum_error, 0.1);
}

}  // namespace
}  // namespace osculo::support

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "support/gas.hpp"
#include "support/laws.hpp"
#include "support/random_tables.hpp"
#include "support/same_bits.hpp"

// Mirrors, quarter turns and the order in which balls are listed change nothing, to the last bit.
namespace osculo::support {
namespace {

template <class U>
class Symmetry : public ::testing::Test {};
TYPED_TEST_SUITE(Symmetry, NativeUnderBoth, UnderName);

enum class Change { mirror, quarter_turn };

template <math::Scalar S>
math::Vec<S> changed(const math::Vec<S>& v, Change change) {
    return change == Change::mirror ? math::Vec<S>(-v.x(), v.y()) : math::Vec<S>(-v.y(), v.x());
}
template <math::Scalar S>
math::WidePoint<S> changed(const math::WidePoint<S>& p, Change change) {
    using Wide = math::Wide<S>;
    return change == Change::mirror ? math::WidePoint<S>(Wide(-p.x), p.y)
                                    : math::WidePoint<S>(Wide(-p.y), p.x);
}

template <class Type>
engine::SceneData<Type> changed_scene(engine::SceneData<Type> scene, Change change) {
    using S = typename Type::Scalar;
    for (auto& body : scene.bodies) {
        body.state.position = changed<S>(body.state.position, change);
        body.state.velocity = changed<S>(body.state.velocity, change);
    }
    const auto change_one = [&](auto& obstacle) {
        using Obstacle = std::decay_t<decltype(obstacle)>;
        if constexpr (std::is_same_v<Obstacle, geometry::Segment<S>>) {
            for (auto* v : {&obstacle.from, &obstacle.tangent, &obstacle.normal}) {
                *v = changed<S>(*v, change);
            }
        } else if constexpr (std::is_same_v<Obstacle, geometry::Point<S>>) {
            obstacle.at = changed<S>(obstacle.at, change);
        } else {
            obstacle.center = changed<S>(obstacle.center, change);
            if constexpr (std::is_same_v<Obstacle, geometry::Arc<S>>) {
                obstacle.start = changed<S>(obstacle.start, change);
                obstacle.end = changed<S>(obstacle.end, change);
                if (change == Change::mirror) std::swap(obstacle.start, obstacle.end);
            }
        }
    };
    std::apply(
        [&](auto&... kinds) { (std::for_each(kinds.begin(), kinds.end(), change_one), ...); },
        scene.obstacles);
    return scene;
}

TYPED_TEST(Symmetry, MirrorsAndQuarterTurns) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    const bool quick = std::is_same_v<S, double>;
    std::uint64_t events = 0;
    for (std::uint64_t seed = 0; seed < (quick ? 200 : 20); ++seed) {
        TableOptions options;
        options.restitution = seed % 4 == 0 ? 0.6 : 1;
        const auto scene =
            seed == 0 ? gas<Type>(16, 0.4, 1).scene : random_table<Type>(seed, options).scene;
        const auto plain = play<Type>(scene, S(20), 300);
        events += plain.events;
        // The impulses of a cluster are sums over x and y in turn: turned, they round otherwise.
        const bool clusters = std::ranges::any_of(
            plain.record.events, [](const auto& event) { return event.cluster.number != 0; });
        for (const Change change : {Change::mirror, Change::quarter_turn}) {
            if (clusters && change == Change::quarter_turn) continue;
            const auto other = play<Type>(changed_scene<Type>(scene, change), S(20), 300);
            ASSERT_EQ(plain.events, other.events) << "seed " << seed;
            for (std::size_t k = 0; k < plain.events; ++k) {
                const auto& one = plain.record.events[k];
                const auto& two = other.record.events[k];
                ASSERT_TRUE(one.when == two.when && one.kind == two.kind &&
                            one.first == two.first && one.second == two.second)
                    << "seed " << seed << " event " << k;
            }
            for (std::size_t i = 0; i < plain.bodies.size(); ++i) {
                ASSERT_EQ(changed<S>(plain.velocity(i), change), other.velocity(i)) << seed;
                const auto place = changed<S>(plain.bodies[i].state.position, change);
                ASSERT_TRUE(place.x == other.bodies[i].state.position.x &&
                            place.y == other.bodies[i].state.position.y)
                    << "seed " << seed;
            }
        }
    }
    EXPECT_GT(events, quick ? 20000u : 2000u);
}

TYPED_TEST(Symmetry, TheOrderOfBallsDoesNotMatter) {
    using S = typename TypeParam::Scalar;
    using Type = typename TypeParam::Type;
    const bool quick = std::is_same_v<S, double>;
    for (std::uint64_t seed = 1; seed < (quick ? 200 : 20); ++seed) {
        TableOptions options;
        options.restitution = seed % 4 == 0 ? 0.9 : 1;
        const auto scene = random_table<Type>(seed, options).scene;
        const std::size_t count = scene.bodies.size();
        std::vector<std::size_t> order(count);  // place k is taken by ball order[k]
        std::iota(order.begin(), order.end(), std::size_t(0));
        Random random(seed);
        for (std::size_t k = count; k > 1; --k) {
            std::swap(order[k - 1],
                      order[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
        }
        auto shuffled = scene;
        for (std::size_t k = 0; k < count; ++k) shuffled.bodies[k] = scene.bodies[order[k]];

        const auto plain = play<Type>(scene, S(20), 300);
        const auto other = play<Type>(shuffled, S(20), 300);
        ASSERT_EQ(plain.events, other.events) << "seed " << seed;
        ASSERT_EQ(plain.status, other.status) << "seed " << seed;
        for (std::size_t k = 0; k < plain.events; ++k) {
            ASSERT_EQ(plain.record.events[k].when, other.record.events[k].when) << seed;
            ASSERT_EQ(plain.record.events[k].kind, other.record.events[k].kind) << seed;
        }
        for (std::size_t k = 0; k < count; ++k) {
            ASSERT_EQ(plain.velocity(order[k]), other.velocity(k)) << "seed " << seed;
            ASSERT_TRUE(
                same_bits<S>(plain.bodies[order[k]].state.position, other.bodies[k].state.position))
                << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace osculo::support

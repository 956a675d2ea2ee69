#include "osculo/detect/certainly_apart.hpp"

#include <gtest/gtest.h>

#include "osculo/engine/traits.hpp"
#include "support/random.hpp"

// What is ruled out cheaply must be what the full arithmetic does not find: over random curved
// paths from grazing to far, near and far from the origin. Each test also fails if too little is
// ruled out to be worth the while.
namespace osculo::detect {
namespace {

using math::Vec;
using motion::ParabolicPath;

constexpr int kCases = 200'000;

template <math::Scalar S>
struct Case {
    ParabolicPath<S> path;
    Vec<S> target;
    S radius, horizon;
};

/// A path that passes a target at about [1 + 10^-k] radii, or somewhere else.
template <math::Scalar S>
Case<S> random_case(support::Random& random) {
    const S size = random.magnitude<S>(-6, 3);
    const Vec<S> target = (random.below(4) == 0 ? S(1e6) : S(1)) * size * random.direction<S>();
    const S radius = size * random.uniform<S>(S(0.01), S(0.5));
    const S duration = random.magnitude<S>(-6, 6);
    Case<S> result{{}, target, radius, S(0)};
    // From a point beside the target back along a parabola.
    const S k = support::power_of_ten<S>(-random.between(0, 16));
    const S aside = random.coin() ? S(radius * (S(1) + (random.coin() ? k : S(-k))))
                                  : S(size * random.uniform<S>(S(0), S(3)));
    const S speed = size / duration;
    const Vec<S> half = (speed / duration) * random.uniform<S>(S(0), S(2)) * random.direction<S>();
    const Vec<S> velocity = speed * random.uniform<S>(S(0), S(2)) * random.direction<S>();
    const S t = duration * random.uniform<S>(S(0), S(2));
    const Vec<S> there = target + aside * random.direction<S>();
    result.path.position =
        math::displaced<S>(math::WidePoint<S>(there), Vec<S>(-velocity), half, t);
    result.path.velocity = velocity - S(2) * t * half;
    result.path.half_acceleration = half;
    result.path.end = duration * random.uniform<S>(S(0.1), S(4));
    result.horizon = random.coin() ? math::never<S>() : S(duration * random.uniform<S>(S(0), S(4)));
    return result;
}

struct Share {
    int none = 0;   // cases without a contact
    int ruled = 0;  // of these, ruled out
};

template <math::Scalar S>
void note(Share& share, bool apart, const S& contact, const S& horizon, int k) {
    const bool found = math::is_finite<S>(contact) && contact <= horizon;
    ASSERT_FALSE(apart && found) << "case " << k;
    share.none += !found;
    share.ruled += apart;
}

template <class S>
class CertainlyApart : public testing::Test {
protected:
    template <class Obstacle>
    void check(std::uint64_t seed, double least_share,
               Obstacle (*make)(const Case<S>&, support::Random&)) {
        support::Random random(seed);
        Share share;
        for (int k = 0; k < kCases; ++k) {
            const Case<S> c = random_case<S>(random);
            const Obstacle obstacle = make(c, random);
            const bool apart = certainly_apart(c.path, c.radius, obstacle, c.horizon);
            const S t =
                first_contact(c.path, c.radius, obstacle, math::ContactHistory<S>{}, c.horizon);
            note(share, apart, t, c.horizon, k);
            if (this->HasFatalFailure()) return;
        }
        EXPECT_GT(share.ruled, least_share * share.none) << share.none << " without a contact";
    }
};

using Types = testing::Types<double, long double>;
TYPED_TEST_SUITE(CertainlyApart, Types);

TYPED_TEST(CertainlyApart, Points) {
    using S = TypeParam;
    this->template check<geometry::Point<S>>(
        1, 0.6, [](const Case<S>& c, support::Random&) { return geometry::Point<S>{c.target}; });
}

TYPED_TEST(CertainlyApart, Rims) {
    using S = TypeParam;
    this->template check<geometry::Rim<S>>(2, 0.6, [](const Case<S>& c, support::Random&) {
        return geometry::Rim<S>{c.target, c.radius};
    });
}

TYPED_TEST(CertainlyApart, Arcs) {
    using S = TypeParam;
    this->template check<geometry::Arc<S>>(3, 0.4, [](const Case<S>& c, support::Random& random) {
        const Vec<S> start = random.direction<S>();
        const Vec<S> end = random.direction<S>();
        return geometry::Arc<S>{c.target,
                                S(c.radius * random.uniform<S>(S(0.1), S(1))),
                                start,
                                end,
                                math::cross<S>(start, end) < S(0),
                                false};
    });
}

TYPED_TEST(CertainlyApart, Segments) {
    using S = TypeParam;
    this->template check<geometry::Segment<S>>(
        4, 0.5, [](const Case<S>& c, support::Random& random) {
            const Vec<S> along = c.radius * random.uniform<S>(S(0.1), S(9)) * random.direction<S>();
            return geometry::Segment<S>(c.target, c.target + along, random.coin());
        });
}

// Two curved paths that begin at different instants.
TYPED_TEST(CertainlyApart, Balls) {
    using S = TypeParam;
    support::Random random(5);
    Share share;
    for (int k = 0; k < kCases; ++k) {
        const Case<S> c = random_case<S>(random);
        // The other one moves, too: what is added to both cancels in between.
        const S scale = c.radius / c.path.end;
        const Vec<S> velocity = scale * random.direction<S>();
        const Vec<S> half = (scale / c.path.end) * random.direction<S>();
        ParabolicPath<S> first = c.path;
        first.velocity += velocity;
        first.half_acceleration += half;
        ParabolicPath<S> second{math::WidePoint<S>(c.target), velocity, half,
                                S(c.path.end * random.uniform<S>(S(0.5), S(2)))};
        const S shift = random.coin() ? S(0) : S(random.unit<S>() * second.end);
        const bool apart = certainly_apart(first, S(0), second, shift, c.radius, c.horizon);
        second.shift(shift);
        const S t = first_contact(first, second, c.radius, math::ContactHistory<S>{}, c.horizon);
        note(share, apart, t, c.horizon, k);
        if (this->HasFatalFailure()) return;
    }
    EXPECT_GT(share.ruled, 0.6 * share.none) << share.none << " without a contact";
}

}  // namespace
}  // namespace osculo::detect

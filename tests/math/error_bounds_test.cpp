#include "osculo/math/error_bounds.hpp"

#include <gtest/gtest.h>

#include "osculo/impact/restitution.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/math/first_root_parabolic.hpp"
#include "osculo/math/instant.hpp"
#include "support/contact_families.hpp"
#include "support/exact_scalars.hpp"

/// Of every bound: it suffices, and a tenth of it does not.
namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCases = 20000;
template <class S>
inline constexpr int kCasesOf = math::Builtin<S> ? kCases : kCases / 20;

template <class S>
class BuiltinBounds : public testing::Test {};
TYPED_TEST_SUITE(BuiltinBounds, BuiltinScalars, ScalarName);

TYPED_TEST(BuiltinBounds, RejectionSlackSparesEveryContactBesideTheCircle) {
    using S = TypeParam;
    const S slack = S(math::kRejectionSlack) * math::epsilon<S>();
    Random random(21);
    int lost_with_a_tenth = 0;
    for (int i = 0; i < kCases; ++i) {
        const S s = random.magnitude<S>(-3, 3);
        const S depth = S(random.between(0, 6)) * math::epsilon<S>() / 4;
        const PointCase<S> p =
            passing<S>(random.direction<S>(), s * random.unit<S>() * power_of_two<S>(-i % 4),
                       s * (1 - depth), s, random.magnitude<S>(-3, 3));
        if (!exact_entry(p)) continue;
        const S size = math::norm1<S>(p.b) * math::norm1<S>(p.c);
        EXPECT_FALSE(math::detail::certainly_beside<S>(p.c, p.b, p.s, S(slack * size), slack))
            << bits(p);
        lost_with_a_tenth +=
            math::detail::certainly_beside<S>(p.c, p.b, p.s, S(slack * size / 10), S(slack / 10));
    }
    EXPECT_GT(lost_with_a_tenth, 0);
}

TYPED_TEST(BuiltinBounds, RejectionSlackSparesEveryContactAtTheHorizon) {
    using S = TypeParam;
    const S slack = S(math::kRejectionSlack) * math::epsilon<S>();
    Random random(22);
    int lost_with_a_tenth = 0;
    for (int i = 0; i < kCases; ++i) {
        // Head on, the bound of the time is that of a contact from far away.
        const S s = random.magnitude<S>(-40, -1);
        const PointCase<S> p =
            passing<S>(random.direction<S>(), random.magnitude<S>(0, 3),
                       s * S(1 - random.unit<S>()), s, random.magnitude<S>(-3, 3));
        const S slope = math::accurate_dot<S>(p.b, p.c);
        const GapFunction<Exact> f(p);
        if (!exact_entry(p)) continue;
        // The bound's own instant: no contact is earlier.
        const S horizon = rounded<S>(Exact(f.gap / (-2 * f.slope)));
        EXPECT_FALSE(math::detail::certainly_later<S>(p.c, p.s, slope, S(0), horizon, slack))
            << bits(p);
        lost_with_a_tenth +=
            math::detail::certainly_later<S>(p.c, p.s, slope, S(0), horizon, S(slack / 10));
    }
    EXPECT_GT(lost_with_a_tenth, 0);
}

TYPED_TEST(BuiltinBounds, ExactStageBeginsWhereWideArithmeticEnds) {
    using S = TypeParam;
    const Exact eps = exact<Exact>(math::epsilon<S>());
    Random random(23);
    Exact worst_outside = 0;
    Exact worst_at_a_tenth = 0;
    for (int i = 0; i < kCases; ++i) {
        const S s = random.magnitude<S>(-3, 3);
        const S depth = math::epsilon<S>() * random.magnitude<S>(0, 5);
        const PointCase<S> p = passing<S>(random.direction<S>(), s * random.magnitude<S>(-4, 0),
                                          s * (1 - depth), s, random.magnitude<S>(-3, 3));
        const auto most = math::two_product(s, s) * math::wide_dot<S>(p.b, p.b);
        const auto moment = math::wide_cross<S>(p.b, p.c);
        const auto difference = most - moment * moment;
        const Exact reference = GapFunction<Exact>(p).discriminant;
        if (reference == 0) continue;
        const Exact error = abs(Exact(exact<Exact>(difference) / reference - 1));
        const Exact band = abs(Exact(reference / (math::kExactStage * eps * exact<Exact>(most))));
        if (band > 1) worst_outside = std::max(worst_outside, error);
        if (band > 0.1) worst_at_a_tenth = std::max(worst_at_a_tenth, error);
        EXPECT_LE(
            abs(Exact(exact<Exact>(math::detail::discriminant<S>(p.c, p.b, p.s)) / reference - 1)),
            eps / 10)
            << bits(p);
    }
    EXPECT_LE(worst_outside, eps / 10);
    EXPECT_GT(worst_outside, 0);
    EXPECT_GT(worst_at_a_tenth, eps / 10);
}

template <class S>
class AnyBounds : public testing::Test {};
TYPED_TEST_SUITE(AnyBounds, AllScalars, ScalarName);

TYPED_TEST(AnyBounds, VelocityNoiseCoversTheClosingSpeedOfAnInelasticPair) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(24);
    R worst = 0;
    for (int i = 0; i < kCasesOf<S>; ++i) {
        const math::Vec<S> n = random.direction<S>() * random.magnitude<S>(-5, 5);
        math::Vec<S> v1 = random.direction<S>() * random.magnitude<S>(-5, 5);
        math::Vec<S> v2 = random.direction<S>() * random.magnitude<S>(-5, 5);
        const S before = math::norm1<S>(v1) + math::norm1<S>(v2);
        impact::Restitution::resolve<S>(S(0), random.magnitude<S>(-5, 5),
                                        random.magnitude<S>(-5, 5), n, v1, v2);
        const S after = math::norm1<S>(v1) + math::norm1<S>(v2);
        const R nx = exact<R>(S(n.x()));
        const R ny = exact<R>(S(n.y()));
        const R closing = (exact<R>(S(v1.x())) - exact<R>(S(v2.x()))) * nx +
                          (exact<R>(S(v1.y())) - exact<R>(S(v2.y()))) * ny;
        const R unit = exact<R>(math::epsilon<S>()) * (exact<R>(before) + exact<R>(after));
        worst = std::max(worst, R(abs(closing) / (sqrt(nx * nx + ny * ny) * unit)));
    }
    EXPECT_LE(worst, math::kVelocityNoise);
    EXPECT_GT(worst, R(math::kVelocityNoise) / 10);
}

/// Two balls meet as in the engine; returns the gap that rounding leaves and what it is measured
/// by.
template <class S, class R>
struct Meeting {
    R gap;
    S measured;  ///< the gap as the engine sees it
    S reach;
    S travelled;  ///< as the engine sums it up
    bool met;

    explicit Meeting(Random& random, int distance) {
        const S s = random.magnitude<S>(-3, 3);
        const PointCase<S> p =
            passing<S>(random.direction<S>(), s * S(1 + random.magnitude<S>(-5, distance)),
                       s * random.signed_unit<S>(), s, random.magnitude<S>(-2, 2));
        const math::Vec<S> drift = p.b * random.signed_unit<S>();
        const math::Vec<S> first = p.b + drift;
        math::WidePoint<S> one(math::Vec<S>(p.c + random.direction<S>() * s));
        math::WidePoint<S> other(math::Vec<S>(one.rounded() - p.c));
        const S t = math::first_entry<S>(math::difference<S>(one, other), first - drift, s);
        met = math::is_finite<S>(t) && t > S(0);
        if (!met) return;
        one = math::displaced<S>(one, first, t);
        other = math::displaced<S>(other, drift, t);
        const R x = exact<R>(one.x) - exact<R>(other.x);
        const R y = exact<R>(one.y) - exact<R>(other.y);
        reach = s;
        gap = abs(R(sqrt(R(x * x + y * y)) - exact<R>(s)));
        measured = math::abs<S>(math::norm<S>(math::difference<S>(one, other)) - s);
        travelled = (math::norm1<S>(first) + math::norm1<S>(drift)) * t;
    }
};

TYPED_TEST(AnyBounds, TouchCoversTheGapThatAContactNearbyLeaves) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(25);
    R worst = 0;
    for (int i = 0; i < kCasesOf<S>; ++i) {
        const Meeting<S, R> m(random, 0);
        if (m.met && m.travelled <= 4 * m.reach) {
            worst = std::max(worst, R(m.gap / exact<R>(S(math::epsilon<S>() * m.reach))));
        }
    }
    EXPECT_LE(worst, math::kTouch);
    EXPECT_GT(worst, R(math::kTouch) / 10);
}

TYPED_TEST(AnyBounds, ContactGapCoversWhatAnyContactLeaves) {
    using S = TypeParam;
    Random random(26);
    S worst(0);
    for (int i = 0; i < kCasesOf<S>; ++i) {
        const Meeting<S, ExactFor<S>> m(random, 12);
        if (!m.met) continue;
        worst = std::max<S>(worst, m.measured / (math::epsilon<S>() * (m.reach + m.travelled)));
    }
    EXPECT_LE(worst, S(math::kContactGap));
    EXPECT_GT(worst, S(math::kContactGap) / 10);
}

/// In the sum of an instant and a wait: 1/2 for types that are their own wide type, less for the
/// others, whose wide epsilon is a bound for products too.
TYPED_TEST(AnyBounds, SameInstantIsWhatIsLostInTheSumWithAWait) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(28);
    R worst = 0;
    for (int i = 0; i < kCasesOf<S>; ++i) {
        const S early = random.magnitude<S>(-10, 30);
        const math::Instant<S> now =
            math::after<S>(math::Instant<S>(early), S(early * random.magnitude<S>(-60, 0)));
        const S wait = early * random.magnitude<S>(-120, 0);
        const math::Instant<S> then = math::after<S>(now, wait);
        const R lost = abs(R(exact<R>(then) - exact<R>(now) - exact<R>(wait)));
        worst =
            std::max(worst, R(lost / exact<R>(S(math::wide_epsilon<S>() * math::narrow(then)))));
    }
    EXPECT_LE(worst, math::kSameInstant);
    if (!math::Builtin<S>) {
        EXPECT_GT(worst, R(math::kSameInstant) / 10);
    }
}

TEST(Bounds, StartOverlapCoversTouchingBallsTypedWithEightDigits) {
    Random random(27);
    double worst = 0;
    const auto typed = [](double x) { return std::round(x * 1e8) / 1e8; };
    for (int i = 0; i < kCases; ++i) {
        // Radii and coordinates of the same size, with eight digits behind the point.
        const double r1 = random.uniform<double>(0.3, 1.0);
        const double r2 = random.uniform<double>(0.3, 1.0);
        const math::Vec<double> from = random.direction<double>() * random.unit<double>();
        const math::Vec<double> to = from + random.direction<double>() * (r1 + r2);
        const math::Vec<double> apart(typed(to.x()) - typed(from.x()),
                                      typed(to.y()) - typed(from.y()));
        const double overlap = typed(r1) + typed(r2) - math::norm<double>(apart);
        worst = std::max(worst, overlap / std::min(r1, r2));
    }
    EXPECT_LE(worst, math::kStartOverlap);
    EXPECT_GT(worst, math::kStartOverlap / 10);
}

/// On an axis at the distance s a tangent is one without any rounding.
TYPED_TEST(BuiltinBounds, TangentIsWhatRoundingMakesOfATangentOnACurvedPath) {
    using S = TypeParam;
    const S eps = math::epsilon<S>();
    Random random(29);
    int above_a_hundredth = 0;
    for (int i = 0; i < kCases; ++i) {
        const S s = random.magnitude<S>(-6, 0);
        const S u = random.magnitude<S>(-3, 3);
        const S time = s / u * random.magnitude<S>(-4, i % 2 == 0 ? 0 : 10);
        const S w = u / time * random.magnitude<S>(-6, -3) * random.signed_unit<S>();
        const math::ParabolicApproach<S> p{{-time * (u + time * w), s}, {u, S(0)}, {w, S(0)}, s};
        EXPECT_FALSE(math::is_finite<S>(math::first_entry<S>(p, S(2) * time))) << bits<S>(p.c);
        const S t = p.sharpened_turn(time);
        const S slope = math::narrow(p.wide_approach(t));
        const S beyond = slope * slope / p.bend(t);
        const S gap = math::narrow(math::Wide<S>(p.wide_gap(t) - beyond));
        const S least = eps * eps * p.wide_gap_error(t, p.place(t));
        EXPECT_LE(math::abs<S>(gap), least) << bits<S>(p.c);
        above_a_hundredth += math::abs<S>(gap) > least / S(100);
    }
    EXPECT_GT(above_a_hundredth, 0);
}

}  // namespace

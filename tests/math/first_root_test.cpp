#include "osculo/math/first_root.hpp"

#include <gtest/gtest.h>

#include "support/contact_families.hpp"
#include "support/exact_scalars.hpp"
#include "support/tally.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCasesPerFamily = 8000;
constexpr std::uint64_t kSeed = 20240607;

/// bench/first_contact_accuracy runs the same on millions.
template <class S>
class BuiltinFirstRoot : public testing::Test {};
TYPED_TEST_SUITE(BuiltinFirstRoot, BuiltinScalars, ScalarName);

TYPED_TEST(BuiltinFirstRoot, EntryIsExactlyDecidedAndCorrectToTwoUlps) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        SCOPED_TRACE(family.name);
        Random random(kSeed);
        Tally tally;
        for (int i = 0; i < kCasesPerFamily; ++i) {
            const PointCase<S> p = family.make(random);
            const bool right = tally.add<S>(math::first_entry<S>(p.c, p.b, p.s), exact_entry(p));
            ASSERT_TRUE(right) << bits(p);
        }
        EXPECT_LE(tally.quantile(1), 2.0);
    }
}

TYPED_TEST(BuiltinFirstRoot, ExitIsExactlyDecidedAndCorrectToTwoUlps) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        SCOPED_TRACE(family.name);
        Random random(kSeed + 1);
        Tally tally;
        for (int i = 0; i < kCasesPerFamily; ++i) {
            const PointCase<S> p = family.make(random);
            const bool right = tally.add<S>(math::first_exit<S>(p.c, p.b, p.s), exact_exit(p));
            ASSERT_TRUE(right) << bits(p);
        }
        EXPECT_LE(tally.quantile(1), 2.0);
    }
}

TYPED_TEST(BuiltinFirstRoot, HorizonCullsNothingThatComesBeforeIt) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        Random random(kSeed + 2);
        for (int i = 0; i < kCasesPerFamily / 4; ++i) {
            const PointCase<S> p = family.make(random);
            const S t = math::first_entry<S>(p.c, p.b, p.s);
            if (!math::is_finite<S>(t)) continue;
            EXPECT_EQ(t, math::first_entry<S>(p.c, p.b, p.s, {}, t)) << bits(p);
            // Far too late must be seen without solving; anything between may be answered or not.
            const S early = math::first_entry<S>(p.c, p.b, p.s, {}, S(t * S(0.25)));
            EXPECT_TRUE(early == t || !math::is_finite<S>(early)) << bits(p);
        }
    }
}

TYPED_TEST(BuiltinFirstRoot, ScalesWithPowersOfTwoBitForBit) {
    using S = TypeParam;
    Random random(kSeed + 3);
    for (const auto& family : kContactFamilies<S>) {
        if (std::string(family.name) == "any scale") continue;  // has used the exponents up
        for (int i = 0; i < kCasesPerFamily / 4; ++i) {
            const PointCase<S> p = family.make(random);
            const int length = random.between(-200, 200);
            const int time = random.between(-200, 200);
            const math::Vec<S> c = p.c * power_of_two<S>(length);
            const math::Vec<S> b = p.b * power_of_two<S>(length) * power_of_two<S>(-time);
            const S s = p.s * power_of_two<S>(length);
            const S unit = power_of_two<S>(time);
            EXPECT_EQ(S(math::first_entry<S>(p.c, p.b, p.s) * unit), math::first_entry<S>(c, b, s))
                << bits(p) << " lengths 2^" << length << " times 2^" << time;
            EXPECT_EQ(S(math::first_exit<S>(p.c, p.b, p.s) * unit), math::first_exit<S>(c, b, s))
                << bits(p) << " lengths 2^" << length << " times 2^" << time;
        }
    }
}

TYPED_TEST(BuiltinFirstRoot, IsTheSameInAMirror) {
    using S = TypeParam;
    for (const auto& family : kContactFamilies<S>) {
        Random random(kSeed + 4);
        for (int i = 0; i < kCasesPerFamily / 4; ++i) {
            const PointCase<S> p = family.make(random);
            const S t = math::first_entry<S>(p.c, p.b, p.s);
            const auto mirrored = [&](auto map) {
                return math::first_entry<S>(map(p.c), map(p.b), p.s);
            };
            using V = math::Vec<S>;
            EXPECT_EQ(t, mirrored([](const V& v) { return V(-v); })) << bits(p);
            EXPECT_EQ(t, mirrored([](const V& v) { return V(-v.x(), v.y()); })) << bits(p);
            EXPECT_EQ(t, mirrored([](const V& v) { return V(v.y(), v.x()); })) << bits(p);
        }
    }
}

/// Types that are their own wide type lose what cancels: still every decision is right where more
/// than rounding decides.
template <class S>
class WiderFirstRoot : public testing::Test {};
TYPED_TEST_SUITE(WiderFirstRoot, WiderScalars, ScalarName);

TYPED_TEST(WiderFirstRoot, IsRightWhereItsRoundingDoesNotDecide) {
    using S = TypeParam;
    using R = Exacter;
    for (const auto& family : kContactFamilies<S>) {
        SCOPED_TRACE(family.name);
        Random random(kSeed + 5);
        int contacts = 0;
        for (int i = 0; i < kCasesPerFamily / 8; ++i) {
            const PointCase<S> p = family.make(random);
            const GapFunction<R> f(p);
            // Rounding of the gap, of the discriminant (where b x c cancels) and of the slope.
            const R eps = exact<R>(math::epsilon<S>());
            const R ss = exact<R>(p.s) * exact<R>(p.s);
            const R cc = f.gap + ss;
            const R terms = f.quadratic * cc;
            const R blur = 8 * eps * (f.quadratic * ss + sqrt(f.quadratic * ss * terms)) +
                           8 * eps * eps * terms;
            if (abs(f.gap) <= 8 * eps * cc || abs(f.discriminant) <= blur ||
                f.slope * f.slope <= 64 * eps * eps * terms) {
                continue;
            }
            const auto reference = exact_entry(p);
            const S t = math::first_entry<S>(p.c, p.b, p.s);
            ASSERT_EQ(reference.has_value(), math::is_finite<S>(t)) << bits(p);
            if (!reference || *reference == 0) continue;
            ++contacts;
            const R root = sqrt(f.discriminant);
            const R bound = 8 + 4 * cc / f.gap + blur / (eps * root * (root - f.slope)) +
                            4 * sqrt(terms) / (root - f.slope);
            EXPECT_LE(error_in_ulp<S>(t, *reference), static_cast<double>(bound)) << bits(p);
        }
        if (!family.adversarial) {
            EXPECT_GT(contacts, 50);
        }
    }
}

/// What an impact leaves of the approach is no contact until it has become noticeable.
TEST(FirstRoot, JustResolvedPairsMeetAgainOnlyIfTheyComeNoticeablyNearer) {
    const math::ContactHistory<double> resolved{true, 0};
    const double noticeable = math::kTouch * math::epsilon<double>();
    const auto again = [&](const math::Vec<double>& c, const math::Vec<double>& b) {
        return math::first_entry<double>(c, b, 1.0, resolved);
    };
    EXPECT_FALSE(math::is_finite<double>(again({1, 0}, {1e-17, 0})));
    EXPECT_FALSE(math::is_finite<double>(again({1, 0}, {0, 1})));
    EXPECT_FALSE(math::is_finite<double>(again({1, 0}, {-1e-17, 1})));
    EXPECT_NEAR(noticeable / 1e-17, again({1, 0}, {-1e-17, 0}), 1e-10 * noticeable / 1e-17);
    EXPECT_NEAR(noticeable, again({1, 0}, {-1, 0}), 1e-10 * noticeable);
}

/// Back inwards from a circle around it, the contact just resolved is the other root.
TEST(FirstRoot, ExitAfterAContactFromInsideIsTheLaterRoot) {
    Random random(kSeed + 6);
    for (int i = 0; i < kCasesPerFamily; ++i) {
        const PointCase<double> p = touching_sideways<double>(random);
        const GapFunction<Exact> f(p);
        if (f.slope >= 0) continue;
        const double t = math::first_exit<double>(p.c, p.b, p.s, {true, 0}, true);
        // Without a root (outside throughout, by rounding) as if from exactly on the circle.
        const Exact way =
            f.discriminant > 0 ? Exact(sqrt(f.discriminant) - f.slope) : Exact(-2 * f.slope);
        EXPECT_LE(error_in_ulp<double>(t, Exact(way / f.quadratic)), 1.0) << bits(p);
    }
}

/// Without the rule on noise a residual closing speed of rounding size is a contact at once.
TEST(FirstRoot, ClosingSpeedsOfRoundingSizeAreNoContactUntilTheyAreNoticed) {
    const math::ContactHistory<double> noisy{false, 4e-16};
    const math::Vec<double> c(1, 0);
    EXPECT_EQ(0.0, math::first_entry<double>(c, {-1e-16, 0}, 1.0));
    EXPECT_GT(math::first_entry<double>(c, {-1e-16, 0}, 1.0, noisy), 1.0);
    EXPECT_FALSE(math::is_finite<double>(math::first_entry<double>(c, {-1e-16, 1}, 1.0, noisy)));
    EXPECT_EQ(0.0, math::first_entry<double>(c, {-1e-15, 1}, 1.0, noisy));
    // Not touching: a contact when they meet, however slow.
    const double meeting = math::first_entry<double>({1 + 1e-12, 0}, {-1e-16, 0}, 1.0);
    EXPECT_EQ(meeting, math::first_entry<double>({1 + 1e-12, 0}, {-1e-16, 0}, 1.0, noisy));
}

}  // namespace

#include "osculo/math/wide.hpp"

#include <gtest/gtest.h>

#include "osculo/math/exact_sum.hpp"
#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCases = 20000;

template <class S>
class WideTest : public testing::Test {
protected:
    using W = math::DoubleDouble<S>;

    /// Rounding unit 2^-p.
    static Exact unit() { return exact<Exact>(S(math::epsilon<S>() / 2)); }

    static Exact relative_error(const W& computed, const Exact& reference) {
        const Exact error = abs(Exact(exact<Exact>(computed) - reference));
        return error == 0 ? error : Exact(error / abs(reference));
    }

    S scalar(int low, int high) {
        const S x = random.magnitude<S>(low, high);
        return random.coin() ? x : S(-x);
    }

    /// Any wide number; some with a short or a missing low part.
    W wide(int low, int high) {
        const S hi = scalar(low, high);
        const S half_ulp = math::abs(hi) * math::epsilon<S>() / 4;
        const S lo = half_ulp * random.signed_unit<S>();
        switch (random.below(4)) {
            case 0: return hi;
            case 1: return math::quick_two_sum(hi, S(lo * power_of_two<S>(-random.between(1, 60))));
            default: return math::quick_two_sum(hi, lo);
        }
    }

    Random random{77};
};
TYPED_TEST_SUITE(WideTest, BuiltinScalars, ScalarName);

TYPED_TEST(WideTest, SumAndProductOfScalarsAreExact) {
    using S = TypeParam;
    for (int i = 0; i < kCases; ++i) {
        const S a = this->scalar(-60, 60);
        const S b = this->scalar(-60, 60);
        EXPECT_EQ(Exact(a) + Exact(b), exact<Exact>(math::two_sum(a, b))) << bits(a) << bits(b);
        EXPECT_EQ(Exact(a) * Exact(b), exact<Exact>(math::two_product(a, b))) << bits(a) << bits(b);
        EXPECT_EQ(math::two_product(a, b).hi, S(a * b));
    }
}

TYPED_TEST(WideTest, SumErrsByThreeUnitsSquaredEvenIfItCancels) {
    using S = TypeParam;
    const Exact bound = Exact(3.01) * this->unit() * this->unit();
    Exact worst = 0;
    for (int i = 0; i < kCases; ++i) {
        const auto a = this->wide(-3, 3);
        auto b = this->wide(-3, 3);
        if (i % 2 == 0) {  // nearly -a
            b = math::quick_two_sum(
                S(-a.hi * (1 + this->random.between(-2, 2) * math::epsilon<S>())),
                S(a.lo * this->random.template signed_unit<S>()));
        }
        const Exact error = this->relative_error(a + b, exact<Exact>(a) + exact<Exact>(b));
        ASSERT_LE(error, bound) << bits(a.hi) << bits(a.lo) << bits(b.hi) << bits(b.lo);
        worst = std::max(worst, error);
        EXPECT_LE(this->relative_error(a - b, exact<Exact>(a) - exact<Exact>(b)), bound);
        EXPECT_LE(this->relative_error(a + b.hi, exact<Exact>(a) + Exact(b.hi)), bound);
        EXPECT_LE(this->relative_error(a - b.hi, exact<Exact>(a) - Exact(b.hi)), bound);
    }
    EXPECT_GT(worst, bound / 10);
}

TYPED_TEST(WideTest, ProductErrsByFiveUnitsSquared) {
    const Exact bound = Exact(5.01) * this->unit() * this->unit();
    Exact worst = 0;
    for (int i = 0; i < kCases; ++i) {
        const auto a = this->wide(-60, 60);
        const auto b = this->wide(-60, 60);
        const Exact error = this->relative_error(a * b, exact<Exact>(a) * exact<Exact>(b));
        ASSERT_LE(error, bound) << bits(a.hi) << bits(a.lo) << bits(b.hi) << bits(b.lo);
        worst = std::max(worst, error);
    }
    EXPECT_GT(worst, bound / 10);
}

TYPED_TEST(WideTest, QuotientIsAlmostCorrectlyRounded) {
    using S = TypeParam;
    for (int i = 0; i < kCases; ++i) {
        const auto a = this->wide(-60, 60);
        const auto b = this->wide(-60, 60);
        const Exact reference = exact<Exact>(a) / exact<Exact>(b);
        EXPECT_LE(error_in_ulp<S>(math::quotient(a, b), reference), 0.51)
            << bits(a.hi) << bits(a.lo) << bits(b.hi) << bits(b.lo);
    }
    EXPECT_EQ(S(0), math::quotient(math::DoubleDouble<S>(S(0)), math::DoubleDouble<S>(S(3))));
}

TYPED_TEST(WideTest, SquareRootErrsByFourUnitsSquared) {
    using S = TypeParam;
    const Exact bound = 4 * this->unit() * this->unit();
    for (int i = 0; i < kCases; ++i) {
        auto a = this->wide(-60, 60);
        if (a < S(0)) a = -a;
        EXPECT_LE(this->relative_error(math::wide_square_root(a), sqrt(exact<Exact>(a))), bound)
            << bits(a.hi) << bits(a.lo);
        const S x = this->scalar(-30, 30);
        EXPECT_EQ(math::abs(x), math::wide_square_root(math::two_product(x, x)).hi);
    }
    EXPECT_EQ(S(0), math::wide_square_root(math::DoubleDouble<S>(S(0))).hi);
}

TYPED_TEST(WideTest, OrderIsThatOfTheNumbers) {
    for (int i = 0; i < kCases; ++i) {
        const auto a = this->wide(-2, 2);
        auto b = i % 2 == 0
                     ? this->wide(-2, 2)
                     : math::DoubleDouble<TypeParam>(a.hi, this->random.coin() ? -a.lo : a.lo);
        const Exact difference = exact<Exact>(a) - exact<Exact>(b);
        EXPECT_EQ(difference < 0, a < b);
        EXPECT_EQ(difference > 0, a > b);
        EXPECT_EQ(difference <= 0, a <= b);
        EXPECT_EQ(difference >= 0, a >= b);
        EXPECT_EQ(difference == 0, a == b);
    }
}

TYPED_TEST(WideTest, ExactSumRoundsNothing) {
    using S = TypeParam;
    const Exact bound = 4 * this->unit() * this->unit();
    for (int i = 0; i < kCases / 10; ++i) {
        math::ExactSum<S, 20> sum;
        Exact reference = 0;
        const auto add = [&](const S& x) {
            sum.add(x);
            reference += Exact(x);
        };
        for (int k = 0; k < 4; ++k) {
            const S a = this->scalar(-20, 20);
            const S b = this->scalar(-20, 20);
            sum.add_product(a, b);
            reference += Exact(a) * Exact(b);
            const S c = this->scalar(-40, 40);
            add(c);
            // Takes most of it away again.
            if (this->random.coin()) add(S(-(a * b)));
            if (this->random.coin()) add(S(-c));
        }
        EXPECT_LE(this->relative_error(sum.value(), reference), bound);
        math::ExactSum<S, 3> nothing;
        const S x = this->scalar(-20, 20);
        nothing.add_product(x, S(3));
        nothing.add(S(-3 * x));
        EXPECT_EQ(Exact(3) * Exact(x) - Exact(S(3 * x)), exact<Exact>(nothing.value()));
    }
}

}  // namespace

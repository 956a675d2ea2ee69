#include "osculo/math/vec.hpp"

#include <gtest/gtest.h>

#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr int kCases = 20000;

template <class S>
S any(Random& random, int low, int high) {
    const S x = random.magnitude<S>(low, high);
    return random.coin() ? x : S(-x);
}

template <class S>
class BuiltinVec : public testing::Test {};
TYPED_TEST_SUITE(BuiltinVec, BuiltinScalars, ScalarName);

TYPED_TEST(BuiltinVec, DifferenceOfProductsKeepsSignAndDigitsWhateverCancels) {
    using S = TypeParam;
    Random random(5);
    double worst = 0;
    for (int i = 0; i < kCases; ++i) {
        const S a = any<S>(random, -3, 3);
        const S b = any<S>(random, -3, 3);
        const S c = any<S>(random, -3, 3);
        S d = any<S>(random, -3, 3);
        // Two in three nearly cancel: d is a b / c, or one or two units beside it.
        if (i % 3 != 0) d = (a * b / c) * (1 + S(random.between(-2, 2)) * math::epsilon<S>());
        const Exact reference = Exact(a) * Exact(b) - Exact(c) * Exact(d);
        const S computed = math::difference_of_products<S>(a, b, c, d);
        const double error = error_in_ulp<S>(computed, reference);
        ASSERT_LE(error, 1.5) << bits(a) << " " << bits(b) << " " << bits(c) << " " << bits(d);
        ASSERT_EQ(reference > 0, computed > 0);
        ASSERT_EQ(reference < 0, computed < 0);
        worst = std::max(worst, error);
    }
    EXPECT_GT(worst, 0.15);
}

TYPED_TEST(BuiltinVec, SignsOfDotAndCrossAreExact) {
    using S = TypeParam;
    Random random(6);
    for (int i = 0; i < kCases; ++i) {
        const math::Vec<S> a(any<S>(random, -8, 8), any<S>(random, -8, 8));
        const S stretch = any<S>(random, -4, 4);
        // Parallel and perpendicular to rounding.
        const math::Vec<S> along = a * stretch;
        const math::Vec<S> across(-along.y(), along.x());
        const Exact cross = Exact(a.x()) * Exact(along.y()) - Exact(a.y()) * Exact(along.x());
        const Exact dot = Exact(a.x()) * Exact(across.x()) + Exact(a.y()) * Exact(across.y());
        EXPECT_EQ(cross.sign(), Exact(math::accurate_cross<S>(a, along)).sign()) << bits<S>(a);
        EXPECT_EQ(dot.sign(), Exact(math::accurate_dot<S>(a, across)).sign()) << bits<S>(a);
    }
}

TYPED_TEST(BuiltinVec, DifferencesOfFarPointsLoseNothing) {
    using S = TypeParam;
    Random random(7);
    for (int i = 0; i < kCases; ++i) {
        const auto coordinate = [&] {
            return math::Wide<S>(
                math::two_sum(S(1e8 + 1000 * random.unit<S>()), S(1e-8 * random.signed_unit<S>())));
        };
        const math::WidePoint<S> a(coordinate(), coordinate());
        const math::WidePoint<S> b(coordinate(), coordinate());
        const math::Vec<S> d = math::difference<S>(a, b);
        EXPECT_LE(error_in_ulp<S>(d.x(), Exact(exact<Exact>(a.x) - exact<Exact>(b.x))), 0.5001);
        EXPECT_LE(error_in_ulp<S>(d.y(), Exact(exact<Exact>(a.y) - exact<Exact>(b.y))), 0.5001);
        const math::Vec<S> e = math::difference<S>(a, b.rounded());
        EXPECT_LE(error_in_ulp<S>(e.x(), Exact(exact<Exact>(a.x) - Exact(b.x.hi))), 0.5001);
    }
}

template <class S>
class AnyVec : public testing::Test {};
TYPED_TEST_SUITE(AnyVec, AllScalars, ScalarName);

TYPED_TEST(AnyVec, NormIsCorrectToFourUlps) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(8);
    double worst = 0;
    for (int i = 0; i < kCases / 4; ++i) {
        math::Vec<S> v(any<S>(random, -8, 8), any<S>(random, -8, 8));
        if (i % 8 == 0) v.x() = S(0);
        v *= power_of_two<S>(random.between(-900, 900));  // the square is out of range
        const R x = exact<R>(S(v.x()));
        const R y = exact<R>(S(v.y()));
        const double error = error_in_ulp<S>(math::norm<S>(v), R(sqrt(R(x * x + y * y))));
        ASSERT_LE(error, 4) << bits<S>(v);
        worst = std::max(worst, error);
    }
    EXPECT_GT(worst, 0.4);
    EXPECT_EQ(S(0), math::norm<S>({S(0), S(0)}));
    EXPECT_EQ(S(5), math::norm<S>({S(3), S(-4)}));
}

TYPED_TEST(AnyVec, DisplacementIsWide) {
    using S = TypeParam;
    using R = ExactFor<S>;
    Random random(9);
    const R bound = 4 * exact<R>(math::wide_epsilon<S>());
    for (int i = 0; i < kCases / 4; ++i) {
        const math::Vec<S> p(any<S>(random, -4, 4), any<S>(random, -4, 4));
        const math::Vec<S> v(any<S>(random, -4, 4), any<S>(random, -4, 4));
        const S t = random.magnitude<S>(-10, 4);
        const auto to = math::displaced<S>(math::WidePoint<S>(p), v, t);
        const R travelled = exact<R>(S(v.x())) * exact<R>(t);
        const R reference = exact<R>(S(p.x())) + travelled;
        EXPECT_LE(R(abs(R(exact<R>(to.x) - reference))),
                  R(bound * (abs(reference) + abs(travelled))))
            << bits<S>(p) << bits<S>(v) << bits<S>(t);
    }
}

}  // namespace

#include "support/scalars.hpp"

#include <gtest/gtest.h>

#include "osculo/impact/cue_strike.hpp"
#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_mathavan_2010.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/cushion_stronge.hpp"
#include "osculo/impact/frictional.hpp"
#include "support/exact.hpp"
#include "support/spinning.hpp"

// Every law in every scalar type, against the same in 100 digits.
namespace osculo::impact {
namespace {

using support::Digits100;

template <class S>
class Scalars : public testing::Test {};
using Tested = testing::Types<double, long double, math::Quad, support::Digits50>;
TYPED_TEST_SUITE(Scalars, Tested, support::ScalarName);

/// A ball of halves and quarters, which every type represents.
template <class S>
SpinningBall<S> ball(support::Random random) {
    const auto next = [&] { return S(static_cast<double>(random.between(-64, 64)) / 16); };
    SpinningBall<S> b{S(0.75), S(0.5), S(0.375), {next(), S(1.25)}, {next(), next(), next()}};
    return b;
}
template <class S>
double error(const SpinningBall<S>& a, const SpinningBall<Digits100>& b) {
    double worst = 0;
    const auto regard = [&](const S& x, const Digits100& y) {
        const Digits100 difference = support::exact<Digits100>(x) - y;
        const Digits100 in_epsilons = difference / support::exact<Digits100>(math::epsilon<S>());
        worst = std::max(worst, std::abs(static_cast<double>(in_epsilons)));
    };
    for (int i = 0; i < 2; ++i) regard(a.velocity[i], b.velocity[i]);
    for (int i = 0; i < 3; ++i) regard(a.spin[i], b.spin[i]);
    return worst;
}

/// The largest error in epsilons over some impacts of speeds of about 4.
template <class S, class Resolve>
double worst_error(int cases, const Resolve& resolve) {
    double worst = 0;
    for (int seed = 0; seed < cases; ++seed) {
        auto b = ball<S>(support::Random(static_cast<std::uint64_t>(seed)));
        auto exact = ball<Digits100>(support::Random(static_cast<std::uint64_t>(seed)));
        resolve(b);
        resolve(exact);
        worst = std::max(worst, error(b, exact));
    }
    return worst;
}

template <class S>
math::Vec<S> normal() {
    return {S(-0.75), S(2)};
}

TYPED_TEST(Scalars, Cushions) {
    using S = TypeParam;
    const auto simple = []<class T>(SpinningBall<T>& b) {
        CushionSimple<T>{T(0.875), T(0.1875)}.resolve(normal<T>(), b);
    };
    const auto han = []<class T>(SpinningBall<T>& b) {
        CushionHan2005<T>{T(0.875), T(0.1875), T(0.625)}.resolve(normal<T>(), b);
    };
    const auto stronge = []<class T>(SpinningBall<T>& b) {
        CushionStronge<T>{T(0.875), T(0.1875), T(0.625), T(1.75)}.resolve(normal<T>(), b);
    };
    EXPECT_LE(worst_error<S>(200, simple), 64);
    EXPECT_LE(worst_error<S>(200, han), 64);
    EXPECT_LE(worst_error<S>(60, stronge), 200);
}

// Its error grows where a slip passes zero closely.
TYPED_TEST(Scalars, Mathavan) {
    using S = TypeParam;
    const auto law = []<class T>(SpinningBall<T>& b) {
        CushionMathavan2010<T>{T(0.875), T(0.1875), T(0.625), T(0.25)}.resolve(normal<T>(), b);
    };
    EXPECT_LE(worst_error<S>(3, law), 3000);
}

TYPED_TEST(Scalars, BallBall) {
    using S = TypeParam;
    for (const bool constant : {true, false}) {
        const auto law = [&]<class T>(SpinningBall<T>& b) {
            SpinningBall<T> other{T(1.5), T(0.25), T(0.5), {T(1), T(-2)}, {T(3), T(-2), T(1)}};
            Frictional<T>{T(0.875), {T(0.0625), T(constant ? 0 : 0.125), T(1.25)}}.resolve(
                normal<T>(), b, other);
        };
        EXPECT_LE(worst_error<S>(200, law), 64);
    }
}

TYPED_TEST(Scalars, CueStrike) {
    using S = TypeParam;
    const auto law = []<class T>(SpinningBall<T>& b) {
        const CueStrike<T> strike{T(2.5),  T(1.25),  T(0.5), T(0.25), T(-0.375),
                                  T(0.54), T(0.007), T(1),   T(0.55)};
        ASSERT_EQ(strike.fault(), StrikeFault::none);
        strike.resolve(b);
    };
    EXPECT_LE(worst_error<S>(1, law), 64);
}

}  // namespace
}  // namespace osculo::impact

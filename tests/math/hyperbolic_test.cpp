#include "osculo/math/hyperbolic.hpp"

#include <gtest/gtest.h>

#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class Hyperbolic : public testing::Test {};
TYPED_TEST_SUITE(Hyperbolic, AllScalars, ScalarName);

using Wider = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<130>>;

template <class S>
Wider error(const S& is, const Wider& should) {
    return abs(Wider((exact<Wider>(is) - should) / should)) / exact<Wider>(math::epsilon<S>());
}

TYPED_TEST(Hyperbolic, FunctionsAreWithinTheirBounds) {
    using S = TypeParam;
    Random random(31);
    for (int i = 0; i < (math::Builtin<S> ? 2000 : 100); ++i) {
        const S x = random.magnitude<S>(-30, 5) * (random.coin() ? S(1) : S(-1));
        const auto h = math::sinh_cosh<S>(x);
        const Wider size = abs(exact<Wider>(x));
        const Wider bound = math::Builtin<S> ? Wider(3) : Wider(3 + size);
        EXPECT_LE(error<S>(h.sinh, Wider(sinh(exact<Wider>(x)))), bound);
        EXPECT_LE(error<S>(h.cosh, Wider(cosh(exact<Wider>(x)))), bound);
        EXPECT_LE(error<S>(math::inverse_sinh<S>(x), Wider(asinh(exact<Wider>(x)))), 20);
        const S large = random.magnitude<S>(0, 60);
        EXPECT_LE(error<S>(math::inverse_sinh<S>(large), Wider(asinh(exact<Wider>(large)))), 20);
    }
    EXPECT_TRUE(math::sinh_cosh<S>(S(0)).sinh == S(0));
    EXPECT_TRUE(math::sinh_cosh<S>(S(0)).cosh == S(1));
    EXPECT_TRUE(math::inverse_sinh<S>(S(0)) == S(0));
}

}  // namespace

#include "osculo/motion/slowing.hpp"

#include <gtest/gtest.h>

#include "osculo/math/error_bounds.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"
#include "support/slowing_oracle.hpp"

namespace osculo::motion {
namespace {

using support::Exact;

constexpr double kEps = 0x1p-52;

/// A time until which the oracle does not take long.
double latest(const Slowing<double>& law) {
    return std::min(law.rest_time(), 4 / (law.m + law.k + law.c + 1e-9));
}

TEST(Slowing, IsWhatItsDifferentialEquationSays) {
    support::Random random(20263);
    double worst_sigma = 0;
    double worst_q = 0;
    for (int round = 0; round < 600; ++round) {
        const auto law = support::random_slowing(random);
        double t = latest(law) * random.unit<double>();
        if (random.below(3) == 0) t *= std::pow(10.0, -8 * random.unit<double>());
        if (!(t > 0)) continue;
        const auto exact = support::slow_down(law, Exact(t));
        const Slowed<double> now = law.after(t);
        const double sigma =
            std::abs(static_cast<double>(Exact((Exact(now.sigma) - exact.sigma) / exact.sigma)));
        const double q = std::abs(static_cast<double>(Exact(Exact(now.q) - exact.q)));
        ASSERT_LE(sigma, math::kPathNoise * kEps)
            << law.m << " " << law.k << " " << law.c << " at " << t;
        ASSERT_LE(q, math::kPathNoise * kEps)
            << law.m << " " << law.k << " " << law.c << " at " << t;
        worst_sigma = std::max(worst_sigma, sigma);
        worst_q = std::max(worst_q, q);
    }
    RecordProperty("sigma_in_tenths_of_epsilon", static_cast<int>(10 * worst_sigma / kEps));
    RecordProperty("q_in_tenths_of_epsilon", static_cast<int>(10 * worst_q / kEps));
    EXPECT_GT(worst_sigma, math::kPathNoise * kEps / 10);  // a tenth of the bound would not do
    EXPECT_GT(worst_q, math::kPathNoise * kEps / 10);
}

TEST(Slowing, AgreesWithManyMoreDigits) {
    // What the oracle is too slow for: long times and many cases, by the same forms in 100 digits.
    support::Random random(20264);
    for (int round = 0; round < 20000; ++round) {
        const auto law = support::random_slowing(random);
        const Slowing<Exact> exact{Exact(law.m), Exact(law.k), Exact(law.c)};
        const double rest = law.rest_time();
        const double latest_time =
            std::isfinite(rest) ? rest : 100 / (law.m + law.k + law.c + 1e-9);
        const double t = latest_time * random.unit<double>();
        const Slowed<double> now = law.after(t);
        const Slowed<Exact> expected = exact.after(Exact(t));
        ASSERT_LE(std::abs(static_cast<double>(Exact(Exact(now.sigma) - expected.sigma))),
                  math::kPathNoise * kEps * now.sigma)
            << law.m << " " << law.k << " " << law.c << " at " << t;
        ASSERT_LE(std::abs(static_cast<double>(Exact(Exact(now.q) - expected.q))),
                  math::kPathNoise * kEps);
        if (std::isfinite(rest)) {
            const Exact exact_rest = exact.rest_time();
            ASSERT_LE(std::abs(static_cast<double>(Exact((Exact(rest) - exact_rest) / exact_rest))),
                      math::kPathNoise * kEps);
        }
        // And back, as far as the ball is still moving.
        if (!(now.sigma > 0) || !(now.q > 1e-6)) continue;
        const double back = law.time_of(now.sigma, rest);
        ASSERT_LE(std::abs(back - t) * now.q, 2 * math::kPathNoise * kEps * t)
            << law.m << " " << law.k << " " << law.c << " at " << t;
    }
}

TEST(Slowing, RestsWhenItsDifferentialEquationSays) {
    support::Random random(20265);
    int rests = 0;
    for (int round = 0; round < 400; ++round) {
        auto law = support::random_slowing(random);
        if (!(law.m > 1e-3 * (law.k + law.c))) continue;
        ++rests;
        // A speed that falls at the rate m has that much error left for an error of the time.
        const auto end = support::slow_down(law, Exact(law.rest_time()));
        ASSERT_LE(std::abs(static_cast<double>(end.q)),
                  math::kPathNoise * kEps * law.m * law.rest_time())
            << law.m << " " << law.k << " " << law.c;
    }
    EXPECT_GT(rests, 50);
}

/// The textbook's forms, of which each serves its own case only.
TEST(Slowing, HasTheTextbooksFormsAsItsCases) {
    const double t = 0.75;
    const double m = 0.375;
    const double k = 0.5;
    const double c = 0.875;
    const auto near = [&](const Slowing<double>& law, double sigma, double q) {
        EXPECT_NEAR(law.after(t).sigma, sigma, 1e-15);
        EXPECT_NEAR(law.after(t).q, q, 1e-15);
    };
    near({0, 0, 0}, t, 1);
    near({m, 0, 0}, t - m * t * t / 2, 1 - m * t);
    near({0, k, 0}, (1 - std::exp(-k * t)) / k, std::exp(-k * t));
    near({0, 0, c}, std::log(1 + c * t) / c, 1 / (1 + c * t));
    near({m, k, 0}, (1 + m / k) * (1 - std::exp(-k * t)) / k - m * t / k,
         (1 + m / k) * std::exp(-k * t) - m / k);
    near({0, k, c}, std::log(1 + c / k * (1 - std::exp(-k * t))) / c,
         k / ((k + c) * std::exp(k * t) - c));
    const double w = std::sqrt(m * c);
    near({m, 0, c}, std::log(std::cos(w * t) + std::sqrt(c / m) * std::sin(w * t)) / c,
         std::sqrt(m / c) * std::tan(std::atan(std::sqrt(c / m)) - w * t));
    EXPECT_NEAR((Slowing<double>{m, 0, 0}.rest_time()), 1 / m, 1e-15);
    EXPECT_NEAR((Slowing<double>{m, k, 0}.rest_time()), std::log(1 + k / m) / k, 1e-15);
    EXPECT_NEAR((Slowing<double>{m, 0, c}.rest_time()), std::atan(std::sqrt(c / m)) / w, 1e-15);
    EXPECT_EQ((Slowing<double>{0, k, c}.rest_time()), math::never<double>());
}

template <class S>
class SlowingOf : public testing::Test {};
TYPED_TEST_SUITE(SlowingOf, support::AllScalars);

TYPED_TEST(SlowingOf, EveryScalarTypeHasItsDigits) {
    using S = TypeParam;
    using Wider = support::Exacter;
    support::Random random(20266);
    for (int round = 0; round < 300; ++round) {
        const auto law = support::random_slowing(random);
        const Slowing<S> here{S(law.m), S(law.k), S(law.c)};
        const Slowing<Wider> wider{support::exact<Wider>(here.m), support::exact<Wider>(here.k),
                                   support::exact<Wider>(here.c)};
        const S t = S(latest(law) * random.unit<double>());
        const Wider sigma = wider.after(support::exact<Wider>(t)).sigma;
        const Wider error = support::exact<Wider>(here.after(t).sigma) - sigma;
        // The wider types have no exact products for where roots all but coincide.
        const int bound = math::Builtin<S> ? math::kPathNoise : 4 * math::kPathNoise;
        ASSERT_LE(abs(error), bound * support::exact<Wider>(math::epsilon<S>()) * sigma)
            << law.m << " " << law.k << " " << law.c;
    }
}

}  // namespace
}  // namespace osculo::motion

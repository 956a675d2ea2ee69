#include "osculo/noise.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <set>

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include "normal_quantile.hpp"

namespace osculo {
namespace {

using Philox = r123::Philox4x64;
using Words = std::array<std::uint64_t, 4>;

Words philox(const Words& counter, std::uint64_t seed, std::uint64_t key) {
    const auto words = Philox()(Philox::ctr_type{{counter[0], counter[1], counter[2], counter[3]}},
                                Philox::key_type{{seed, key}});
    return {words[0], words[1], words[2], words[3]};
}

// The answers that come with Random123 for philox4x64 with 10 rounds.
TEST(Noise, TakesTheGeneratorOfTheKnownAnswers) {
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    EXPECT_EQ(philox({0, 0, 0, 0}, 0, 0), (Words{0x16554d9eca36314c, 0xdb20fe9d672d0fdc,
                                                 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
    EXPECT_EQ(
        philox({kAll, kAll, kAll, kAll}, kAll, kAll),
        (Words{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
    EXPECT_EQ(
        philox({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
               0x452821e638d01377, 0xbe5466cf34e90c6c),
        (Words{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

/// P(X < x) of the standard normal distribution, with a small relative error for x < 0 too.
long double below(long double x) {
    return 0.5L * std::erfc(-x / std::numbers::sqrt2_v<long double>);
}

TEST(NormalQuantile, IsTheInverseOfTheDistribution) {
    const auto check = [](double q) {
        // By one step of Newton's method from there, on the side without cancellation.
        const long double x = facade::normal_quantile(-std::abs(q));
        const long double p = 0.5L - std::abs(static_cast<long double>(q));
        const long double density =
            std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi_v<long double>);
        const long double error = std::abs((below(x) - p) / density / x);
        EXPECT_LE(error, 8e-16L) << q;
        EXPECT_EQ(facade::normal_quantile(q), -facade::normal_quantile(-q));
        return error;
    };
    long double worst = 0;
    for (int i = 1; i < 4096; ++i) worst = std::max(worst, check(i / 8192.0));
    for (int i = 2; i <= 54; ++i) worst = std::max(worst, check(0.5 - std::ldexp(1.0, -i)));
    for (const double q : {0.425, std::nextafter(0.425, 1.0), 0.5 - std::exp(-25.0)}) {
        worst = std::max(worst, check(q));
    }
    EXPECT_GT(worst, 1e-17L);  // the check is not blind
    EXPECT_EQ(facade::normal_quantile(0), 0);
    EXPECT_NEAR(facade::normal_quantile(0.475), 1.959963984540054, 1e-15);
}

TEST(Noise, IsMadeOfTheWordsOfItsCounter) {
    const std::uint64_t seed = 0x123456789abcdef0;
    const std::uint64_t shot = 77;
    const std::uint64_t number = ~std::uint64_t{0};
    const auto normals = standard_normals({seed, shot, number});
    const Words first = philox({number, shot, 0, 0}, seed, 0);
    const Words second = philox({number, shot, 1, 0}, seed, 0);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const std::uint64_t word = i < 4 ? first[i] : second[0];
        const long double p = (static_cast<long double>(word >> 11U) + 0.5L) * 0x1p-53L;
        EXPECT_NEAR(static_cast<double>(below(normals[i])), static_cast<double>(p), 1e-15) << i;
    }
}

// Whatever compiler, optimisation and library.
TEST(Noise, HasTheSameBitsEverywhere) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (std::uint64_t number = 0; number < 10000; ++number) {
        for (const double x : standard_normals({1, 2, number})) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211U;
        }
    }
    EXPECT_EQ(hash, 7972997445678407421U);
    EXPECT_EQ(
        standard_normals({}),
        (std::array<double, 5>{-0x1.5ba2e15bc786bp+0, 0x1.0ff93c9f86041p+0, 0x1.02284ecd25887p+0,
                               -0x1.fe7aa84f3ae11p-7, -0x1.473cb4ee6162ap+0}));
}

struct Moments {
    double mean = 0, variance = 0, skewness = 0, kurtosis = 0;
};
template <class Number>
Moments moments(int count, Number number) {
    Moments m;
    for (int i = 0; i < count; ++i) {
        const double x = number(i);
        m.mean += x / count;
        m.variance += x * x / count;
        m.skewness += x * x * x / count;
        m.kurtosis += x * x * x * x / count;
    }
    return m;
}

TEST(Noise, IsNormalForEveryParameter) {
    constexpr int kCount = 200000;
    // Standard errors of the four are sqrt(1, 2, 15, 96 / n); 5 of them.
    const double unit = 5 / std::sqrt(double(kCount));
    for (std::size_t k = 0; k < 5; ++k) {
        const Moments m = moments(kCount, [&](int i) {
            return standard_normals({7, 3, static_cast<std::uint64_t>(i)})[k];
        });
        EXPECT_NEAR(m.mean, 0, unit) << k;
        EXPECT_NEAR(m.variance, 1, unit * std::sqrt(2.0)) << k;
        EXPECT_NEAR(m.skewness, 0, unit * std::sqrt(15.0)) << k;
        EXPECT_NEAR(m.kurtosis, 3, unit * std::sqrt(96.0)) << k;
    }
}

TEST(Noise, OfDifferentParametersDrawsShotsAndSeedsIsIndependent) {
    constexpr int kCount = 100000;
    const double allowed = 5 / std::sqrt(double(kCount));
    const auto product_mean = [&](auto one, auto other) {
        return moments(kCount,
                       [&](int i) {
                           const auto n = static_cast<std::uint64_t>(i);
                           return one(n) * other(n);
                       })
            .mean;
    };
    const auto of = [](std::uint64_t seed, std::uint64_t shot, std::uint64_t shift, std::size_t k) {
        return [=](std::uint64_t n) { return standard_normals({seed, shot, n + shift})[k]; };
    };
    for (std::size_t k = 0; k < 5; ++k) {
        for (std::size_t other = 0; other < k; ++other) {
            EXPECT_NEAR(product_mean(of(1, 1, 0, k), of(1, 1, 0, other)), 0, allowed);
        }
        EXPECT_NEAR(product_mean(of(1, 1, 0, k), of(1, 1, 1, k)), 0, allowed);
        EXPECT_NEAR(product_mean(of(1, 1, 0, k), of(1, 2, 0, k)), 0, allowed);
        EXPECT_NEAR(product_mean(of(1, 1, 0, k), of(2, 1, 0, k)), 0, allowed);
    }
    // Seed, shot and number do not stand for each other.
    std::set<double> all;
    for (std::uint64_t a = 0; a < 3; ++a) {
        for (std::uint64_t b = 0; b < 3; ++b) {
            for (std::uint64_t c = 0; c < 3; ++c) {
                for (const double x : standard_normals({a, b, c})) all.insert(x);
            }
        }
    }
    EXPECT_EQ(all.size(), 5U * 27U);
}

TEST(Noise, IsAddedToEveryParameter) {
    const Strike strike{.speed = 2, .azimuth = 1, .elevation = 0.5, .side = 0.1, .height = -0.2};
    const Draw draw{5, 6, 7};
    const auto [side, height, speed, azimuth, elevation] = standard_normals(draw);
    const CueNoise noise = computational_pool_noise();
    const Strike result = perturbed(strike, noise, 0.028575, draw);
    constexpr double kDegree = 0.017453292519943295;
    EXPECT_NEAR((result.side - strike.side) * 0.028575, 0.0005 * side, 1e-17);
    EXPECT_NEAR((result.height - strike.height) * 0.028575, 0.0005 * height, 1e-17);
    EXPECT_NEAR(result.speed - strike.speed, 0.075 * speed, 1e-15);
    EXPECT_NEAR(result.azimuth - strike.azimuth, 0.125 * kDegree * azimuth, 1e-15);
    EXPECT_NEAR(result.elevation - strike.elevation, 0.1 * kDegree * elevation, 1e-15);
    const CueNoise half = computational_pool_noise(0.5);
    EXPECT_EQ(half.speed, 0.0375);

    const Strike same = perturbed(strike, CueNoise{}, 0.028575, draw);
    EXPECT_EQ(same.speed, strike.speed);
    EXPECT_EQ(same.elevation, strike.elevation);
    EXPECT_EQ(same.side, strike.side);
}

TEST(Noise, LowersNoCueBelowLevelAndLeavesTheLeastElevation) {
    Strike level{.elevation = 0};
    int raised = 0;
    for (std::uint64_t number = 0; number < 1000; ++number) {
        const Strike result = perturbed(level, computational_pool_noise(), 0.03, {0, 0, number});
        EXPECT_GE(result.elevation, 0);
        raised += result.elevation > 0;
    }
    EXPECT_NEAR(raised, 500, 80);
    EXPECT_TRUE(std::isnan(perturbed({}, computational_pool_noise(), 0.03, {}).elevation));
}

}  // namespace
}  // namespace osculo

#include <benchmark/benchmark.h>

#include "osculo/impact/cue_strike.hpp"
#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_mathavan_2010.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/cushion_stronge.hpp"
#include "osculo/impact/frictional.hpp"
#include "support/random.hpp"

/// Time per impact, double, pool balls: rolling, stunned and spinning ones at 0.1 to 5 m/s.
namespace {

using namespace osculo;
using Ball = impact::SpinningBall<double>;
using Vec = math::Vec<double>;

constexpr std::size_t kCases = 512;
constexpr double kRadius = 0.028575;

struct Case {
    Ball one;
    Ball other;
    Vec normal;  ///< from the one to the other, which approach
};

Ball random_ball(support::Random& random) {
    Ball ball{0.170097, kRadius, 0.4, random.uniform(0.1, 5.0) * random.direction<double>(), {}};
    const double rolling = random.coin() ? 1 : random.uniform(-1.0, 1.0);
    ball.spin = {-rolling * ball.velocity.y() / kRadius, rolling * ball.velocity.x() / kRadius,
                 random.uniform(-50.0, 50.0)};
    return ball;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        support::Random random(5);
        std::vector<Case> list;
        while (list.size() < kCases) {
            Case c{random_ball(random), random_ball(random), random.direction<double>()};
            if (random.coin()) c.other.velocity = {0, 0};
            const bool meet = math::dot<double>(c.one.velocity - c.other.velocity, c.normal) > 0;
            if (meet && math::dot<double>(c.one.velocity, c.normal) > 0) list.push_back(c);
        }
        return list;
    }();
    return all;
}

template <class Resolve>
void add(const char* name, Resolve resolve) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
        std::size_t i = 0;
        for (auto _ : state) {
            Case c = cases()[i];
            resolve(c);
            benchmark::DoNotOptimize(c);
            i = (i + 1) % kCases;
        }
    });
}

template <class Law>
void add_cushion(const char* name, Law law) {
    add(name, [law](Case& c) { law.resolve(c.normal, c.one); });
}

const int kRegistered = [] {
    constexpr double kNose = 0.64 * 2 * kRadius;
    add("impact/none", [](Case&) {});
    add("impact/ball-ball restitution", [](Case& c) {
        impact::Restitution::resolve<double>(0.95, c.one.mass, c.other.mass, c.normal,
                                             c.one.velocity, c.other.velocity);
    });
    const impact::Frictional<double> frictional{0.95, {0.009951, 0.108, 1.088}};
    add("impact/ball-ball frictional",
        [frictional](Case& c) { frictional.resolve(c.normal, c.one, c.other); });
    add("impact/cushion restitution",
        [](Case& c) { impact::Restitution::resolve<double>(0.85, c.normal, c.one.velocity); });
    add_cushion("impact/cushion simple", impact::CushionSimple<double>{0.85, 0.2});
    add_cushion("impact/cushion han_2005", impact::CushionHan2005<double>{0.85, 0.2, kNose});
    add_cushion("impact/cushion stronge", impact::CushionStronge<double>{0.85, 0.2, kNose});
    add_cushion("impact/cushion mathavan_2010",
                impact::CushionMathavan2010<double>{0.85, 0.2, kNose, 0.2});
    const impact::CueStrike<double> cue{6, 1.2, 0.1, 0.1, 0.2, 0.54, 0.006, 1, 0.55};
    add("impact/cue strike", [cue](Case& c) { cue.resolve(c.one); });
    return 0;
}();

}  // namespace

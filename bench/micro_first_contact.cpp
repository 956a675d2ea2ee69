#include <benchmark/benchmark.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "workloads.hpp"

/// Time per prediction of one pair. The sets of data are large enough that branches are not learnt
/// by heart and small enough for the first-level cache.
namespace {

using namespace osculo;
using namespace osculo::bench;
using Digits50 = boost::multiprecision::cpp_bin_float_50;

template <class S, class Predict>
void run(benchmark::State& state, const std::vector<Prediction<S>>& all, Predict predict) {
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(predict(all[i]));
        i = (i + 1) % kPredictions;
    }
}

/// The ball's path as seen from the other one.
template <class S>
motion::LinearPath<S> relative(const Prediction<S>& p) {
    return {p.ball.position, p.ball.velocity - p.other.velocity};
}

template <class S, Outcome kOutcome>
void ball_ball(benchmark::State& state) {
    run<S>(state, predictions<S>(kOutcome, 2 * kRadius), [](const Prediction<S>& p) {
        return detect::first_contact<S>(p.ball, p.other, S(2 * kRadius), {}, p.horizon);
    });
}

template <class S, Outcome kOutcome>
void ball_point(benchmark::State& state) {
    run<S>(state, predictions<S>(kOutcome, kRadius), [](const Prediction<S>& p) {
        const geometry::Point<S> point{p.other.position.rounded()};
        return detect::first_contact<S>(relative(p), S(kRadius), point, {}, p.horizon);
    });
}

/// Segments through the aim of the ball, along its drift; two-sided.
template <class S, Outcome kOutcome>
void ball_segment(benchmark::State& state) {
    const auto all = predictions<S>(kOutcome, kRadius);
    std::vector<geometry::Segment<S>> segments;
    for (const auto& p : all) {
        const math::Vec<S> at = p.other.position.rounded();
        const math::Vec<S> along = p.other.velocity * S(4);
        // A near miss passes beside the end.
        const math::Vec<S> from =
            kOutcome == Outcome::near_miss ? math::Vec<S>(at + along) : math::Vec<S>(at - along);
        segments.emplace_back(from, math::Vec<S>(from + S(2) * along), false);
    }
    run<S>(state, all, [&](const Prediction<S>& p) {
        const std::size_t k = static_cast<std::size_t>(&p - all.data());
        return detect::first_contact<S>(relative(p), S(kRadius), segments[k], {}, p.horizon);
    });
}

/// Half circles of twice the ball's radius.
template <class S, Outcome kOutcome>
void ball_arc(benchmark::State& state) {
    const auto all = predictions<S>(kOutcome, 3 * kRadius);
    std::vector<geometry::Arc<S>> arcs;
    for (const auto& p : all) {
        const math::Vec<S> side = p.other.velocity / math::norm<S>(p.other.velocity);
        arcs.push_back({p.other.position.rounded(), S(2 * kRadius), side, -side, false, false});
    }
    run<S>(state, all, [&](const Prediction<S>& p) {
        const std::size_t k = static_cast<std::size_t>(&p - all.data());
        return detect::first_contact<S>(relative(p), S(kRadius), arcs[k], {}, p.horizon);
    });
}

#define OSCULO_OUTCOMES(function, S)                     \
    BENCHMARK_TEMPLATE(function, S, Outcome::hit);       \
    BENCHMARK_TEMPLATE(function, S, Outcome::near_miss); \
    BENCHMARK_TEMPLATE(function, S, Outcome::beside);    \
    BENCHMARK_TEMPLATE(function, S, Outcome::later);     \
    BENCHMARK_TEMPLATE(function, S, Outcome::leaving)

#define OSCULO_SCALARS(function)            \
    OSCULO_OUTCOMES(function, double);      \
    OSCULO_OUTCOMES(function, long double); \
    OSCULO_OUTCOMES(function, math::Quad);  \
    OSCULO_OUTCOMES(function, Digits50)

OSCULO_SCALARS(ball_ball);
OSCULO_SCALARS(ball_point);
OSCULO_SCALARS(ball_segment);
OSCULO_SCALARS(ball_arc);

}  // namespace

#include <ctime>

#include <benchmark/benchmark.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "workloads.hpp"

/// Events per second of whole engines, without what it takes to build the scene and to make the
/// first predictions.
namespace {

using namespace osculo;
using namespace osculo::bench;
using Digits50 = boost::multiprecision::cpp_bin_float_50;

template <class Type>
void play(benchmark::State& state, const engine::SceneData<Type>& scene, std::uint64_t events) {
    using S = typename Type::Scalar;
    std::uint64_t played = 0;
    std::uint64_t predicted = 0;
    for (auto _ : state) {
        engine::Engine<Type> engine(scene);
        const std::uint64_t before = engine.prediction_count();
        const std::clock_t start = std::clock();
        engine.run({math::never<S>(), events});
        // Processor time: other programs on the machine do not count.
        state.SetIterationTime(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        played += engine.event_count();
        predicted += engine.prediction_count() - before;
    }
    const auto count = static_cast<double>(played);
    state.counters["events/s"] = benchmark::Counter(count, benchmark::Counter::kIsRate);
    state.counters["time/event"] =
        benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["predictions/event"] = static_cast<double>(predicted) / count;
}

/// Disks that cover three tenths of a box.
template <class S, template <class> class BroadPhase>
void gas(benchmark::State& state) {
    const int disks = static_cast<int>(state.range(0));
    play<Gas<S, BroadPhase>>(state, support::gas<Gas<S, BroadPhase>>(disks, 0.3, 1).scene,
                             static_cast<std::uint64_t>(state.range(1)));
}

template <class S>
void pi(benchmark::State& state) {
    play<PiScene<S>>(state, pi_scene<S>(static_cast<int>(state.range(0))), 10'000'000);
}

BENCHMARK_TEMPLATE(gas, double, engine::AllPairs)
    ->Args({16, 100000})
    ->Args({100, 20000})
    ->Args({1000, 5000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(gas, double, engine::CellGrid)
    ->Args({16, 100000})
    ->Args({100, 100000})
    ->Args({1000, 100000})
    ->Args({10000, 100000})
    ->Args({100000, 200000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(gas, long double, engine::AllPairs)
    ->Args({16, 20000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(gas, math::Quad, engine::AllPairs)
    ->Args({16, 2000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(gas, Digits50, engine::AllPairs)
    ->Args({16, 500})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(pi, double)->Arg(6)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

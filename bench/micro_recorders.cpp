#include <benchmark/benchmark.h>

#include "compile_scene.hpp"
#include "osculo/presets.hpp"
#include "workloads.hpp"

/// Time per event of the ready-made engines and of what they record, double: the break of fifteen
/// balls on a 7 ft table, until 2 s, and sixteen disks in a box on engines that know more and more.
namespace {

using namespace osculo;
using namespace osculo::engine;

Scene rack() {
    Scene scene;
    presets::add_table(scene, "pool-7ft");
    scene.balls.push_back({"cue", 0.170097, 0.028575, {0.4973, 0.4953}, {0, 9}, {}});
    presets::add_rack(scene, "eight-ball");
    return scene;
}

template <class Type>
SceneData<Type> start() {
    Scene scene = rack();
    if constexpr (Type::Motion::kSpin) {
        presets::set_table_laws(scene, "pool-7ft");
    } else if constexpr (Type::Motion::kTransitions) {
        scene.motion = RollingMotion{};
    }
    return facade::compile_scene<Type>(scene).data;
}

template <class Type>
void play(benchmark::State& state, const SceneData<Type>& scene, double until) {
    Engine<Type> engine(scene);
    std::uint64_t events = 0;
    for (auto _ : state) {
        engine.restart(scene.bodies);
        engine.run({until, 10'000'000});
        events += engine.event_count();
    }
    const auto count = static_cast<double>(events);
    state.counters["events/s"] = benchmark::Counter(count, benchmark::Counter::kIsRate);
    state.counters["predictions/event"] =
        static_cast<double>(engine.prediction_count()) / static_cast<double>(engine.event_count());
}

template <class Type>
void add_rack(const char* name) {
    benchmark::RegisterBenchmark((std::string("break/") + name).c_str(),
                                 [](auto& state) { play<Type>(state, start<Type>(), 2); });
}

template <class Type>
void add_disks(const char* name) {
    benchmark::RegisterBenchmark((std::string("disks/") + name).c_str(), [](auto& state) {
        play<Type>(state, support::gas<Type>(16, 0.3, 1).scene, 50);
    });
}

template <template <class> class Recorder>
using OnTable = UniformScene<double, Table, Recorder, AllPairs>;
template <template <class> class Recorder>
using InWalls = UniformScene<double, Walls, Recorder, AllPairs>;
template <template <class> class Recorder>
using HanCloth = ClothScene<double, impact::CushionHan2005, Recorder>;

const int kRegistered = [] {
    add_rack<OnTable<NoRecorder>>("uniform, nothing");
    add_rack<OnTable<EventRecorder>>("uniform, events");
    add_rack<OnTable<PieceRecorder>>("uniform, pieces");
    add_rack<RollingScene<double, NoRecorder>>("rolling, nothing");
    add_rack<RollingScene<double, RollingEvents>>("rolling, events");
    add_rack<RollingScene<double, RollingPieces>>("rolling, pieces");
    add_rack<HanCloth<NoRecorder>>("cloth han_2005, nothing");
    add_rack<HanCloth<ClothEvents>>("cloth han_2005, events");
    add_rack<HanCloth<ClothPieces>>("cloth han_2005, pieces");
    add_disks<InWalls<NoRecorder>>("walls, nothing");
    add_disks<InWalls<EventRecorder>>("walls, events");
    add_disks<InWalls<PieceRecorder>>("walls, pieces");
    add_disks<OnTable<NoRecorder>>("table, nothing");
    add_disks<UniformScene<double, Walls, NoRecorder, CellGrid>>("walls, cell grid, nothing");
    return 0;
}();

}  // namespace

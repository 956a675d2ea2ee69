// Energy and overlaps over long runs: 16 disks for 10,000 events; 1,000 disks for 1e6 events, with
// nothing recorded and with everything recorded and audited (some 0.5 GB).
//
//     bench_long_runs [events of the 1,000 disks] [events of them to audit]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "osculo/engine/audit.hpp"
#include "workloads.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench;

template <class Type>
void play(const char* name, int disks, std::uint64_t events) {
    using S = typename Type::Scalar;
    const auto scene = support::gas<Type>(disks, 0.3, 1).scene;
    const auto energy = [](const auto& bodies) {
        long double sum = 0;
        for (const auto& body : bodies) {
            sum += static_cast<long double>(body.mass) *
                   static_cast<long double>(math::dot<S>(body.state.velocity, body.state.velocity));
        }
        return sum;
    };
    engine::Engine<Type> engine(scene);
    const auto start = std::chrono::steady_clock::now();
    const Status status = engine.run({math::never<S>(), events});
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double drift = static_cast<double>(energy(engine.bodies()) / energy(scene.bodies) - 1);
    std::printf("%-34s %8llu events %-11.*s t = %8.3f s  energy %+.2e  %6.2f s", name,
                static_cast<unsigned long long>(engine.event_count()),
                static_cast<int>(to_string(status).size()), to_string(status).data(),
                math::to_double<S>(math::narrow(engine.time())), drift, seconds);
    if constexpr (Type::Recorder::kPieces) {
        const engine::RunAudit audit =
            engine::audit<Type>(scene, engine.recorder(), engine.bodies(), engine.time());
        std::printf("  audit %s: worst gap / radius %.2e, contact error %.2e, energy gain %.2e",
                    audit.clean ? "clean" : "NOT CLEAN", audit.worst_gap,
                    audit.largest_contact_error, audit.largest_energy_gain);
    }
    std::printf("\n");
    std::fflush(stdout);
}

template <template <class> class Recorder, template <class> class BroadPhase>
using Scene = engine::UniformScene<double, engine::Walls, Recorder, BroadPhase>;

}  // namespace

int main(int argc, char** argv) {
    const auto events = static_cast<std::uint64_t>(argc > 1 ? std::atoll(argv[1]) : 1'000'000);
    const auto audited = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1'000'000);
    play<Scene<engine::PieceRecorder, engine::AllPairs>>("16 disks, all pairs", 16, 10'000);
    play<Scene<engine::NoRecorder, engine::CellGrid>>("1,000 disks, cell grid", 1000, events);
    play<Scene<engine::PieceRecorder, engine::CellGrid>>("1,000 disks, cell grid, audited", 1000,
                                                         audited);
    return 0;
}

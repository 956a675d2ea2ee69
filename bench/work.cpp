// A fixed amount of work of one kind, for tools that count instructions:
//
//     bench_work hit|near-miss|beside|later|leaving COUNT      predictions of ball-ball contacts
//     bench_work gas-all-pairs|gas-cell-grid EVENTS [DISKS]    events of a gas

#include <cstdio>
#include <cstdlib>
#include <string>

#include "workloads.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench;

double predict(Outcome outcome, long count) {
    const auto all = predictions<double>(outcome, 2 * kRadius);
    double sum = 0;
    for (long i = 0; i < count; ++i) {
        const auto& p = all[static_cast<std::size_t>(i) % kPredictions];
        const double t = detect::first_contact<double>(p.ball, p.other, 2 * kRadius, {}, p.horizon);
        if (math::is_finite(t)) sum += t;
    }
    return sum;
}

template <template <class> class BroadPhase>
double play(long events, int disks) {
    using Type = Gas<double, BroadPhase>;
    engine::Engine<Type> engine(support::gas<Type>(disks, 0.3, 1).scene);
    engine.run({math::never<double>(), static_cast<std::uint64_t>(events)});
    return static_cast<double>(engine.prediction_count());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const std::string what = argv[1];
    const long count = std::atol(argv[2]);
    const int disks = argc > 3 ? std::atoi(argv[3]) : 16;
    double result = 0;
    if (what == "hit") result = predict(Outcome::hit, count);
    if (what == "near-miss") result = predict(Outcome::near_miss, count);
    if (what == "beside") result = predict(Outcome::beside, count);
    if (what == "later") result = predict(Outcome::later, count);
    if (what == "leaving") result = predict(Outcome::leaving, count);
    if (what == "gas-all-pairs") result = play<engine::AllPairs>(count, disks);
    if (what == "gas-cell-grid") result = play<engine::CellGrid>(count, disks);
    std::printf("%.17g\n", result);
    return 0;
}

// What digits cost and what they buy: 16 disks in a box, by scalar type.
//
//     bench_precision_cost [--quick]
//
// A run is right until its list of events (what met what, in order) differs from that of 100
// digits. A job asks for so many events; what comes after the first wrong one is worth nothing.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "cpu_clock.hpp"
#include "statistics.hpp"
#include "workloads.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench;
using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Digits100 = boost::multiprecision::cpp_bin_float_100;

template <class S, template <class> class Recorder>
using Disks = engine::UniformScene<S, engine::Walls, Recorder, engine::AllPairs>;

/// The gas of another scalar type starts elsewhere (all digits are random): start from doubles.
template <class Type>
engine::SceneData<Type> disks(std::uint64_t seed) {
    using S = typename Type::Scalar;
    const auto model = support::gas<Disks<double, engine::NoRecorder>>(16, 0.1, seed).scene;
    support::Builder<Type> builder;
    builder.box(S(0), S(0), S(1), S(1));
    for (const auto& body : model.bodies) {
        const math::Vec<double> p = body.state.position.rounded();
        const math::Vec<double>& v = body.state.velocity;
        // Twenty bits, so that every type starts from the same numbers, float included.
        const auto same = [](double x) { return S(std::round(x * 0x1p20) * 0x1p-20); };
        builder.ball({same(p.x()), same(p.y())}, {same(v.x()), same(v.y())}, same(body.radius));
    }
    return builder.scene;
}

struct Met {
    engine::Kind kind;
    std::uint32_t first;
    std::uint32_t second;
    friend bool operator==(const Met&, const Met&) = default;
};

template <class S>
std::vector<Met> events(std::uint64_t seed, std::uint64_t count) {
    using Type = Disks<S, engine::EventRecorder>;
    engine::Engine<Type> engine(disks<Type>(seed));
    engine.run({math::never<S>(), count});
    std::vector<Met> list;
    for (const auto& event : engine.recorder().events) {
        list.push_back({event.kind, event.first, event.second});
    }
    return list;
}

template <class S>
double seconds(std::uint64_t seed, std::uint64_t count) {
    using Type = Disks<S, engine::NoRecorder>;
    engine::Engine<Type> engine(disks<Type>(seed));
    const double start = cpu_now();
    engine.run({math::never<S>(), count});
    return cpu_now() - start;
}

constexpr std::uint64_t kJobs[] = {100, 200, 400, 800};

template <class S>
void line(const char* name, const std::vector<std::vector<Met>>& references) {
    Sample right;
    Sample rate;
    std::vector<double> correct(std::size(kJobs));
    std::vector<double> taken(std::size(kJobs));
    for (std::size_t k = 0; k < references.size(); ++k) {
        const auto& reference = references[k];
        const std::vector<Met> mine = events<S>(k + 1, reference.size());
        const auto [end, other] =
            std::mismatch(mine.begin(), mine.end(), reference.begin(), reference.end());
        const auto until = static_cast<double>(end - mine.begin());
        right.add(until);
        for (std::size_t j = 0; j < std::size(kJobs); ++j) {
            const double time = seconds<S>(k + 1, kJobs[j]);
            correct[j] += std::min(until, static_cast<double>(kJobs[j]));
            taken[j] += time;
            rate.add(static_cast<double>(kJobs[j]) / time);
        }
    }
    std::printf("%-12s %10.0f %8.0f %8.0f %8.0f ", name, rate.median(), right.quantile(0),
                right.median(), right.worst());
    for (std::size_t j = 0; j < std::size(kJobs); ++j) {
        std::printf(" %10.0f", correct[j] / taken[j]);
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    const std::uint64_t seeds = quick ? 3 : 20;
    const std::uint64_t most = 4000;
    std::vector<std::vector<Met>> references;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        references.push_back(events<Digits100>(seed, most));
    }
    std::printf("16 disks covering a tenth of a box; %llu seeds, %llu events at the most\n",
                static_cast<unsigned long long>(seeds), static_cast<unsigned long long>(most));
    std::printf("%-12s %10s %26s   %s\n", "", "events/s", "events right: least median most",
                "right events per second of a job of 100, 200, 400, 800");
    line<float>("float", references);
    line<double>("double", references);
    line<long double>("long double", references);
    line<math::Quad>("quad", references);
    line<Digits50>("50 digits", references);
    line<Digits100>("100 digits", references);
    return 0;
}

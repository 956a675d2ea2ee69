#include <benchmark/benchmark.h>

#include "workloads.hpp"

/// Time per prediction on curved paths (a ball on cloth), double. "culled" is what the engine asks
/// first, certainly_apart(), of pairs that pass far beside; "beside" is the whole prediction of
/// those.
namespace {

using namespace osculo;
using namespace osculo::bench;
using Path = motion::ParabolicPath<double>;
using Vec = math::Vec<double>;

struct Case {
    Path ball;
    Path relative;  ///< as seen from where the other ball started and how it moves
    Path other;
};

constexpr double kHalfDeceleration = 0.5 * 0.01 * 9.81;  // of a rolling ball [m/s^2]
constexpr double kRollingTime = 4;

/// The straight predictions, bent, and begun so that they come to the same place: what hits or
/// misses there mostly does so here.
std::vector<Case> cases(Outcome outcome, double reach) {
    support::Random random(11);
    std::vector<Case> all;
    for (const auto& p : predictions<double>(outcome, reach)) {
        const Vec bend = random.direction<double>() * kHalfDeceleration;
        const Vec relative = p.ball.velocity - p.other.velocity;
        const Vec way = p.other.position.rounded() - p.ball.position.rounded();
        const double time = math::norm<double>(way) / math::norm<double>(relative);
        const math::WidePoint<double> start(Vec(p.ball.position.rounded() - (time * time) * bend));
        all.push_back({{start, p.ball.velocity, bend, kRollingTime},
                       {start, relative, bend, kRollingTime},
                       {p.other.position, p.other.velocity, Vec(0, 0), kRollingTime}});
    }
    return all;
}

template <class Ask>
void run(benchmark::State& state, Outcome outcome, double reach, Ask ask) {
    const auto all = cases(outcome, reach);
    std::size_t hits = 0;
    for (std::size_t k = 0; k < kPredictions; ++k) hits += math::is_finite<double>(ask(all[k], k));
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ask(all[i], i));
        i = (i + 1) % kPredictions;
    }
    state.counters["hits"] = static_cast<double>(hits) / kPredictions;
}

/// Registers the outcomes of one obstacle. ask(case, number) predicts, cull(case, number) is true
/// of what is certainly apart.
template <class Predict, class Cull>
void all_outcomes(const std::string& what, double reach, Predict predict, Cull cull) {
    const auto add = [&](const char* name, Outcome outcome, auto ask) {
        benchmark::RegisterBenchmark(
            ("parabolic/" + what + "/" + name).c_str(),
            [=](benchmark::State& state) { run(state, outcome, reach, ask); });
    };
    add("hit", Outcome::hit, predict);
    add("near_miss", Outcome::near_miss, predict);
    add("beside", Outcome::beside, predict);
    // Of these, "hits" are those that could not be told to be apart.
    add("culled", Outcome::beside,
        [cull](const Case& c, std::size_t k) { return cull(c, k) ? math::never<double>() : 0.0; });
}

template <class Obstacle>
void with_obstacles(const std::string& what, double reach, const std::vector<Obstacle>& list) {
    all_outcomes(
        what, reach,
        [list](const Case& c, std::size_t k) {
            return detect::first_contact<double>(c.relative, kRadius, list[k], {},
                                                 math::never<double>());
        },
        [list](const Case& c, std::size_t k) {
            return detect::certainly_apart<double>(c.relative, kRadius, list[k],
                                                   math::never<double>());
        });
}

const int kRegistered = [] {
    all_outcomes(
        "ball", 2 * kRadius,
        [](const Case& c, std::size_t) {
            return detect::first_contact<double>(c.ball, c.other, 2 * kRadius, {},
                                                 math::never<double>());
        },
        [](const Case& c, std::size_t) {
            return detect::certainly_apart<double>(c.ball, 0.0, c.other, 0.0, 2 * kRadius,
                                                   math::never<double>());
        });
    std::vector<geometry::Point<double>> points;
    std::vector<geometry::Rim<double>> rims;
    std::vector<geometry::Segment<double>> segments;
    std::vector<geometry::Arc<double>> arcs;
    for (const auto& p : predictions<double>(Outcome::hit, kRadius)) {
        const Vec at = p.other.position.rounded();
        const Vec side = p.other.velocity / math::norm<double>(p.other.velocity);
        points.push_back({at});
        rims.push_back({at, 2 * kRadius});
        segments.emplace_back(at - kRadius * side, at + kRadius * side, false);
        arcs.push_back({at, 2 * kRadius, side, -side, false, false});
    }
    with_obstacles("point", kRadius, points);
    with_obstacles("rim", 2 * kRadius, rims);
    with_obstacles("segment", kRadius, segments);
    with_obstacles("arc", 3 * kRadius, arcs);
    return 0;
}();

}  // namespace

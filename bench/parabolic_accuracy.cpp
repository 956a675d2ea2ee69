// How first contacts on curved paths compare with exact ones: a table on stdout, the same as CSV in
// a file.
//
//     bench_parabolic_accuracy [cases] [csv file]
//
// Cases of two balls (or a ball and a point or rim), as many from inside a circle, a fifth each of
// segments and arcs; of long double a hundredth of each.

#include <array>
#include <cstdlib>
#include <thread>

#include "accuracy_report.hpp"
#include "osculo/detect/ball_arc_parabolic.hpp"
#include "osculo/detect/ball_segment_parabolic.hpp"
#include "support/curved_obstacle_families.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

constexpr std::size_t kThreads = 2;

/// Runs add(random, tally) for all cases, divided among the threads.
template <class Add>
[[nodiscard]] Tally divided(int cases, unsigned seed, Add add) {
    std::array<Tally, kThreads> tallies;
    std::array<std::thread, kThreads> threads;
    for (unsigned k = 0; k < kThreads; ++k) {
        threads[k] = std::thread([&, k] {
            Random random(seed * kThreads + k);
            for (int i = 0; i < cases / static_cast<int>(kThreads); ++i) add(random, tallies[k]);
        });
    }
    Tally all;
    for (unsigned k = 0; k < kThreads; ++k) {
        threads[k].join();
        all.add(tallies[k]);
    }
    return all;
}

template <class S>
void add_entry(const ParabolicCase<S>& p, Tally& tally) {
    const auto reference = exact_entry<S>(p);
    if (reference && crosses_without_speed<S>(p, *reference)) return;
    const math::ParabolicApproach<S> approach{p.c, p.b, p.a, p.s};
    tally.add<S>(math::first_entry<S>(approach, p.end), reference);
}

template <class S>
void add_exit(const ParabolicCase<S>& p, Tally& tally) {
    if (p.a.x() == S(0) && p.a.y() == S(0)) return;  // straight: not solved here
    const bool inside = math::norm<S>(p.c) <= p.s;
    const auto reference = exact_exit<S>(p, inside);
    if (reference && crosses_without_speed<S>(p, *reference)) return;
    const math::ParabolicApproach<S> approach{p.c, p.b, p.a, p.s};
    tally.add<S>(math::first_exit<S>(approach, p.end, inside), reference);
}

/// All families, and all of them together.
template <class S, class Add>
void circles(bench::Report& report, const char* what, int cases, Add add) {
    Tally all;
    unsigned seed = 100;
    const int each = cases / static_cast<int>(kParabolicFamilies<S>.size()) + 1;
    for (const auto& family : kParabolicFamilies<S>) {
        Tally tally = divided(each + each % 2, ++seed,
                              [&](Random& random, Tally& t) { add(family.make(random), t); });
        report.line(name_of<S>(), what, family.name, tally);
        all.add(tally);
    }
    report.line(name_of<S>(), what, "all", all);
}

/// Cases in which rounding decides between the boundary and its end are left out.
template <class S, class Make>
void obstacles(bench::Report& report, const char* what, Make make, int cases) {
    Tally all;
    unsigned seed = 200;
    const int each = cases / static_cast<int>(kCurvedFamilies.size());
    for (const CurvedTraits& family : kCurvedFamilies) {
        Tally tally = divided(each, ++seed, [&](Random& random, Tally& t) {
            const auto a = make(random, family);
            const auto reference = exact_contact<S>(a.path, a.radius, a.obstacle);
            if (reference.at_an_end) return;
            t.add<S>(detect::first_contact(a.path, a.radius, a.obstacle, math::ContactHistory<S>{},
                                           math::never<S>()),
                     reference.time);
        });
        report.line(name_of<S>(), what, family.name, tally);
        all.add(tally);
    }
    report.line(name_of<S>(), what, "all", all);
}

template <class S>
void everything(bench::Report& report, int cases) {
    circles<S>(report, "entry", cases, add_entry<S>);
    circles<S>(report, "exit", cases, add_exit<S>);
    obstacles<S>(report, "segment", curved_segment_case<S>, cases / 5);
    obstacles<S>(report, "arc", curved_arc_case<S>, cases / 5);
}

}  // namespace

int main(int argc, char** argv) {
    const int cases = argc > 1 ? std::atoi(argv[1]) : 2000000;
    bench::Report report(argc > 2 ? argv[2] : "parabolic_accuracy.csv");
    everything<double>(report, cases);
    everything<long double>(report, cases / 100);
    std::puts(report.met() ? "targets met: none missed, false or wrong; 99.9 % within 2 ulp"
                           : "TARGETS NOT MET");
    return report.met() ? 0 : 1;
}

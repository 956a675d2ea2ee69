// How first contacts compare with exact ones: a table on stdout, the same as CSV in a file.
//
//     bench_first_contact_accuracy [random cases] [adversarial cases] [csv file]

#include <cstdlib>

#include "accuracy_report.hpp"
#include "osculo/detect/ball_arc.hpp"
#include "osculo/detect/ball_segment.hpp"
#include "support/obstacle_families.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using osculo::bench::Report;

int share(bool adversarial, bool wanted, int cases, int families) {
    return adversarial == wanted ? (cases + families - 1) / families : 0;
}

/// Ball-ball, ball-point and ball-rim: a point and a circle.
template <class S>
void circles(Report& report, int random_cases, int adversarial_cases) {
    Tally entries;
    Tally exits;
    for (const auto& family : kContactFamilies<S>) {
        const int cases = share(family.adversarial, false, random_cases, 2) +
                          share(family.adversarial, true, adversarial_cases, 11);
        Random random(1);
        Tally entry;
        Tally exit;
        for (int i = 0; i < cases; ++i) {
            const PointCase<S> p = family.make(random);
            entry.add<S>(math::first_entry<S>(p.c, p.b, p.s), exact_entry(p));
            exit.add<S>(math::first_exit<S>(p.c, p.b, p.s), exact_exit(p));
        }
        report.line(name_of<S>(), "entry", family.name, entry);
        report.line(name_of<S>(), "exit", family.name, exit);
        entries.add(entry);
        exits.add(exit);
    }
    report.line(name_of<S>(), "entry", "all", entries);
    report.line(name_of<S>(), "exit", "all", exits);
}

/// Cases in which rounding decides between the boundary and its end are left out.
template <class S, class Make>
void obstacles(Report& report, const char* what, Make make, int random_cases,
               int adversarial_cases) {
    for (const ObstacleTraits& family : kObstacleFamilies) {
        const int cases = share(family.adversarial, false, random_cases, 1) +
                          share(family.adversarial, true, adversarial_cases, 5);
        Random random(2);
        Tally tally;
        for (int i = 0; i < cases; ++i) {
            const auto a = make(random, family);
            const auto reference = exact_contact<S>(a.path, a.radius, a.obstacle);
            if (reference.at_an_end) continue;
            tally.add<S>(detect::first_contact(a.path, a.radius, a.obstacle,
                                               math::ContactHistory<S>{}, math::never<S>()),
                         reference.time);
        }
        report.line(name_of<S>(), what, family.name, tally);
    }
}

template <class S>
void everything(Report& report, int random_cases, int adversarial_cases) {
    circles<S>(report, random_cases, adversarial_cases);
    obstacles<S>(report, "segment", segment_case<S>, random_cases / 4, adversarial_cases / 4);
    obstacles<S>(report, "arc", arc_case<S>, random_cases / 8, adversarial_cases / 8);
}

}  // namespace

int main(int argc, char** argv) {
    const int random_cases = argc > 1 ? std::atoi(argv[1]) : 1000000;
    const int adversarial_cases = argc > 2 ? std::atoi(argv[2]) : 1000000;
    Report report(argc > 3 ? argv[3] : "first_contact_accuracy.csv");
    everything<double>(report, random_cases, adversarial_cases);
    everything<long double>(report, random_cases / 10, adversarial_cases / 10);
    std::puts(report.met() ? "targets met: none missed, false or wrong; 99.9 % within 2 ulp"
                           : "TARGETS NOT MET");
    return report.met() ? 0 : 1;
}

// How many digits an event costs: disks run forwards, all velocities are turned round, and they run
// back for as long. What is left of the start after how many events? (Errors made on the way there
// shrink on the way back as they grew; those made after the turn grow over as many events.)

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "workloads.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench;

/// A line through (events, log10 error), by least squares.
struct Fit {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    void add(double px, double py) { n += 1, x += px, y += py, xx += px * px, xy += px * py; }
    [[nodiscard]] double slope() const { return (n * xy - x * y) / (n * xx - x * x); }
};

template <class S>
void measure(const char* name, int disks) {
    using Type = Gas<S, engine::AllPairs>;
    Fit fit;
    double last_events = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        auto scene = support::gas<Type>(disks, 0.3, seed).scene;
        for (double time = 0.01;; time *= 1.25) {
            engine::Engine<Type> there(scene);
            there.run({S(time), 1'000'000});
            auto turned = scene;
            for (std::size_t i = 0; i < turned.bodies.size(); ++i) {
                turned.bodies[i].state = there.bodies()[i].state;
                turned.bodies[i].state.velocity = -turned.bodies[i].state.velocity;
            }
            engine::Engine<Type> back(turned);
            back.run({S(time), 1'000'000});
            S worst(0);
            for (std::size_t i = 0; i < turned.bodies.size(); ++i) {
                const auto& a = scene.bodies[i].state;
                const auto& b = back.bodies()[i].state;
                const math::Vec<S> off = math::difference<S>(a.position, b.position);
                worst = std::max<S>(worst, math::norm<S>(off));
            }
            const auto events = static_cast<double>(there.event_count());
            const double error = math::to_double<S>(worst);
            if (error > 1e-3) break;
            if (events > 10 && error > 0) fit.add(events, std::log10(error));
            last_events = std::max(last_events, events);
        }
    }
    std::printf(
        "%-12s %3d disks: %.4f digits lost per event; after %5.0f events and as many back within "
        "1e-3 m\n",
        name, disks, fit.slope(), last_events);
    std::fflush(stdout);
}

}  // namespace

int main() {
    for (const int disks : {4, 16}) {
        measure<double>("double", disks);
        measure<long double>("long double", disks);
        measure<math::Quad>("quad", disks);
        measure<boost::multiprecision::cpp_bin_float_50>("50 digits", disks);
    }
    return 0;
}

// One run of very many events: disks in a box, elastic, from one engine that is never stopped.
//
//     bench_soak [--events N] [--disks N] [--seed N]      default: 100,000,000 events of 16 disks
//
// Nothing is kept, everything is looked at in passing: at every event the gap of what touches, the
// box, the energy and the momentum that the impact leaves; every 100,000 events all pairs of disks
// and the energy of all. Progress goes to stderr. Exit code 1 if anything is beyond its bound
// (math/error_bounds.hpp; for the energy of all, a random walk of one rounding per event, six
// standard deviations of it).

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "osculo/math/error_bounds.hpp"
#include "osculo/osculo.hpp"
#include "support/gas.hpp"

namespace {

using namespace osculo;
using Vec = math::Vec<double>;

constexpr double kEpsilon = 0x1p-52;
constexpr std::uint64_t kLookAtAllEvery = 100'000;

template <class Bodies>
double energy_of(const Bodies& bodies) {
    long double sum = 0;
    for (const auto& body : bodies) {
        const Vec& v = body.state.velocity;
        sum += static_cast<long double>(body.mass) *
               (static_cast<long double>(v.x()) * v.x() + static_cast<long double>(v.y()) * v.y());
    }
    return static_cast<double>(sum / 2);
}

/// What the run has shown so far. Gaps and overlaps in radii, all disks being of one size.
struct Worst {
    double contact_gap = 0;  ///< of two disks that meet, either way
    double overlap = 0;      ///< of any two disks, or of a disk and a wall
    double gain = 0;         ///< of energy at one impact, over that of its balls
    double momentum = 0;     ///< lost at one impact, over the sum of its balls' |m v|
    double drift = 0;        ///< of the energy of all, relative
};

/// In the place of a list of events: looks at each, and keeps none.
template <class Bodies>
class Passing {
public:
    void watch(const Bodies& bodies) {
        bodies_ = &bodies;
        energy_ = energy_of(bodies);
    }
    [[nodiscard]] const Worst& worst() const { return worst_; }

    void push_back(const engine::EventRecord<double>& event) {
        const auto& first = (*bodies_)[event.first];
        const double r = first.radius;
        for (const double x : {event.before[0].position.x.hi, event.before[0].position.y.hi}) {
            worst_.overlap = std::max(worst_.overlap, 1 - std::min(x, 1 - x) / r);
        }
        if (event.kind == engine::kBallBall) {
            const double gap = event.normal.norm() / r - 2;
            worst_.contact_gap = std::max(worst_.contact_gap, std::abs(gap));
            look_at_momentum(event, first.mass, (*bodies_)[event.second].mass);
        } else {
            look_at_energy(event.before[0].velocity.squaredNorm(),
                           event.after[0].velocity.squaredNorm());
        }
        if (++count_ % kLookAtAllEvery == 0) look_at_all(event.when);
    }

private:
    void look_at_momentum(const engine::EventRecord<double>& event, double m1, double m2) {
        const Vec &u1 = event.before[0].velocity, &u2 = event.before[1].velocity;
        const Vec &v1 = event.after[0].velocity, &v2 = event.after[1].velocity;
        look_at_energy(m1 * u1.squaredNorm() + m2 * u2.squaredNorm(),
                       m1 * v1.squaredNorm() + m2 * v2.squaredNorm());
        const double scale = m1 * u1.norm() + m2 * u2.norm();
        const Vec lost = m1 * (v1 - u1) + m2 * (v2 - u2);
        worst_.momentum = std::max(worst_.momentum, lost.norm() / scale);
    }
    void look_at_energy(double before, double after) {
        worst_.gain = std::max(worst_.gain, std::abs(after / before - 1));
    }

    /// Every disk where it is at [now], which may be later than where the engine has it.
    void look_at_all(const math::Instant<double>& now) {
        places_.clear();
        for (const auto& body : *bodies_) {
            const double since = math::duration<double>(body.clock, now);
            places_.push_back(
                math::displaced<double>(body.state.position, body.state.velocity, since));
        }
        const double r = bodies_->front().radius;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            for (std::size_t j = i + 1; j < places_.size(); ++j) {
                const double apart = math::difference<double>(places_[j], places_[i]).norm();
                worst_.overlap = std::max(worst_.overlap, 2 - apart / r);
            }
            const Vec p = places_[i].rounded();
            const double room = std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()});
            worst_.overlap = std::max(worst_.overlap, 1 - room / r);
        }
        worst_.drift = energy_of(*bodies_) / energy_ - 1;
        if (count_ % 10'000'000 == 0) {
            std::fprintf(stderr, "%12llu events, t = %.6g s, energy %+.1e\n",
                         static_cast<unsigned long long>(count_), math::narrow(now), worst_.drift);
        }
    }

    const Bodies* bodies_ = nullptr;
    double energy_ = 0;
    std::uint64_t count_ = 0;
    std::vector<math::WidePoint<double>> places_;
    Worst worst_;
};

/// A recorder whose list of events only looks at them.
template <math::Scalar S>
struct PassingRecorder {
    static constexpr const char* kName = "passing";
    static constexpr bool kEvents = true;
    static constexpr bool kPieces = false;

    using Type = engine::UniformScene<S, engine::Walls, PassingRecorder, engine::AllPairs>;
    Passing<std::vector<engine::Body<Type>>> events;

    void clear() {}
    template <class State>
    [[nodiscard]] static engine::Moment<S> remember(const State& state) {
        return {state.position, state.velocity};
    }
};

}  // namespace

int main(int argc, char** argv) {
    std::uint64_t events = 100'000'000, seed = 1;
    int disks = 16;
    for (int i = 1; i + 1 < argc; i += 2) {
        const auto value = static_cast<std::uint64_t>(std::atof(argv[i + 1]));  // 1e9 will do
        if (std::strcmp(argv[i], "--events") == 0) events = value;
        if (std::strcmp(argv[i], "--disks") == 0) disks = static_cast<int>(value);
        if (std::strcmp(argv[i], "--seed") == 0) seed = value;
    }
    using Type = PassingRecorder<double>::Type;
    engine::Engine<Type> engine(support::gas<Type>(disks, 0.3, seed).scene);
    engine.recorder().events.watch(engine.bodies());
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    const Status status = engine.run({math::never<double>(), events});
    const double worked = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    const double waited =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const Worst& worst = engine.recorder().events.worst();
    const auto done = static_cast<double>(engine.event_count());
    const double walk = 6 * kEpsilon * std::sqrt(done);
    std::printf("%d disks, seed %llu: %.4g events, %.*s, t = %.9g s\n", disks,
                static_cast<unsigned long long>(seed), done,
                static_cast<int>(to_string(status).size()), to_string(status).data(),
                math::narrow(engine.time()));
    std::printf("%.0f events per second of processor time (%.0f s; %.0f s by the clock)\n",
                done / worked, worked, waited);
    std::printf("contacts off by up to %.2e radii, overlaps of up to %.2e radii\n",
                worst.contact_gap, worst.overlap);
    std::printf("one impact changes energy by up to %.2e, momentum by up to %.2e\n", worst.gain,
                worst.momentum);
    std::printf("energy of all: %+.2e (a random walk of one rounding per event: %.1e)\n",
                worst.drift, walk / 6);
    const double gap_bound = 1e-12;
    const bool sound = status == Status::event_limit && worst.contact_gap < gap_bound &&
                       worst.overlap < gap_bound && worst.gain < math::kImpactEnergy * kEpsilon &&
                       worst.momentum < math::kImpactMomentum * kEpsilon &&
                       std::abs(worst.drift) < walk;
    std::puts(sound ? "everything within its bound" : "NOT ALL WITHIN ITS BOUND");
    return sound ? 0 : 1;
}

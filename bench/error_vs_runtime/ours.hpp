#pragma once

#include "compile_scene.hpp"
#include "contender.hpp"
#include "cpu_clock.hpp"
#include "osculo/osculo.hpp"

/// osculo itself, for one scalar type. Timed without a recorder; a second run, not timed, records
/// the contacts.
namespace osculo::bench::ours {

template <math::Scalar S>
[[nodiscard]] Exact exact(const S& x) {
    if constexpr (std::is_same_v<S, math::Quad>) {
        // Three doubles hold all of its digits.
        Exact sum = 0;
        S rest = x;
        for (int i = 0; i < 3; ++i) {
            const double part = static_cast<double>(rest);
            sum += part;
            rest -= part;
        }
        return sum;
    } else {
        return Exact(x);
    }
}

template <class Type>
[[nodiscard]] Snapshot snapshot(const engine::Engine<Type>& engine,
                                const std::vector<std::uint32_t>& order) {
    using S = typename Type::Scalar;
    Snapshot result;
    result.positions.resize(order.size());
    for (std::size_t n = 0; n < order.size(); ++n) {
        const auto& body = engine.bodies()[n];
        const math::Vec<S> p = body.state.position.rounded();
        result.positions[order[n]] = {exact<S>(p.x()), exact<S>(p.y())};
        if (!body.present) continue;
        const Exact mass = exact<S>(body.mass);
        const Exact vx = exact<S>(body.state.velocity.x());
        const Exact vy = exact<S>(body.state.velocity.y());
        result.energy += mass * (vx * vx + vy * vy) / 2;
        if constexpr (Type::Motion::kSpin) {
            Exact spin = 0;
            for (int k = 0; k < 3; ++k) {
                spin += exact<S>(body.state.spin[k]) * exact<S>(body.state.spin[k]);
            }
            const Exact radius = exact<S>(body.radius);
            result.energy += exact<S>(body.state.inertia) * mass * radius * radius * spin / 2;
        }
    }
    return result;
}

template <class Type>
void add_contacts(engine::Engine<Type>& engine, const std::vector<std::uint32_t>& order,
                  std::vector<Contact>& contacts) {
    using S = typename Type::Scalar;
    constexpr bool kRims = Type::ObstacleList::template kContains<S, geometry::Rim<S>>;
    for (const auto& event : engine.recorder().events) {
        if (event.kind == engine::kTransition) continue;
        const double time = math::to_double<S>(math::narrow(event.when));
        const int first = static_cast<int>(order[event.first]);
        if (event.kind == engine::kBallBall) {
            const int second = static_cast<int>(order[event.second]);
            contacts.push_back({time, first, second});
            contacts.push_back({time, second, first});
        } else {
            const bool rim = kRims && event.kind == engine::kFirstObstacle;
            contacts.push_back({time, first, rim ? kRim : kCushion});
        }
    }
}

/// Short runs are repeated until the clock can tell how long they take.
inline constexpr double kLeastTimed = 20e-6;
inline constexpr int kMostRepetitions = 64;

template <class Plain, class Recording>
[[nodiscard]] Trace play_as(const Task& task) {
    using S = typename Plain::Scalar;
    constexpr std::uint64_t kEvents = 10'000'000;
    Trace trace;
    const auto compiled = facade::compile_scene<Plain>(task.scene);
    engine::Engine<Plain> engine(compiled.data);
    for (const double time : task.times) {
        int repetitions = 0;
        double taken = 0;
        const double start = cpu_now();
        do {
            engine.restart(compiled.data.bodies);
            const Status status = engine.run({S(time), kEvents});
            trace.gave_up = trace.gave_up || status == Status::numeric || status == Status::zeno;
            ++repetitions;
            taken = cpu_now() - start;
        } while (taken < kLeastTimed && repetitions < kMostRepetitions);
        trace.snapshots.push_back(snapshot(engine, compiled.balls));
        // Of two readings of the clock per run, one falls into the time that is measured.
        trace.snapshots.back().cpu_seconds = std::max(taken / repetitions - clock_cost(), 1e-9);
    }
    engine::Engine<Recording> recording(facade::compile_scene<Recording>(task.scene).data);
    recording.run({S(task.record_until), kEvents});
    add_contacts(recording, compiled.balls, trace.contacts);
    return trace;
}

template <math::Scalar S, class Obstacles, template <class> class BroadPhase>
[[nodiscard]] Trace play_uniform(const Task& task) {
    return play_as<engine::UniformScene<S, Obstacles, engine::NoRecorder, BroadPhase>,
                   engine::UniformScene<S, Obstacles, engine::EventRecorder, BroadPhase>>(task);
}

/// The narrowest engine that covers the scene.
template <math::Scalar S>
[[nodiscard]] Trace play(const Task& task) {
    const Scene& scene = task.scene;
    if (std::holds_alternative<ClothMotion>(scene.motion)) {
        return play_as<engine::ClothScene<S, impact::CushionHan2005, engine::NoRecorder>,
                       engine::ClothScene<S, impact::CushionHan2005, engine::ClothEvents>>(task);
    }
    if (!scene.arcs.empty() || !scene.rims.empty()) {
        return play_uniform<S, engine::Table, engine::AllPairs>(task);
    }
    if (scene.balls.size() > 64) return play_uniform<S, engine::Walls, engine::CellGrid>(task);
    return play_uniform<S, engine::Walls, engine::AllPairs>(task);
}

template <math::Scalar S>
[[nodiscard]] Contender contender(const char* name) {
    return {name, false, true, &play<S>};
}

}  // namespace osculo::bench::ours

#pragma once

#include <cstdint>
#include <vector>

#include "compile_scene.hpp"
#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"
#include "osculo/run.hpp"

namespace osculo::facade {

/// Results of an engine in the terms of the scene it came from, rounded to double.
template <class Type>
class Converter {
public:
    using S = typename Type::Scalar;

    Converter(const Scene& scene, const CompiledScene<Type>& compiled)
        : scene_(scene), compiled_(compiled) {}

    [[nodiscard]] std::vector<FinalBall> balls(
        const std::vector<engine::Body<Type>>& bodies) const {
        std::vector<FinalBall> result(bodies.size());
        for (std::size_t n = 0; n < bodies.size(); ++n) {
            const std::uint32_t index = compiled_.balls[n];
            result[index] = final_ball(bodies[n], index);
        }
        return result;
    }

    [[nodiscard]] FinalBall final_ball(const engine::Body<Type>& body, std::uint32_t index) const {
        FinalBall ball;
        ball.state = state(body.state, index);
        if (!body.present) {
            ball.fate = BallFate::captured;
            ball.rim = rim_of(body);
        } else if (Type::Motion::template at_rest<S>(body.state)) {
            ball.fate = BallFate::rest;
        }
        return ball;
    }

    template <class Memory>
    [[nodiscard]] Event event(const engine::EventRecord<S, Memory>& record) const {
        Event event;
        event.time = high(record.when);
        event.time_low = low(record.when);
        event.kind = kind(record.kind);
        event.ball = compiled_.balls[record.first];
        if constexpr (engine::kHasRims<typename Type::Motion>) {
            if (event.kind == EventKind::transition && ends_stay(record)) {
                return end_of_stay(record, event);
            }
        }
        if (event.kind == EventKind::transition) {
            event.point = point(record.before[0].position.rounded());
            event.before[0] = state(record.before[0], event.ball);
            event.after[0] = state(record.after[0], event.ball);
            // At rest already, but for the transition.
            event.from = kResisted ? Phase::resisted : phase(record.before[0]);
            event.to = phase(record.after[0]);
            return event;
        }
        event.other = other(event.kind, record.second);
        event.cluster = record.cluster.number;
        event.well_posed = record.cluster.well_posed;
        const math::Vec<S> unit = record.normal / math::norm<S>(record.normal);
        event.normal = point(unit);
        const math::Vec<S> center = record.before[0].position.rounded();
        const bool of_center =
            event.kind == EventKind::capture || event.kind == EventKind::rim_entry;
        const S radius = of_center ? S(0) : S(scene_.balls[event.ball].radius);
        event.point = point(math::Vec<S>(center + radius * unit));
        const int count = event.kind == EventKind::ball_ball ? 2 : 1;
        for (int k = 0; k < count; ++k) {
            const auto n = static_cast<std::size_t>(k);
            const std::uint32_t index = k == 0 ? event.ball : event.other;
            event.before[n] = state(record.before[n], index);
            event.after[n] = state(record.after[n], index);
        }
        return event;
    }

    [[nodiscard]] Piece piece(const engine::PieceRecord<S>& record) const {
        return piece(record, engine::Moment<S>{record.position, record.velocity});
    }
    template <class State>
    [[nodiscard]] Piece piece(const engine::StatePieceRecord<S, State>& record) const {
        Piece piece = this->piece(record, record.state);
        const math::Vec<S> acceleration = S(2) * record.state.half_acceleration;
        piece.acceleration = point(acceleration);
        piece.phase = phase(record.state);
        if constexpr (kResisted) {
            const auto& law = record.state.law;
            piece.resistance = {math::to_double<S>(law.constant), math::to_double<S>(law.linear),
                                math::to_double<S>(law.quadratic)};
        }
        if constexpr (engine::kHasRims<typename Type::Motion>) {
            if (record.state.stay) {
                piece.acceleration = {};
                piece.rim = compiled_.pulling_rims[record.state.rim];
                if constexpr (kTips<Type>) {
                    const auto& state = record.state;
                    piece.height = math::to_double<S>(state.height);
                    piece.climb = math::to_double<S>(state.climb);
                    piece.inertia = state.slides ? 0.0 : math::to_double<S>(state.inertia);
                }
            }
        }
        if constexpr (kCloth) {
            piece.spin_rate = {math::to_double<S>(record.state.spin_rate.x()),
                               math::to_double<S>(record.state.spin_rate.y()),
                               math::to_double<S>(record.state.spin_decay)};
        }
        return piece;
    }

    [[nodiscard]] Audit audit(const engine::RunAudit& found) const {
        Audit audit;
        audit.energy_initial = found.energy_initial;
        audit.energy_final = found.energy_final;
        audit.largest_energy_gain = found.largest_energy_gain;
        audit.largest_momentum_error = found.largest_momentum_error;
        audit.worst_gap = found.worst_gap;
        audit.worst_gap_time = found.worst_gap_time;
        if (found.worst_first.kind != engine::kNothing) {
            audit.worst_gap_ids = {id(found.worst_first), id(found.worst_second)};
        } else {
            audit.worst_gap = 0;  // files have no infinity
        }
        audit.largest_jump = found.largest_jump;
        audit.unexplained = found.unexplained;
        audit.clean = found.clean;
        return audit;
    }

    /// The index in the scene of what the engine numbers n among things of that kind.
    [[nodiscard]] std::uint32_t other(EventKind event_kind, std::uint32_t n) const {
        switch (event_kind) {
            case EventKind::capture: return compiled_.rims[n];
            case EventKind::rim_entry:
            case EventKind::rim_exit: return compiled_.pulling_rims[n];
            case EventKind::ball_ball: return compiled_.balls[n];
            case EventKind::ball_segment: return compiled_.segments[n];
            case EventKind::ball_arc: return compiled_.arcs[n];
            case EventKind::ball_point:
            case EventKind::transition: return n;
        }
        return n;
    }

    /// The facade's name of the engine's kind of event.
    [[nodiscard]] static EventKind kind(engine::Kind engine_kind) {
        using Storage = typename Type::ObstacleStorage;
        if (engine_kind == engine::kBallBall) return EventKind::ball_ball;
        if (engine_kind == engine::kTransition) return EventKind::transition;
        EventKind result = EventKind::ball_point;
        [&]<std::size_t... K>(std::index_sequence<K...>) {
            ((engine_kind == engine::kFirstObstacle + K
                  ? void(result = kind_of(
                             static_cast<typename std::tuple_element_t<K, Storage>*>(nullptr)))
                  : void()),
             ...);
        }
        (std::make_index_sequence<std::tuple_size_v<Storage>>{});
        return result;
    }

private:
    static constexpr bool kCloth = std::is_same_v<typename Type::Motion, motion::Cloth>;
    static constexpr bool kDisc = std::is_same_v<typename Type::Motion, motion::Disc>;
    static constexpr bool kResisted = std::is_base_of_v<motion::Resisted, typename Type::Motion>;

    [[nodiscard]] std::string id(const engine::Thing& thing) const {
        const EventKind event_kind = kind(thing.kind);
        const std::uint32_t index = other(event_kind, thing.index);
        switch (event_kind) {
            case EventKind::capture:
            case EventKind::rim_entry:
            case EventKind::rim_exit: return scene_.rims[index].id;
            case EventKind::ball_ball: return scene_.balls[index].id;
            case EventKind::ball_segment: return scene_.segments[index].id;
            case EventKind::ball_arc: return scene_.arcs[index].id;
            case EventKind::ball_point: return compiled_.points[index];
            case EventKind::transition: break;
        }
        return {};
    }
    /// The rim that has captured a ball.
    [[nodiscard]] std::uint32_t rim_of(const engine::Body<Type>& body) const {
        if constexpr (engine::kHasRims<typename Type::Motion>) {
            if (body.state.fallen) return compiled_.pulling_rims[body.state.rim];
        }
        return compiled_.rims[body.last_other];
    }
    /// Whether a transition is that of a ball out of, or into, a rim that pulled it.
    template <class Record>
    [[nodiscard]] static bool ends_stay(const Record& record) {
        return record.before[0].stay && (record.after[0].fallen || !record.after[0].stay);
    }
    template <class Record>
    [[nodiscard]] Event end_of_stay(const Record& record, Event event) const {
        const auto& rim = record.before[0].stay->rim();
        event.kind = record.after[0].fallen ? EventKind::capture : EventKind::rim_exit;
        event.other = compiled_.pulling_rims[record.before[0].rim];
        const math::Vec<S> inwards = -math::difference<S>(record.before[0].position, rim.center);
        event.normal = point(math::Vec<S>(inwards / math::norm<S>(inwards)));
        event.point = point(record.before[0].position.rounded());
        event.before[0] = state(record.before[0], event.ball);
        event.after[0] = state(record.after[0], event.ball);
        return event;
    }
    static constexpr EventKind kind_of(const std::vector<geometry::Rim<S>>*) {
        return EventKind::capture;
    }
    static constexpr EventKind kind_of(const std::vector<geometry::PullingRim<S>>*) {
        return EventKind::rim_entry;
    }
    static constexpr EventKind kind_of(const std::vector<geometry::Segment<S>>*) {
        return EventKind::ball_segment;
    }
    static constexpr EventKind kind_of(const std::vector<geometry::Arc<S>>*) {
        return EventKind::ball_arc;
    }
    static constexpr EventKind kind_of(const std::vector<geometry::Point<S>>*) {
        return EventKind::ball_point;
    }

    /// A wide number as two doubles.
    [[nodiscard]] static double high(const math::Wide<S>& x) {
        return math::to_double<S>(math::narrow(x));
    }
    [[nodiscard]] static double low(const math::Wide<S>& x) {
        const double rounded = high(x);
        return math::to_double<S>(math::narrow(math::Wide<S>(x - S(rounded))));
    }
    [[nodiscard]] static Point point(const math::Vec<S>& v) {
        return {math::to_double<S>(v.x()), math::to_double<S>(v.y())};
    }
    template <class Memory>
    [[nodiscard]] BallState state(const Memory& memory, std::uint32_t index) const {
        BallState result{point(memory.position.rounded()), point(memory.velocity),
                         scene_.balls[index].spin};
        if constexpr (Type::Motion::kSpin) {
            const auto& w = memory.spin;
            result.spin = {math::to_double<S>(w.x()), math::to_double<S>(w.y()),
                           math::to_double<S>(w.z())};
        }
        return result;
    }
    template <class State>
    [[nodiscard]] Phase phase(const State& state) const {
        if constexpr (engine::kHasRims<typename Type::Motion>) {
            if constexpr (kTips<Type>) {
                if (state.stay) return state.stay->on_edge() ? Phase::tipping : Phase::flying;
            } else {
                if (state.stay) return Phase::rim;
            }
            if (std::holds_alternative<UniformMotion>(scene_.motion)) return Phase::uniform;
        }
        if constexpr (kCloth) {
            switch (state.phase) {
                case motion::ClothPhase::rest: return Phase::rest;
                case motion::ClothPhase::spinning: return Phase::spinning;
                case motion::ClothPhase::rolling: return Phase::rolling;
                case motion::ClothPhase::sliding: return Phase::sliding;
            }
        } else if constexpr (Type::Motion::kTransitions) {
            if (Type::Motion::template at_rest<S>(state)) return Phase::rest;
            if constexpr (kResisted) {
                const auto& law = state.law;
                const bool free =
                    law.constant == S(0) && law.linear == S(0) && law.quadratic == S(0);
                return kDisc && free ? Phase::uniform : Phase::resisted;
            }
            return Phase::rolling;
        }
        return Phase::uniform;
    }
    /// What all kinds of pieces have.
    template <class Record, class State>
    [[nodiscard]] Piece piece(const Record& record, const State& at_start) const {
        Piece piece;
        piece.ball = compiled_.balls[record.ball];
        piece.from = high(record.from);
        piece.from_low = low(record.from);
        piece.to = high(record.to);
        piece.to_low = low(record.to);
        const BallState begin = state(at_start, piece.ball);
        piece.position = begin.position;
        piece.position_low = {low(at_start.position.x), low(at_start.position.y)};
        piece.velocity = begin.velocity;
        piece.spin = begin.spin;
        return piece;
    }

    const Scene& scene_;
    const CompiledScene<Type>& compiled_;
};

}  // namespace osculo::facade

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
            const engine::Body<Type>& body = bodies[n];
            const std::uint32_t index = compiled_.balls[n];
            FinalBall& ball = result[index];
            ball.state = state({body.state.position, body.state.velocity}, index);
            if (!body.present) {
                ball.fate = BallFate::captured;
                ball.rim = compiled_.rims[body.last_other];
            } else if (Type::Motion::template at_rest<S>(body.state)) {
                ball.fate = BallFate::rest;
            }
        }
        return result;
    }

    [[nodiscard]] Event event(const engine::EventRecord<S>& record) const {
        Event event;
        event.time = high(record.when);
        event.time_low = low(record.when);
        event.kind = kind(record.kind);
        event.ball = compiled_.balls[record.first];
        event.other = other(event.kind, record.second);
        const math::Vec<S> unit = record.normal / math::norm<S>(record.normal);
        event.normal = point(unit);
        const math::Vec<S> center = record.before[0].position.rounded();
        const S radius =
            event.kind == EventKind::capture ? S(0) : S(scene_.balls[event.ball].radius);
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
        const std::uint32_t index = compiled_.balls[record.ball];
        return {index,
                high(record.from),
                low(record.from),
                high(record.to),
                low(record.to),
                {high(record.position.x), high(record.position.y)},
                {low(record.position.x), low(record.position.y)},
                point(record.velocity),
                scene_.balls[index].spin};
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
            case EventKind::ball_ball: return compiled_.balls[n];
            case EventKind::ball_segment: return compiled_.segments[n];
            case EventKind::ball_arc: return compiled_.arcs[n];
            case EventKind::ball_point: return n;
        }
        return n;
    }

    /// The facade's name of the engine's kind of event.
    [[nodiscard]] static EventKind kind(engine::Kind engine_kind) {
        using Storage = typename Type::ObstacleStorage;
        if (engine_kind == engine::kBallBall) return EventKind::ball_ball;
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
    [[nodiscard]] std::string id(const engine::Thing& thing) const {
        const EventKind event_kind = kind(thing.kind);
        const std::uint32_t index = other(event_kind, thing.index);
        switch (event_kind) {
            case EventKind::capture: return scene_.rims[index].id;
            case EventKind::ball_ball: return scene_.balls[index].id;
            case EventKind::ball_segment: return scene_.segments[index].id;
            case EventKind::ball_arc: return scene_.arcs[index].id;
            case EventKind::ball_point: return compiled_.points[index];
        }
        return {};
    }
    static constexpr EventKind kind_of(const std::vector<geometry::Rim<S>>*) {
        return EventKind::capture;
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
    [[nodiscard]] BallState state(const engine::Moment<S>& moment, std::uint32_t index) const {
        return {point(moment.position.rounded()), point(moment.velocity), scene_.balls[index].spin};
    }

    const Scene& scene_;
    const CompiledScene<Type>& compiled_;
};

}  // namespace osculo::facade

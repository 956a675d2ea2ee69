#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "osculo/engine/audit.hpp"
#include "osculo/osculo.hpp"

/// Scenes for tests, straight from the template core.
namespace osculo::support {

/// What most tests run: every kind of obstacle, everything recorded, no grid. Impacts at one
/// instant are resolved pair by pair or
template <math::Scalar S, class Simultaneous = impact::Sequential>
using TableScene =
    engine::UniformScene<S, engine::Table, engine::PieceRecorder, engine::AllPairs, Simultaneous>;
/// all at once.
template <math::Scalar S>
using SymmetricTable = TableScene<S, impact::Symmetric>;

/// Puts scenes together, of whatever scene type has a place for what is added.
template <class Type>
struct Builder {
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;

    engine::SceneData<Type> scene;

    Builder& ball(const Vec& position, const Vec& velocity, const S& radius = S(1),
                  const S& mass = S(1)) {
        engine::Body<Type> body;
        body.state.position = math::WidePoint<S>(position);
        body.state.velocity = velocity;
        body.radius = radius;
        body.mass = mass;
        scene.bodies.push_back(body);
        return *this;
    }

    /// A segment with its end points.
    Builder& wall(const Vec& from, const Vec& to, bool one_sided = false) {
        list<geometry::Segment<S>>().push_back(geometry::Segment<S>(from, to, one_sided));
        if constexpr (kHas<geometry::Point<S>>) {
            point(from);
            point(to);
        }
        return *this;
    }

    Builder& point(const Vec& at) {
        list<geometry::Point<S>>().push_back({at});
        return *this;
    }

    /// One-sided walls around corners in counter-clockwise order, with one point per corner.
    Builder& outline(const std::vector<Vec>& corners, bool one_sided = true) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec& next = corners[(k + 1) % corners.size()];
            list<geometry::Segment<S>>().push_back(
                geometry::Segment<S>(corners[k], next, one_sided));
            if constexpr (kHas<geometry::Point<S>>) point(corners[k]);
        }
        return *this;
    }

    Builder& box(const S& low_x, const S& low_y, const S& high_x, const S& high_y) {
        return outline(
            {Vec(low_x, low_y), Vec(high_x, low_y), Vec(high_x, high_y), Vec(low_x, high_y)});
    }

    /// An arc from one direction to another (unit vectors to rounding), with its end points.
    Builder& arc(const Vec& center, const S& radius, const Vec& start, const Vec& end,
                 bool reflex) {
        const geometry::Arc<S> arc{center, radius, start, end, reflex, false};
        list<geometry::Arc<S>>().push_back(arc);
        point(arc.start_point());
        return point(arc.end_point());
    }

    Builder& circle(const Vec& center, const S& radius) {
        const Vec east(S(1), S(0));
        list<geometry::Arc<S>>().push_back({center, radius, east, east, true, true});
        return *this;
    }

    Builder& rim(const Vec& center, const S& radius) {
        list<geometry::Rim<S>>().push_back({center, radius});
        return *this;
    }

    Builder& restitution(const S& ball_ball, const S& ball_cushion) {
        scene.ball_ball_restitution = ball_ball;
        scene.ball_cushion_restitution = ball_cushion;
        return *this;
    }

private:
    template <class Obstacle>
    static constexpr bool kHas = Type::ObstacleList::template kContains<S, Obstacle>;
    template <class Obstacle>
    std::vector<Obstacle>& list() {
        return std::get<std::vector<Obstacle>>(scene.obstacles);
    }
};

/// A run with what it came from and what it left.
template <class Type>
struct Played {
    using S = typename Type::Scalar;
    engine::SceneData<Type> scene;
    Status status{};
    std::uint64_t events = 0;
    math::Instant<S> end{S(0)};
    std::vector<engine::Body<Type>> bodies;
    typename Type::Recorder record;

    [[nodiscard]] engine::RunAudit audit() const {
        return engine::audit<Type>(scene, record, bodies, end);
    }
    [[nodiscard]] math::Vec<S> position(std::size_t i) const {
        return bodies[i].state.position.rounded();
    }
    [[nodiscard]] const math::Vec<S>& velocity(std::size_t i) const {
        return bodies[i].state.velocity;
    }
};

template <class Type>
[[nodiscard]] Played<Type> play(const engine::SceneData<Type>& scene,
                                const typename Type::Scalar& time,
                                std::uint64_t events = 1'000'000) {
    engine::Engine<Type> engine(scene);
    Played<Type> played{scene, {}, 0, {}, {}, {}};
    played.status = engine.run({time, events});
    played.events = engine.event_count();
    played.end = engine.time();
    played.bodies = engine.bodies();
    played.record = std::move(engine.recorder());
    return played;
}

/// The audit in words, for messages of failing tests.
[[nodiscard]] inline std::string describe(const engine::RunAudit& audit) {
    const auto thing = [](const engine::Thing& of) {
        return std::to_string(of.kind) + ":" + std::to_string(of.index);
    };
    char text[400];
    std::snprintf(text, sizeof text,
                  "%s gap %.3e at %.17g (%s, %s) contact %.3e jump %.3e energy %.3e momentum %.3e "
                  "unexplained %llu",
                  audit.clean ? "clean" : "NOT CLEAN", audit.worst_gap, audit.worst_gap_time,
                  thing(audit.worst_first).c_str(), thing(audit.worst_second).c_str(),
                  audit.largest_contact_error, audit.largest_jump, audit.largest_energy_gain,
                  audit.largest_momentum_error, static_cast<unsigned long long>(audit.unexplained));
    return text;
}

}  // namespace osculo::support

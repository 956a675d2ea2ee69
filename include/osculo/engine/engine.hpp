#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "osculo/engine/broad_phase.hpp"
#include "osculo/engine/cluster_workspace.hpp"
#include "osculo/engine/event.hpp"
#include "osculo/engine/obstacle_boxes.hpp"
#include "osculo/engine/queue.hpp"
#include "osculo/engine/recorder.hpp"
#include "osculo/engine/traits.hpp"
#include "osculo/impact/pressing.hpp"
#include "osculo/motion/swept_box.hpp"
#include "osculo/status.hpp"

namespace osculo::engine {

struct Nothing {};

/// A ball as the engine keeps it. Its state is that at its own clock: a ball is touched only by the
/// events it takes part in.
template <class Type>
struct Body {
    using S = typename Type::Scalar;

    typename Type::State state;
    math::Instant<S> clock{S(0)};
    S mass{1};                  ///< [kg]
    S radius{1};                ///< [m]
    S noise{0};                 ///< rounding noise of the velocity [m/s]: 0 until its first impact
    std::uint32_t age = 0;      ///< number of its events so far
    Kind last_kind = kNothing;  ///< what the last of them was,
    std::uint32_t last_other = 0;  ///< and with what
    bool present = true;           ///< false once captured
    /// Where forces can press balls together.
    [[no_unique_address]] std::conditional_t<Type::Motion::kTransitions, impact::Hops<S>, Nothing>
        hops;
};

/// The impact laws of balls with spin; nothing for others.
template <class Type, bool = Type::Motion::kSpin>
struct FrictionLaws {};
template <class Type>
struct FrictionLaws<Type, true> : Type::Impact::template Laws<typename Type::Scalar> {};

/// What a scene holds and how its impacts go, for the engine of that scene type.
template <class Type>
struct SceneData {
    using S = typename Type::Scalar;

    std::vector<Body<Type>> bodies;
    typename Type::ObstacleStorage obstacles;
    S ball_ball_restitution{1};
    S ball_cushion_restitution{1};
    [[no_unique_address]] typename Type::MotionParameters motion;
    [[no_unique_address]] FrictionLaws<Type> friction;  ///< where balls have spin
    /// Contacts that close more slowly do not bounce [m/s], where contacts of one instant are
    /// resolved together (engine/cluster.hpp).
    [[no_unique_address]] std::conditional_t<Type::Simultaneous::kGathersCluster, S, Nothing>
        rest_speed{};
    /// Shortest time between impacts of things that are pressed together [s], for motion with
    /// acceleration (impact/pressing.hpp).
    [[no_unique_address]] std::conditional_t<Type::Motion::kTransitions, S, Nothing> contact_time{};
};

/// What ends a run.
template <math::Scalar S>
struct RunLimits {
    S time;  ///< [s]
    std::uint64_t events;
};

/// What is to be remembered of a run that has been stopped, besides its engine.
struct Pause {
    std::uint64_t at_this_instant = 0;  ///< events since time last advanced
};

/// Plays a scene event by event. See DESIGN 1: motion turns states into paths, detect finds the
/// earliest contact of every path, the queue orders them, impact changes velocities.
///
/// An engine is a value: a copy goes on as the original would, bit for bit.
template <class Type>
class Engine {
public:
    using S = typename Type::Scalar;
    using Instant = math::Instant<S>;
    using Vec = math::Vec<S>;
    using Path = decltype(Type::Motion::template path<S>(std::declval<typename Type::State>()));
    using BodyType = Body<Type>;

    /// Predicts every ball's first event. Requires a valid scene: positive finite masses and radii,
    /// finite states.
    explicit Engine(SceneData<Type> scene)
        : scene_(std::move(scene)),
          queue_(scene_.bodies.size()),
          obstacle_boxes_(scene_.obstacles),
          broad_phase_(scene_.bodies) {
        start();
    }

    /// Plays the scene from another start, as a new engine with these balls would. Requires as many
    /// of them as there were. No allocation without a cell grid, but what the recorder needs.
    void restart(std::span<const BodyType> bodies) {
        scene_.bodies.assign(bodies.begin(), bodies.end());
        broad_phase_ = typename Type::BroadPhase(scene_.bodies);
        recorder_.clear();
        if constexpr (Type::Simultaneous::kGathersCluster) {
            cluster_.number = 0;
            cluster_.settled = 0;
            cluster_.endless = false;
        }
        now_ = Instant{S(0)};
        event_count_ = prediction_count_ = 0;
        for (BallIndex i = 0; i < scene_.bodies.size(); ++i) queue_.update(i, Scheduled{});
        start();
    }

    /// Runs until nothing more can happen or a limit is reached. Afterwards every ball that is
    /// still there has its clock at the same instant, time(). To be called once per start.
    Status run(const RunLimits<S>& limits) {
        Pause begin;
        return finish(play(limits, begin), limits);
    }

    /// The same in parts: plays until a limit is reached, and goes on from there when it is called
    /// again with other limits, as if it had never stopped. Balls keep their own clocks.
    Status play(const RunLimits<S>& limits, Pause& pause);
    /// What run() does in the end, once play() has returned that status for those limits: brings
    /// every ball to the end. Returns the status of the run.
    Status finish(Status status, const RunLimits<S>& limits);

    [[nodiscard]] const std::vector<BodyType>& bodies() const { return scene_.bodies; }
    [[nodiscard]] const Instant& time() const { return now_; }
    [[nodiscard]] std::uint64_t event_count() const { return event_count_; }
    /// Impacts so far that did not bounce because they were slower than the scene's rest_speed.
    [[nodiscard]] std::uint64_t settled_count() const {
        if constexpr (Type::Simultaneous::kGathersCluster) {
            return cluster_.settled;
        } else {
            return 0;
        }
    }
    /// Predictions of one ball's next event so far: the work done.
    [[nodiscard]] std::uint64_t prediction_count() const { return prediction_count_; }
    [[nodiscard]] typename Type::Recorder& recorder() { return recorder_; }

    /// Shows an archive, in a fixed order, all that a run changes: it takes that down, or puts in
    /// what it took down of an engine that began with the same scene. archive.require(bool) then
    /// has to refuse what is not true of any.
    template <class Archive>
    void archive(Archive& archive);  // archive.hpp

private:
    using Scheduled = Event<S>;
    using Box = geometry::Box<S>;
    using ObstacleBoxesType = ObstacleBoxes<S, typename Type::ObstacleStorage>;
    using Recorder = typename Type::Recorder;

    using Contact = ContactId;

    void start();

    // prediction.hpp
    void predict(BallIndex i, bool others = true);
    [[nodiscard]] static Box swept_box(const BodyType& body, const Path& path,
                                       const Scheduled& best);
    void predict_obstacles(BallIndex i, const Path& path, Scheduled& best, Box& swept) const;
    template <std::size_t K, bool MostPaths>
    void predict_kind(BallIndex i, const Path& path, Scheduled& best, Box& swept) const;
    bool predict_ball(BallIndex i, const Path& path, BallIndex j, Scheduled& best) const;
    bool offer(Kind kind, BallIndex i, std::uint32_t other, std::uint32_t other_age,
               const Instant& start, const S& wait, Scheduled& best) const;
    [[nodiscard]] static S horizon(const Instant& start, const Scheduled& best);

    /// Lets the motion law see that a ball's velocity or spin has been changed.
    void begin_motion(BodyType& body);
    [[nodiscard]] bool is_void(const Scheduled& event) const;
    void change_phase(BallIndex i);
    void resolve_balls(BodyType& one, BodyType& other, const Vec& normal);  // resolution.hpp
    void resolve_cushion(BodyType& body, const Vec& normal);
    [[nodiscard]] S pressing_time(std::initializer_list<BodyType*> bodies);

    // gathering.hpp, cluster.hpp
    [[nodiscard]] bool gather(const Contact& contact);
    void add_member(BallIndex i);
    void gather_balls(std::size_t m);
    [[nodiscard]] bool meets_there(std::size_t m, const Vec& normal) const;
    template <std::size_t K>
    void gather_obstacles(std::size_t m);
    [[nodiscard]] bool settles() const;
    [[nodiscard]] S restitution_of(Kind kind) const;
    void load_cluster(bool settling);
    void take_from_law(std::size_t m, typename Type::State& state) const;
    void part_cluster();
    [[nodiscard]] bool cause_explained(const Contact& cause) const;
    [[nodiscard]] std::optional<bool> resolve_cluster(const Contact& cause);
    void record_cluster(bool well_posed);

    // archive.hpp
    [[nodiscard]] bool exists(Kind kind, BallIndex first, std::uint32_t second) const;
    template <class Memory>
    [[nodiscard]] bool is_known(const Memory& memory) const;

    [[nodiscard]] bool carry_out(const Scheduled& event);
    [[nodiscard]] bool resolves(BallIndex i) const;
    [[nodiscard]] bool collide_balls(const Contact& contact);
    template <std::size_t K>
    [[nodiscard]] bool meet_obstacle(const Contact& contact);
    /// Calls f with the compile-time number of the kind of obstacle.
    template <class F>
    [[nodiscard]] static bool visit_kind(Kind kind, F&& f);
    [[nodiscard]] static bool is_impact(Kind kind);

    void advance(BallIndex i);
    void note_impact(BodyType& body, const Vec& before, Kind kind, std::uint32_t other);
    void end_piece(BallIndex i, const Instant& to);
    [[nodiscard]] bool gap_explained(const BodyType& one, const BodyType& other, const S& gap,
                                     const S& travelled) const;
    [[nodiscard]] bool all_at_rest() const;

    SceneData<Type> scene_;
    EventQueue<S> queue_;
    [[no_unique_address]] ObstacleBoxesType obstacle_boxes_;
    [[no_unique_address]] typename Type::BroadPhase broad_phase_;
    std::vector<Box> swept_;  ///< around what each ball covers before its next event
    [[no_unique_address]] ClusterWorkspace<Type> cluster_;
    [[no_unique_address]] Recorder recorder_;
    Instant now_{S(0)};
    std::uint64_t event_count_ = 0;
    std::uint64_t prediction_count_ = 0;
};

template <class Type>
void Engine<Type>::start() {
    swept_.clear();
    swept_.reserve(scene_.bodies.size());
    for (BodyType& body : scene_.bodies) {
        begin_motion(body);
        swept_.push_back(swept_box(body, Type::Motion::template path<S>(body.state), Scheduled{}));
    }
    // Two balls that stand never meet, and one that moves looks at all that stand.
    for (BallIndex i = 0; i < scene_.bodies.size(); ++i) {
        predict(i, !Type::Motion::template path<S>(scene_.bodies[i].state).stands());
    }
}

template <class Type>
Status Engine<Type>::play(const RunLimits<S>& limits, Pause& pause) {
    const Instant end{limits.time};
    const std::uint64_t most_at_one_instant = 1000 + 100 * std::uint64_t(scene_.bodies.size());
    for (;;) {
        if (queue_.empty() || queue_.top().kind == kNothing) {
            return all_at_rest() ? Status::at_rest : Status::time_limit;
        }
        const Scheduled event = queue_.top();
        const BallIndex owner = queue_.top_ball();
        if (is_void(event)) {  // first of all: it does not say that there is anything ahead
            predict(owner);
            continue;
        }
        if (event.when > end) return Status::time_limit;
        if constexpr (Type::BroadPhase::kCrossings) {
            if (event.kind == kCellCrossing) {
                broad_phase_.cross(owner,
                                   Type::Motion::template path<S>(scene_.bodies[owner].state));
                predict(owner);
                continue;
            }
        }
        if (event_count_ >= limits.events) return Status::event_limit;
        const bool no_time_passes =
            math::duration<S>(now_, event.when) <= math::resolution<S>(event.when);
        pause.at_this_instant = no_time_passes ? pause.at_this_instant + 1 : 0;
        if (pause.at_this_instant > most_at_one_instant) return Status::zeno;
        now_ = event.when;
        if (!resolves(event.first) || (event.kind == kBallBall && !resolves(event.second))) {
            return Status::numeric;
        }
        const bool sound = carry_out(event);
        ++event_count_;  // it has been recorded
        if (sound) continue;
        if constexpr (Type::Simultaneous::kGathersCluster) {
            if (cluster_.endless) return Status::zeno;
        }
        return Status::numeric;
    }
}

template <class Type>
bool Engine<Type>::is_void(const Scheduled& event) const {
    return event.kind == kBallBall && (event.first_age != scene_.bodies[event.first].age ||
                                       event.second_age != scene_.bodies[event.second].age);
}

template <class Type>
template <class F>
bool Engine<Type>::visit_kind(Kind kind, F&& f) {
    bool result = true;
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        (void)((kind == kFirstObstacle + K
                    ? (result = f(std::integral_constant<std::size_t, K>{}), true)
                    : false) ||
               ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
    return result;
}

/// False if the event could not be resolved in this scalar type.
template <class Type>
bool Engine<Type>::carry_out(const Scheduled& event) {
    if constexpr (Type::Motion::kTransitions) {
        if (event.kind == kTransition) {
            change_phase(event.first);
            if constexpr (kHasRims<typename Type::Motion>) {
                return !scene_.bodies[event.first].state.lost;
            }
            return true;
        }
    }
    const Contact contact{event.kind, event.first, event.second};
    if constexpr (Type::Simultaneous::kGathersCluster) {
        if (is_impact(event.kind) && (gather(contact) || settles())) {
            const std::optional<bool> sound = resolve_cluster(contact);
            if (sound) return *sound;
        }
    }
    if (contact.kind == kBallBall) return collide_balls(contact);
    return visit_kind(contact.kind,
                      [&](auto kind) { return meet_obstacle<decltype(kind)::value>(contact); });
}

/// Whether the clock can tell where the ball is.
template <class Type>
bool Engine<Type>::resolves(BallIndex i) const {
    const BodyType& body = scene_.bodies[i];
    if constexpr (requires { Type::Motion::template resolves<S>(body.state); }) {
        if (!Type::Motion::template resolves<S>(body.state)) return false;
    }
    return math::norm1<S>(body.state.velocity) * math::resolution<S>(now_) <=
           S(math::kUnresolved) * body.radius;
}

/// Whether it is an event at which something is hit.
template <class Type>
bool Engine<Type>::is_impact(Kind kind) {
    return kind == kBallBall || visit_kind(kind, [](auto k) {
               using Obstacle =
                   typename std::tuple_element_t<decltype(k)::value,
                                                 typename Type::ObstacleStorage>::value_type;
               return kEffect<Obstacle> == Effect::impact;
           });
}

template <class Type>
bool Engine<Type>::collide_balls(const Contact& contact) {
    const BallIndex i = contact.first;
    const BallIndex j = contact.second;
    BodyType& one = scene_.bodies[i];
    BodyType& other = scene_.bodies[j];
    const S travelled =
        Type::Motion::template travel<S>(one.state, math::duration<S>(one.clock, now_)) +
        Type::Motion::template travel<S>(other.state, math::duration<S>(other.clock, now_));
    advance(i);
    advance(j);
    const Vec normal = math::difference<S>(other.state.position, one.state.position);
    const bool sound =
        gap_explained(one, other, math::norm<S>(normal) - (one.radius + other.radius), travelled);

    const auto before = std::array{one.state, other.state};
    resolve_balls(one, other, normal);
    note_impact(one, before[0].velocity, kBallBall, j);
    note_impact(other, before[1].velocity, kBallBall, i);
    if constexpr (Recorder::kEvents) {
        recorder_.events.push_back(
            {now_,
             kBallBall,
             i,
             j,
             {},
             normal,
             {Recorder::remember(before[0]), Recorder::remember(before[1])},
             {Recorder::remember(one.state), Recorder::remember(other.state)}});
    }
    predict(i);
    predict(j);
    return sound;
}

template <class Type>
template <std::size_t K>
bool Engine<Type>::meet_obstacle(const Contact& contact) {
    const BallIndex i = contact.first;
    BodyType& body = scene_.bodies[i];
    advance(i);
    const auto& obstacle = std::get<K>(scene_.obstacles)[contact.second];
    using Obstacle = std::decay_t<decltype(obstacle)>;
    const Vec normal = contact_normal(body.state.position, obstacle);
    const auto before = body.state;
    if constexpr (kEffect<Obstacle> == Effect::capture) {
        body.present = false;
        broad_phase_.remove(i);
    } else if constexpr (kEffect<Obstacle> == Effect::entry) {
        Type::Motion::template enter<S>(body.state, contact.second);
        begin_motion(body);
    } else {
        resolve_cushion(body, normal);
    }
    note_impact(body, before.velocity, contact.kind, contact.second);
    if constexpr (Recorder::kEvents) {
        recorder_.events.push_back(
            {now_,
             contact.kind,
             i,
             contact.second,
             {},
             normal,
             {Recorder::remember(before), Recorder::remember(before)},
             {Recorder::remember(body.state), Recorder::remember(body.state)}});
    }
    predict(i);
    return math::is_finite<S>(math::norm1<S>(normal));
}

template <class Type>
void Engine<Type>::begin_motion(BodyType& body) {
    if constexpr (Type::Motion::kTransitions) {
        Type::Motion::template begin<S>(scene_.motion, body.state);
    }
}

/// The ball's motion enters its next phase.
template <class Type>
void Engine<Type>::change_phase(BallIndex i) {
    BodyType& body = scene_.bodies[i];
    advance(i);
    const auto before = body.state;
    Type::Motion::template transition<S>(scene_.motion, body.state);
    body.last_kind = kTransition;
    ++body.age;
    if constexpr (kHasRims<typename Type::Motion>) {
        if (body.state.fallen) {
            body.present = false;
            broad_phase_.remove(i);
        }
    }
    if constexpr (Recorder::kEvents) {
        recorder_.events.push_back(
            {now_,
             kTransition,
             i,
             0,
             {},
             Vec(S(0), S(0)),
             {Recorder::remember(before), Recorder::remember(before)},
             {Recorder::remember(body.state), Recorder::remember(body.state)}});
    }
    predict(i);
}

template <class Type>
void Engine<Type>::advance(BallIndex i) {
    BodyType& body = scene_.bodies[i];
    if (!(body.clock < now_)) return;
    end_piece(i, now_);
    Type::Motion::template advance<S>(body.state, math::duration<S>(body.clock, now_));
    body.clock = now_;
    body.noise = S(0);
}

template <class Type>
void Engine<Type>::note_impact(BodyType& body, const Vec& before, Kind kind, std::uint32_t other) {
    // Within one instant the largest noise stays: what is left of a speed after many impacts is no
    // more certain than the speed it is left of.
    body.noise =
        std::max<S>(body.noise, S(math::kVelocityNoise) * math::epsilon<S>() *
                                    (math::norm1<S>(before) + math::norm1<S>(body.state.velocity)));
    body.last_kind = kind;
    body.last_other = other;
    ++body.age;
}

template <class Type>
void Engine<Type>::end_piece(BallIndex i, const Instant& to) {
    if constexpr (Recorder::kPieces) {
        const BodyType& body = scene_.bodies[i];
        recorder_.add_piece(i, body.clock, to, body.state);
    }
}

/// Whether rounding explains the gap at a contact; an overlap may also have been in the scene.
template <class Type>
bool Engine<Type>::gap_explained(const BodyType& one, const BodyType& other, const S& gap,
                                 const S& travelled) const {
    const S reach = one.radius + other.radius;
    const S place = math::norm1<S>(one.state.position.rounded()) +
                    (math::norm1<S>(one.state.velocity) + math::norm1<S>(other.state.velocity)) *
                        math::narrow(now_);
    S bound = S(math::kContactGap) *
              (math::epsilon<S>() * (reach + travelled) + math::wide_epsilon<S>() * place);
    if constexpr (Type::Simultaneous::kGathersCluster) {
        bound = bound + together_gap<S>(math::norm1<S>(one.state.position.rounded()), reach);
    }
    return gap <= bound && gap >= -(bound + S(2 * math::kStartOverlap) * reach);
}

template <class Type>
bool Engine<Type>::all_at_rest() const {
    for (const BodyType& body : scene_.bodies) {
        if (body.present && !Type::Motion::template at_rest<S>(body.state)) return false;
    }
    return true;
}

template <class Type>
Status Engine<Type>::finish(Status status, const RunLimits<S>& limits) {
    if (status == Status::time_limit) now_ = Instant{limits.time};
    for (BallIndex i = 0; i < scene_.bodies.size(); ++i) {
        BodyType& body = scene_.bodies[i];
        if (!body.present) continue;
        advance(i);
        const Vec p = body.state.position.rounded();
        if (!math::is_finite<S>(math::norm1<S>(p)) ||
            !math::is_finite<S>(math::norm1<S>(body.state.velocity))) {
            status = Status::numeric;
        }
    }
    return status;
}

}  // namespace osculo::engine

#include "osculo/engine/archive.hpp"
#include "osculo/engine/cluster.hpp"
#include "osculo/engine/gathering.hpp"
#include "osculo/engine/prediction.hpp"
#include "osculo/engine/resolution.hpp"

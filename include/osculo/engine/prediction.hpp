#pragma once

#include "osculo/engine/engine.hpp"

// How an engine finds every ball's next event. At any time, the earliest contact of every two balls
// is known to one of them, or comes after something else that one of them does first: a ball that
// has had an event looks at all the others, but only as far as their own next events and its own.
namespace osculo::engine {

/// The next event of ball i, of its own or, if [others], with another one.
template <class Type>
void Engine<Type>::predict(BallIndex i, bool others) {
    ++prediction_count_;
    const BodyType& body = scene_.bodies[i];
    Scheduled best;
    if (body.present) {
        const Path path = Type::Motion::template path<S>(body.state);
        if constexpr (Type::BroadPhase::kCrossings) {
            offer(kCellCrossing, i, 0, 0, body.clock, broad_phase_.next_crossing(i, path), best);
        }
        if constexpr (Type::Motion::kTransitions) {
            offer(kTransition, i, 0, 0, body.clock, body.state.remaining, best);
        }
        Box swept = swept_box(body, path, best);
        if (!path.stands()) predict_obstacles(i, path, best, swept);
        if (others) {
            broad_phase_.for_each_candidate(i, [&](BallIndex j) {
                if (swept.apart(swept_[j])) return;
                if (predict_ball(i, path, j, best)) swept = swept_box(body, path, best);
            });
        }
        swept_[i] = swept;
    }
    queue_.update(i, best);
}

/// Around everything that the ball covers before [best], its next event.
template <class Type>
typename Engine<Type>::Box Engine<Type>::swept_box(const BodyType& body, const Path& path,
                                                   const Scheduled& best) {
    return motion::swept_box<S>(path, horizon(body.clock, best))
        .grown(S(body.radius * (S(1) + S(math::kRejectionSlack) * math::epsilon<S>())));
}

/// The kinds that end most paths first: what they end need not be compared with the others.
template <class Type>
void Engine<Type>::predict_obstacles(BallIndex i, const Path& path, Scheduled& best,
                                     Box& swept) const {
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        (predict_kind<K, true>(i, path, best, swept), ...);
        (predict_kind<K, false>(i, path, best, swept), ...);
    }
    (std::make_index_sequence<Type::ObstacleList::kCount>{});
}

/// Obstacles of kind K, if it is one that ends [MostPaths].
template <class Type>
template <std::size_t K, bool MostPaths>
void Engine<Type>::predict_kind(BallIndex i, const Path& path, Scheduled& best, Box& swept) const {
    const auto& obstacles = std::get<K>(scene_.obstacles);
    using Obstacle = typename std::decay_t<decltype(obstacles)>::value_type;
    static_assert(Detectable<S, Path, Obstacle>,
                  "osculo: no first_contact and contact_normal for a ball on this path "
                  "and this kind of obstacle: write them, one pair in one file of detect/");
    if constexpr (kEndsMostPaths<Obstacle> == MostPaths) {
        const BodyType& body = scene_.bodies[i];
        constexpr Kind kKind = kFirstObstacle + static_cast<Kind>(K);
        const auto look_at = [&](std::size_t k) {
            const Obstacle& obstacle = obstacles[k];
            const bool resolved = body.last_kind == kKind && body.last_other == k;
            const S latest = horizon(body.clock, best);
            if constexpr (requires {
                              detect::certainly_apart(path, body.radius, obstacle, latest);
                          }) {
                if (!resolved && detect::certainly_apart(path, body.radius, obstacle, latest))
                    return;
            }
            const S wait = first_contact(path, body.radius, obstacle,
                                         math::ContactHistory<S>{resolved, body.noise}, latest);
            if (offer(kKind, i, static_cast<std::uint32_t>(k), 0, body.clock, wait, best)) {
                swept = swept_box(body, path, best);
            }
        };
        if constexpr (ObstacleBoxesType::template kHas<K>) {
            obstacle_boxes_.template for_each_near<K>(swept, look_at);
        } else {
            for (std::size_t k = 0; k < obstacles.size(); ++k) look_at(k);
        }
    }
}

/// True if it is the ball's next event so far.
template <class Type>
bool Engine<Type>::predict_ball(BallIndex i, const Path& path, BallIndex j, Scheduled& best) const {
    const BodyType& one = scene_.bodies[i];
    const BodyType& other = scene_.bodies[j];
    if (!other.present) return false;
    const bool resolved = one.last_kind == kBallBall && one.last_other == j &&
                          other.last_kind == kBallBall && other.last_other == i;
    // Both from the later of the two clocks, so that the result depends only on the two states and
    // not on the instant or the ball that asks for it.
    const bool first_is_older = one.clock < other.clock;
    const Instant& start = first_is_older ? other.clock : one.clock;
    const S first_shift = first_is_older ? math::duration<S>(one.clock, start) : S(0);
    const S second_shift = first_is_older ? S(0) : math::duration<S>(other.clock, start);
    Path second = Type::Motion::template path<S>(other.state);
    if (path.stands() && second.stands()) return false;
    const S reach = one.radius + other.radius;
    const S latest = std::min<S>(horizon(start, best), horizon(start, queue_.next_of(j)));
    if constexpr (requires {
                      detect::certainly_apart(path, first_shift, second, second_shift, reach,
                                              latest);
                  }) {
        if (!resolved &&
            detect::certainly_apart(path, first_shift, second, second_shift, reach, latest)) {
            return false;
        }
    }
    Path first = path;
    if (first_shift > S(0)) first.shift(first_shift);
    if (second_shift > S(0)) second.shift(second_shift);
    const S wait =
        first_contact(first, second, reach,
                      math::ContactHistory<S>{resolved, S(one.noise + other.noise)}, latest);
    return offer(kBallBall, i, j, other.age, start, wait, best);
}

/// Takes the event as the ball's next one if it comes before [best].
template <class Type>
bool Engine<Type>::offer(Kind kind, BallIndex i, std::uint32_t other, std::uint32_t other_age,
                         const Instant& start, const S& wait, Scheduled& best) const {
    if (!math::is_finite<S>(wait)) return false;
    Scheduled event{math::after<S>(start, wait), kind, i, other, scene_.bodies[i].age, other_age};
    if (kind == kBallBall && other < i) {
        std::swap(event.first, event.second);
        std::swap(event.first_age, event.second_age);
    }
    if (!(event < best)) return false;
    best = event;
    return true;
}

/// Waits beyond this cannot be the next event; a little more than the distance to the best one yet.
template <class Type>
typename Engine<Type>::S Engine<Type>::horizon(const Instant& start, const Scheduled& best) {
    if (best.kind == kNothing) return math::never<S>();
    return math::duration<S>(start, best.when) * (S(1) + S(8) * math::epsilon<S>());
}

}  // namespace osculo::engine

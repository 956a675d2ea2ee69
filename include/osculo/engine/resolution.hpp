#pragma once

#include "osculo/engine/engine.hpp"

// How an engine lets impacts change its balls.
namespace osculo::engine {

template <class Type>
void Engine<Type>::resolve_balls(BodyType& one, BodyType& other, const Vec& normal) {
    if constexpr (Type::Motion::kSpin) {
        auto first = impact::spinning_ball<S>(one);
        auto second = impact::spinning_ball<S>(other);
        scene_.friction.ball_ball.resolve(normal, first, second);
        impact::take<S>(first, one);
        impact::take<S>(second, other);
    } else {
        Type::Impact::template resolve<S>(scene_.ball_ball_restitution, one.mass, other.mass,
                                          normal, one.state.velocity, other.state.velocity);
    }
    begin_motion(one);
    begin_motion(other);
    if constexpr (Type::Motion::kTransitions) {
        const Vec unit = normal / math::norm<S>(normal);
        const S missing = impact::missing_separation<S>(
            other.state.velocity - one.state.velocity,
            other.state.half_acceleration - one.state.half_acceleration, unit,
            pressing_time({&one, &other}));
        if (missing > S(0)) {
            const S total = one.mass + other.mass;
            one.state.velocity -= (missing * (other.mass / total)) * unit;
            other.state.velocity += (missing * (one.mass / total)) * unit;
            begin_motion(one);
            begin_motion(other);
        }
    }
}

/// How long what these balls do now can press them against each other or a cushion [s].
template <class Type>
typename Engine<Type>::S Engine<Type>::pressing_time(std::initializer_list<BodyType*> bodies) {
    S duration = math::never<S>();
    S hop(0);
    for (BodyType* body : bodies) {
        duration = std::min<S>(duration, impact::acceleration_time(body->state));
        hop = std::max<S>(hop, body->hops.note(now_, scene_.contact_time));
    }
    return impact::pressing_time<S>(scene_.contact_time, duration, hop);
}

template <class Type>
void Engine<Type>::resolve_cushion(BodyType& body, const Vec& normal) {
    if constexpr (Type::Motion::kSpin) {
        auto ball = impact::spinning_ball<S>(body);
        scene_.friction.ball_cushion.resolve(normal, ball);
        impact::take<S>(ball, body);
    } else {
        Type::Impact::template resolve<S>(scene_.ball_cushion_restitution, normal,
                                          body.state.velocity);
    }
    begin_motion(body);
    if constexpr (Type::Motion::kTransitions) {
        const Vec away = normal / -math::norm<S>(normal);
        const S missing = impact::missing_separation<S>(
            body.state.velocity, body.state.half_acceleration, away, pressing_time({&body}));
        if (missing > S(0)) {
            body.state.velocity += missing * away;
            begin_motion(body);
        }
    }
}

}  // namespace osculo::engine

#pragma once

#include <algorithm>
#include <optional>

#include "osculo/engine/engine.hpp"
#include "osculo/impact/symmetric/surface.hpp"

// How an engine resolves contacts of one instant together.
namespace osculo::engine {

/// Whether what has been gathered closes so slowly that nothing of it bounces.
///
/// Below some speed a bounce means nothing, but ever smaller ones may follow each other without
/// end: an inelastic row collapses in finite time (S. McNamara & W. R. Young 1992; NUMERICS 5). So
/// where every contact closes at less than rest_speed, those that are not elastic are inelastic.
/// That takes energy only, leaves momentum, and does not depend on the order of contacts.
template <class Type>
bool Engine<Type>::settles() const {
    if (!(scene_.rest_speed > S(0))) return false;
    const auto& members = cluster_.members;
    const auto velocity = [&](BallIndex ball) -> const Vec& {
        return std::find_if(members.begin(), members.end(),
                            [ball](const auto& member) { return member.ball == ball; })
            ->state.velocity;
    };
    bool bounces = false;
    for (const auto& contact : cluster_.contacts) {
        const S e = restitution_of(contact.kind);
        bounces = bounces || (e > S(0) && e < S(1));
        Vec closing = velocity(contact.first);
        if (contact.kind == kBallBall) closing -= velocity(contact.second);
        if (!(math::dot<S>(closing, contact.normal) <
              scene_.rest_speed * math::norm<S>(contact.normal))) {
            return false;
        }
    }
    return bounces;
}

template <class Type>
typename Engine<Type>::S Engine<Type>::restitution_of(Kind kind) const {
    if constexpr (Type::Motion::kSpin) {
        return kind == kBallBall ? scene_.friction.ball_ball.restitution
                                 : scene_.friction.ball_cushion.restitution;
    } else {
        return kind == kBallBall ? scene_.ball_ball_restitution : scene_.ball_cushion_restitution;
    }
}

/// The contacts and balls as the law takes them.
template <class Type>
void Engine<Type>::load_cluster(bool settling) {
    auto& law = cluster_.law;
    law.clear();
    for (const auto& member : cluster_.members) {
        const BodyType& body = scene_.bodies[member.ball];
        if constexpr (Type::Motion::kSpin) {
            law.balls.push_back({body.mass, body.radius, member.state.inertia,
                                 member.state.velocity, member.state.spin});
        } else {
            law.balls.push_back({body.mass, member.state.velocity});
        }
    }
    const auto local = [this](BallIndex i) {
        const auto found =
            std::lower_bound(cluster_.members.begin(), cluster_.members.end(), i,
                             [](const auto& member, BallIndex ball) { return member.ball < ball; });
        return static_cast<std::size_t>(found - cluster_.members.begin());
    };
    for (const auto& contact : cluster_.contacts) {
        const std::size_t one = local(contact.first);
        const bool ball = contact.kind == kBallBall;
        const std::size_t other = ball ? local(contact.second) : impact::kFixed;
        if constexpr (Type::Motion::kSpin) {
            law.contacts.push_back(impact::contact<S>(
                one, other, contact.normal,
                ball ? surface(scene_.friction.ball_ball)
                     : surface(scene_.friction.ball_cushion, scene_.bodies[contact.first].radius)));
        } else {
            law.contacts.push_back({one, other, contact.normal, restitution_of(contact.kind)});
        }
        S& e = law.contacts.back().restitution;
        if (settling && e < S(1)) e = S(0);
    }
}

/// Gives a ball what the law has made of it.
template <class Type>
void Engine<Type>::take_from_law(std::size_t m, typename Type::State& state) const {
    state.velocity = cluster_.law.balls[m].velocity;
    if constexpr (Type::Motion::kSpin) state.spin = cluster_.law.balls[m].spin;
    if constexpr (Type::Motion::kTransitions) {
        Type::Motion::template begin<S>(scene_.motion, state);
    }
}

/// The law of pressed balls (impact/pressing.hpp), for all contacts at once.
template <class Type>
void Engine<Type>::part_cluster() {
    auto& members = cluster_.members;
    const auto longest_hop = [this](BallIndex ball) {
        return scene_.bodies[ball].hops.longest(now_, scene_.contact_time);
    };
    for (std::size_t m = 0; m < members.size(); ++m) {
        members[m].after = members[m].state;
        take_from_law(m, members[m].after);
    }
    auto& least = cluster_.least;
    least.clear();
    bool pressed = false;
    for (const auto& contact : cluster_.law.contacts) {
        const auto& one = members[contact.one];
        Vec velocity = -one.after.velocity;
        Vec half_acceleration = -one.after.half_acceleration;
        S duration = impact::acceleration_time(one.after);
        S hop = longest_hop(one.ball);
        if (contact.other != impact::kFixed) {
            const auto& other = members[contact.other];
            velocity += other.after.velocity;
            half_acceleration += other.after.half_acceleration;
            duration = std::min<S>(duration, impact::acceleration_time(other.after));
            hop = std::max<S>(hop, longest_hop(other.ball));
        }
        const Vec unit = contact.normal / math::norm<S>(contact.normal);
        const S tau = impact::pressing_time<S>(scene_.contact_time, duration, hop);
        const S speed = impact::least_separation<S>(half_acceleration, unit, tau);
        least.push_back(speed > S(0) ? speed : S(0));
        pressed = pressed || math::dot<S>(velocity, unit) < least.back();
    }
    if (pressed) cluster_.solver.part(cluster_.law, [&](std::size_t k) { return least[k]; });
}

/// Whether rounding explains the gap of the contact that the cluster was found by.
template <class Type>
bool Engine<Type>::cause_explained(const Contact& cause) const {
    for (const auto& contact : cluster_.law.contacts) {
        if (!math::is_finite<S>(math::norm1<S>(contact.normal))) return false;
    }
    if (cause.kind != kBallBall) return true;
    const BodyType& one = scene_.bodies[cause.first];
    const BodyType& other = scene_.bodies[cause.second];
    const auto now = [this](BallIndex ball) {
        return std::find_if(cluster_.members.begin(), cluster_.members.end(),
                            [ball](const auto& member) { return member.ball == ball; })
            ->state.position;
    };
    const S travelled =
        Type::Motion::template travel<S>(one.state, math::duration<S>(one.clock, now_)) +
        Type::Motion::template travel<S>(other.state, math::duration<S>(other.clock, now_));
    const S distance = math::norm<S>(math::difference<S>(now(cause.second), now(cause.first)));
    return gap_explained(one, other, distance - (one.radius + other.radius), travelled);
}

/// Resolves what has been gathered. Nothing if it is the law of two things that has to act, for
/// nothing but rounding approaches; otherwise false if the gap at [cause] is more than rounding, or
/// the scalar type cannot tell what the impulses are.
template <class Type>
std::optional<bool> Engine<Type>::resolve_cluster(const Contact& cause) {
    const bool settling = settles();
    load_cluster(settling);
    auto& law = cluster_.law;
    const impact::ClusterOutcome outcome = cluster_.solver.resolve(law);
    if constexpr (Type::Motion::kTransitions) part_cluster();
    const auto acts = [](const auto& contact) { return contact.impulse > S(0); };
    std::uint64_t impacts = 0;
    for (const auto& contact : law.contacts) {
        if (!acts(contact)) continue;
        ++impacts;
        ++cluster_.members[contact.one].impacts;
        if (contact.other != impact::kFixed) ++cluster_.members[contact.other].impacts;
    }
    if (impacts == 0) return std::nullopt;
    if (settling) cluster_.settled += impacts;
    // Where rounding leaves a pair approaching, what follows would go through things.
    const bool sound = outcome.resolved() && cause_explained(cause);
    cluster_.endless = outcome.no_approach && outcome.status == impact::ClusterStatus::capped;

    for (std::size_t m = 0; m < cluster_.members.size(); ++m) {
        auto& member = cluster_.members[m];
        if (member.impacts == 0) continue;
        advance(member.ball);
        BodyType& body = scene_.bodies[member.ball];
        member.state = body.state;
        take_from_law(m, body.state);
        if constexpr (Type::Motion::kTransitions) body.hops.note(now_, scene_.contact_time);
    }
    for (std::size_t k = 0; k < law.contacts.size(); ++k) {
        const auto& contact = law.contacts[k];
        if (!acts(contact)) continue;
        const Contact& of = cluster_.contacts[k];
        const S noise = cluster_.solver.noise(k);
        const auto note = [&](std::size_t m, std::uint32_t other) {
            BodyType& body = scene_.bodies[cluster_.members[m].ball];
            note_impact(body, cluster_.members[m].state.velocity, of.kind, other);
            body.noise = std::max<S>(body.noise, noise);
        };
        note(contact.one, of.second);
        if (contact.other != impact::kFixed) note(contact.other, of.first);
    }
    if constexpr (Recorder::kEvents) record_cluster(outcome.well_posed);
    for (const auto& member : cluster_.members) {
        if (member.impacts != 0) predict(member.ball);
    }
    event_count_ += impacts - 1;  // the last one is counted as every event is
    return sound;
}

/// Writes the cluster as its contacts one after the other, each with what its impulse does. The
/// last one of a ball leaves it as all of them do together.
template <class Type>
void Engine<Type>::record_cluster(bool well_posed) {
    ++cluster_.number;
    const auto& law = cluster_.law;
    const auto push = [this](std::size_t m, const Vec& change) {
        auto& member = cluster_.members[m];
        BodyType shown = scene_.bodies[member.ball];
        if (++member.recorded < member.impacts) {
            shown.state = member.state;
            shown.state.velocity += change / shown.mass;
            begin_motion(shown);
        }
        member.state = shown.state;
    };
    for (std::size_t k = 0; k < law.contacts.size(); ++k) {
        const auto& contact = law.contacts[k];
        if (!(contact.impulse > S(0))) continue;
        const Vec n = contact.normal / math::norm<S>(contact.normal);
        Vec impulse = contact.impulse * n;
        if constexpr (Type::Motion::kSpin) {
            impulse += contact.friction_impulse.x() * Vec(-n.y(), n.x()) +
                       (contact.tilt * contact.friction_impulse.y()) * n;
        }
        const bool pair = contact.other != impact::kFixed;
        const std::size_t other = pair ? contact.other : contact.one;
        const auto before =
            std::array{cluster_.members[contact.one].state, cluster_.members[other].state};
        push(contact.one, Vec(-impulse));
        if (pair) push(other, impulse);
        const Contact& of = cluster_.contacts[k];
        recorder_.events.push_back({now_,
                                    of.kind,
                                    of.first,
                                    of.second,
                                    {cluster_.number & 0x7FFFFFFFU, well_posed},
                                    contact.normal,
                                    {Recorder::remember(before[0]), Recorder::remember(before[1])},
                                    {Recorder::remember(cluster_.members[contact.one].state),
                                     Recorder::remember(cluster_.members[other].state)}});
    }
}

}  // namespace osculo::engine

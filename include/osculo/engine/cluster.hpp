#pragma once

#include <algorithm>
#include <tuple>

#include "osculo/detect/touching.hpp"
#include "osculo/engine/engine.hpp"

// How an engine finds the contacts of one instant that belong together, and resolves them at once.
namespace osculo::engine {

/// The cluster around the contact, as things are now: every ball and cushion that touches one of
/// its balls, and what touches those. True if that is more than the contact itself.
template <class Type>
bool Engine<Type>::gather(const Contact& contact) {
    auto& found = cluster_.contacts;
    cluster_.members.clear();
    found.clear();
    found.push_back(contact);
    add_member(contact.first);
    if (contact.kind == kBallBall) add_member(contact.second);
    for (std::size_t m = 0; m < cluster_.members.size(); ++m) {
        gather_balls(m);
        [&]<std::size_t... K>(std::index_sequence<K...>) {
            (gather_obstacles<K>(m), ...);
        }
        (std::make_index_sequence<Type::ObstacleList::kCount>{});
    }
    if (found.size() == 1) return false;
    // In an order that does not depend on which contact came first.
    std::sort(found.begin(), found.end(), [](const Contact& a, const Contact& b) {
        return std::tuple(a.kind, a.first, a.second) < std::tuple(b.kind, b.first, b.second);
    });
    std::sort(cluster_.members.begin(), cluster_.members.end(),
              [](const auto& a, const auto& b) { return a.ball < b.ball; });
    return true;
}

template <class Type>
void Engine<Type>::add_member(BallIndex i) {
    const BodyType& body = scene_.bodies[i];
    typename ClusterWorkspace<Type>::Member member{i, body.state, S(0)};
    member.tolerance = math::norm1<S>(body.state.position.rounded());
    const S t = math::duration<S>(body.clock, now_);
    if (t > S(0)) Type::Motion::template advance<S>(member.state, t);
    // Positions, reaches and instants are known to their rounding: that of where it comes from and
    // of where it is.
    member.tolerance =
        S(math::kTogether) * math::epsilon<S>() *
        (member.tolerance + math::norm1<S>(member.state.position.rounded()) + body.radius);
    cluster_.members.push_back(member);
}

template <class Type>
void Engine<Type>::gather_balls(std::size_t m) {
    const BallIndex i = cluster_.members[m].ball;
    const auto is_member = [this](BallIndex j) {
        return std::find_if(cluster_.members.begin(), cluster_.members.end(),
                            [j](const auto& member) { return member.ball == j; });
    };
    const Vec here = cluster_.members[m].state.position.rounded();
    const Box near = Box::around(here, here)
                         .grown(S(scene_.bodies[i].radius + S(4) * cluster_.members[m].tolerance));
    broad_phase_.for_each_candidate(i, [&](BallIndex j) {
        const BodyType& other = scene_.bodies[j];
        if (!other.present || near.apart(swept_[j])) return;
        const auto known = is_member(j);
        const bool is_new = known == cluster_.members.end();
        // Of two members the later one has been looked at by the earlier one.
        if (!is_new && known <= cluster_.members.begin() + static_cast<std::ptrdiff_t>(m)) return;
        if (is_new) add_member(j);
        const auto& one = cluster_.members[m];
        const auto& two = is_new ? cluster_.members.back() : *known;
        const Contact& cause = cluster_.contacts.front();
        const BallIndex low = std::min(i, j), high = std::max(i, j);
        const bool is_cause = cause.kind == kBallBall && cause.first == low && cause.second == high;
        const S gap = math::norm<S>(math::difference<S>(two.state.position, one.state.position)) -
                      (scene_.bodies[i].radius + other.radius);
        if (gap <= one.tolerance + two.tolerance) {
            if (!is_cause) cluster_.contacts.push_back({kBallBall, low, high});
        } else if (is_new) {
            cluster_.members.pop_back();
        }
    });
}

template <class Type>
template <std::size_t K>
void Engine<Type>::gather_obstacles(std::size_t m) {
    using Obstacle = typename std::tuple_element_t<K, typename Type::ObstacleStorage>::value_type;
    if constexpr (kEffect<Obstacle> == Effect::impact &&
                  requires(const math::WidePoint<S>& p, const S& s, const Obstacle& obstacle) {
                      detect::touches(p, s, obstacle, s);
                  }) {
        const auto& member = cluster_.members[m];
        const S& radius = scene_.bodies[member.ball].radius;
        const Vec here = member.state.position.rounded();
        const S tolerance = S(2) * member.tolerance;
        const Box near = Box::around(here, here).grown(S(radius + S(2) * tolerance));
        constexpr Kind kKind = kFirstObstacle + static_cast<Kind>(K);
        obstacle_boxes_.template for_each_near<K>(near, [&](std::size_t k) {
            const auto& obstacle = std::get<K>(scene_.obstacles)[k];
            if (!detect::touches(member.state.position, radius, obstacle, tolerance)) return;
            const Contact& cause = cluster_.contacts.front();
            if (cause.kind == kKind && cause.first == member.ball && cause.second == k) return;
            cluster_.contacts.push_back({kKind, member.ball, static_cast<std::uint32_t>(k)});
        });
    }
}

/// The contacts and balls as the law takes them.
template <class Type>
void Engine<Type>::load_cluster() {
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
    for (const Contact& contact : cluster_.contacts) {
        typename ClusterWorkspace<Type>::LawContact in_law;
        in_law.one = local(contact.first);
        const auto& place = cluster_.members[in_law.one].state.position;
        if (contact.kind == kBallBall) {
            in_law.other = local(contact.second);
            in_law.normal =
                math::difference<S>(cluster_.members[in_law.other].state.position, place);
        } else {
            in_law.other = impact::kFixed;
            (void)visit_kind(contact.kind, [&](auto kind) {
                in_law.normal =
                    contact_normal(place, std::get<kind.value>(scene_.obstacles)[contact.second]);
                return true;
            });
        }
        const bool ball = contact.kind == kBallBall;
        if constexpr (Type::Motion::kSpin) {
            if (ball) {
                in_law.restitution = scene_.friction.ball_ball.restitution;
                in_law.friction = scene_.friction.ball_ball.friction;
            } else {
                const auto& cushion = scene_.friction.ball_cushion;
                in_law.restitution = cushion.restitution;
                in_law.friction = {cushion.friction, S(0), S(0)};
                if constexpr (requires { cushion.height; }) {
                    const S& radius = scene_.bodies[contact.first].radius;
                    in_law.tilt = (cushion.height - radius) / radius;
                }
            }
        } else {
            in_law.restitution =
                ball ? scene_.ball_ball_restitution : scene_.ball_cushion_restitution;
        }
        law.contacts.push_back(in_law);
    }
}

/// Resolves what has been gathered. False if it is the law of two things that has to act, for
/// nothing but rounding approaches.
template <class Type>
bool Engine<Type>::resolve_cluster() {
    load_cluster();
    auto& law = cluster_.law;
    const impact::ClusterOutcome outcome = cluster_.solver.resolve(law);
    const auto acts = [](const auto& contact) { return contact.impulse > S(0); };
    std::uint64_t impacts = 0;
    for (const auto& contact : law.contacts) {
        if (!acts(contact)) continue;
        ++impacts;
        ++cluster_.members[contact.one].impacts;
        if (contact.other != impact::kFixed) ++cluster_.members[contact.other].impacts;
    }
    if (impacts == 0) return false;

    for (std::size_t m = 0; m < cluster_.members.size(); ++m) {
        auto& member = cluster_.members[m];
        if (member.impacts == 0) continue;
        advance(member.ball);
        BodyType& body = scene_.bodies[member.ball];
        member.state = body.state;
        body.state.velocity = law.balls[m].velocity;
        if constexpr (Type::Motion::kSpin) body.state.spin = law.balls[m].spin;
        begin_motion(body);
    }
    for (std::size_t k = 0; k < law.contacts.size(); ++k) {
        auto& contact = law.contacts[k];
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
        BodyType& one = scene_.bodies[of.first];
        contact.impulse += contact.other == impact::kFixed
                               ? part_if_pressed(one, contact.normal)
                               : part_if_pressed(one, scene_.bodies[of.second], contact.normal);
    }
    if constexpr (Recorder::kEvents) record_cluster(outcome.well_posed);
    for (const auto& member : cluster_.members) {
        if (member.impacts != 0) predict(member.ball);
    }
    event_count_ += impacts - 1;  // the last one is counted as every event is
    return true;
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
                                    contact.normal,
                                    {Recorder::remember(before[0]), Recorder::remember(before[1])},
                                    {Recorder::remember(cluster_.members[contact.one].state),
                                     Recorder::remember(cluster_.members[other].state)},
                                    cluster_.number,
                                    well_posed});
    }
}

}  // namespace osculo::engine

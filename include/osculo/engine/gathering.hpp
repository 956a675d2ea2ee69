#pragma once

#include <algorithm>
#include <tuple>

#include "osculo/detect/touching.hpp"
#include "osculo/engine/engine.hpp"

// How an engine finds the contacts of one instant that belong together.
namespace osculo::engine {

/// The cluster around the contact, as things are now: every ball and cushion that touches one of
/// its balls, and what touches those. True if that is more than the contact itself.
template <class Type>
bool Engine<Type>::gather(const Contact& contact) {
    auto& found = cluster_.contacts;
    auto& members = cluster_.members;
    members.clear();
    found.clear();
    add_member(contact.first);
    found.push_back({contact, Vec(S(0), S(0))});
    if (contact.kind == kBallBall) {
        add_member(contact.second);
        found[0].normal = math::difference<S>(members[1].state.position, members[0].state.position);
    } else {
        (void)visit_kind(contact.kind, [&](auto kind) {
            found[0].normal = contact_normal(
                members[0].state.position, std::get<kind.value>(scene_.obstacles)[contact.second]);
            return true;
        });
    }
    for (std::size_t m = 0; m < members.size(); ++m) {
        gather_balls(m);
        [&]<std::size_t... K>(std::index_sequence<K...>) {
            (gather_obstacles<K>(m), ...);
        }
        (std::make_index_sequence<Type::ObstacleList::kCount>{});
    }
    // In an order that does not depend on which contact came first.
    std::sort(found.begin(), found.end(), [](const Contact& a, const Contact& b) {
        return std::tuple(a.kind, a.first, a.second) < std::tuple(b.kind, b.first, b.second);
    });
    std::sort(members.begin(), members.end(),
              [](const auto& a, const auto& b) { return a.ball < b.ball; });
    return found.size() > 1;
}

template <class Type>
void Engine<Type>::add_member(BallIndex i) {
    const BodyType& body = scene_.bodies[i];
    typename ClusterWorkspace<Type>::Member member{i, body.state, body.state, S(0)};
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
        const Vec apart = math::difference<S>(two.state.position, one.state.position);
        const S gap = math::norm<S>(apart) - (scene_.bodies[i].radius + other.radius);
        if (gap <= one.tolerance + two.tolerance) {
            if (!is_cause) {
                cluster_.contacts.push_back({{kBallBall, low, high}, i == low ? apart : -apart});
            }
        } else if (is_new) {
            cluster_.members.pop_back();
        }
    });
}

/// Whether the ball meets a cushion in this direction already: where segments join, or end in their
/// end points, is one contact, that of the first one. Directions that differ by theta cannot be
/// told apart if the cushion that the ball meets at one is within r theta^2 / 2 of the other.
template <class Type>
bool Engine<Type>::meets_there(std::size_t m, const Vec& normal) const {
    const auto& member = cluster_.members[m];
    const S slight = S(4) * member.tolerance / scene_.bodies[member.ball].radius;
    return std::any_of(
        cluster_.contacts.begin(), cluster_.contacts.end(), [&](const auto& contact) {
            if (contact.kind == kBallBall || contact.first != member.ball) return false;
            const Vec& n = contact.normal;
            const S sine = n.x() * normal.y() - n.y() * normal.x();
            return math::dot<S>(n, normal) > S(0) &&
                   sine * sine <= slight * math::dot<S>(n, n) * math::dot<S>(normal, normal);
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
            const Vec normal = contact_normal(member.state.position, obstacle);
            if (meets_there(m, normal)) return;
            cluster_.contacts.push_back(
                {{kKind, member.ball, static_cast<std::uint32_t>(k)}, normal});
        });
    }
}

}  // namespace osculo::engine

#pragma once

#include <cstddef>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/restitution.hpp"

namespace osculo::support {

/// Which pair comes next.
enum class Order { most_approaching, first, last };

/// The cluster pair by pair with the binary law, until no pair approaches by more than
/// [tolerance] [m/s]. Returns the number of impacts, at most [cap].
template <math::Scalar S>
int resolve_sequentially(impact::Cluster<S>& cluster, const S& tolerance,
                         Order order = Order::most_approaching, int cap = 100000) {
    const math::Vec<S> rest(S(0), S(0));
    for (int steps = 0; steps < cap; ++steps) {
        const impact::ClusterContact<S>* next = nullptr;
        S fastest(0);
        for (const auto& contact : cluster.contacts) {
            const auto& v = cluster.balls[contact.one].velocity;
            const auto& w =
                contact.other == impact::kFixed ? rest : cluster.balls[contact.other].velocity;
            const S closing = math::dot<S>(v - w, contact.normal) / math::norm<S>(contact.normal);
            if (!(closing > tolerance)) continue;
            if (order == Order::most_approaching ? closing > fastest
                                                 : next == nullptr || order == Order::last) {
                fastest = closing;
                next = &contact;
            }
        }
        if (next == nullptr) return steps;
        auto& one = cluster.balls[next->one];
        if (next->other == impact::kFixed) {
            impact::Restitution::resolve<S>(next->restitution, next->normal, one.velocity);
        } else {
            auto& other = cluster.balls[next->other];
            impact::Restitution::resolve<S>(next->restitution, one.mass, other.mass, next->normal,
                                            one.velocity, other.velocity);
        }
    }
    return cap;
}

}  // namespace osculo::support

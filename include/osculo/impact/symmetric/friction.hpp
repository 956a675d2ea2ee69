#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/symmetric/system.hpp"

namespace osculo::impact::symmetric {

/// Friction at all contacts of a cluster that have borne an impulse.
///
/// In space, with N = (c n, s) the normal tilted by theta (c = cos theta, s = sin theta), t = z x n
/// and p = (s n, -c), as in resolve_tilted_plane: the impulse J in the plane comes from P = J / c
/// along N, which also gives the ball J s / c downwards. Each contact has an impulse Q in its plane
/// (t, p), against the slip on ball 1 and along it on ball 2,
///
///     u = (v1 - v2 + (r1 w1 + r2 w2) x N).(t, p)          |Q| <= mu(|u before|) P
///
/// and all Q together make the energy (of velocities in space and spins) as small as it can be
/// within these bounds: the principle of the largest dissipation. That is Coulomb's law at every
/// contact (|Q| = mu P along the slip that remains, or no slip), it has one solution for the
/// velocities in whatever order contacts stand, and it never gains energy. Contact by contact, Q
/// takes its best value while the others are kept, until nothing changes: every step lowers the
/// energy. For one contact the first step is Frictional, CushionSimple and CushionHan2005 with its
/// min(mu P, |u| / M). Vertical velocities are dropped in the end, as there.
template <math::Scalar S>
class ClusterFriction {
public:
    /// Spins as they come, slips for the friction law after the normal impulses.
    template <class ClusterType>
    void load(const ClusterType& cluster, const System<S>& system) {
        spins_.clear();
        heights_.assign(cluster.balls.size(), S(0));
        for (const auto& ball : cluster.balls) {
            spins_.push_back({ball.spin, ball.radius, ball.inertia, ball.mass});
        }
        rubs_.clear();
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            const auto& contact = cluster.contacts[k];
            const Column<S>& place = system.contacts()[k].column;
            const S& s = contact.tilt;
            S compliance = mobility(contact.one);
            if (contact.other != kFixed) compliance += mobility(contact.other);
            rubs_.push_back({place.one, place.other, system.contacts()[k].normal, s,
                             math::square_root<S>((S(1) - s) * (S(1) + s)), S(1) / compliance, S(0),
                             S(0), math::Vec<S>(S(0), S(0))});
        }
    }

    /// The normal impulse in the plane of a contact grows.
    void press(std::size_t k, const S& impulse) {
        Rub& rub = rubs_[k];
        rub.pressure += impulse / rub.c;
        heights_[rub.one] -= rub.s / rub.c * impulse / spins_[rub.one].mass;
    }
    /// The same after friction: what keeps a ball from going on under a tilted nose is the table
    /// (resolve_tilted_plane). False if it makes no difference.
    bool press_again(std::size_t k, const S& impulse) {
        if (rubs_[k].s != S(0)) return false;
        press(k, impulse);
        return true;
    }
    template <class ClusterType>
    void choose_coefficients(const ClusterType& cluster, const System<S>& system) {
        for (std::size_t k = 0; k < rubs_.size(); ++k) {
            rubs_[k].friction = cluster.contacts[k].friction(math::norm<S>(slip(rubs_[k], system)));
        }
    }

    /// [size]: of y, spins included. False if it still changes after the last sweep.
    bool relax(System<S>& system, const S& size) {
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            S largest(0);
            for (Rub& rub : rubs_) {
                const S most = rub.friction * rub.pressure;
                if (!(most > S(0))) continue;
                math::Vec<S> impulse = rub.impulse + slip(rub, system) * rub.stiffness;
                const S strength = math::norm<S>(impulse);
                if (strength > most) impulse *= most / strength;
                const math::Vec<S> change = impulse - rub.impulse;
                rub.impulse = impulse;
                push(rub, change, system);
                const S moved = math::norm<S>(change) / math::square_root<S>(rub.stiffness);
                if (moved > largest) largest = moved;
            }
            if (!(largest > math::epsilon<S>() * size)) return true;
        }
        return false;
    }

    /// Twice the energy of the spins.
    [[nodiscard]] S turning() const {
        S sum(0);
        for (const Spin& ball : spins_) {
            sum += ball.inertia * ball.mass * ball.radius * ball.radius *
                   (ball.spin.x() * ball.spin.x() + ball.spin.y() * ball.spin.y() +
                    ball.spin.z() * ball.spin.z());
        }
        return sum;
    }
    [[nodiscard]] const math::Vec3<S>& spin(std::size_t ball) const { return spins_[ball].spin; }
    [[nodiscard]] const math::Vec<S>& impulse(std::size_t k) const { return rubs_[k].impulse; }

private:
    static constexpr int kSweeps = 1000;

    struct Spin {
        math::Vec3<S> spin;
        S radius;
        S inertia;
        S mass;
    };
    struct Rub {
        std::size_t one;
        std::size_t other;
        math::Vec<S> normal;
        S s;          // sin theta
        S c;          // cos theta
        S stiffness;  // impulse over the slip that it stops
        S pressure;   // normal impulse in space
        S friction;   // mu
        math::Vec<S> impulse;
    };

    [[nodiscard]] S mobility(std::size_t ball) const {
        return (S(1) + S(1) / spins_[ball].inertia) / spins_[ball].mass;
    }

    [[nodiscard]] math::Vec<S> slip(const Rub& rub, const System<S>& system) const {
        const math::Vec<S>& n = rub.normal;
        const math::Vec<S> t(-n.y(), n.x());
        const Spin& one = spins_[rub.one];
        math::Vec<S> v = system.balls()[rub.one].velocity;
        S up = heights_[rub.one];
        math::Vec3<S> surface = one.radius * one.spin;
        if (rub.other != kFixed) {
            v -= system.balls()[rub.other].velocity;
            up -= heights_[rub.other];
            surface += spins_[rub.other].radius * spins_[rub.other].spin;
        }
        const math::Vec<S> w(surface.x(), surface.y());
        return {math::dot<S>(t, v) + (rub.c * surface.z() - rub.s * math::dot<S>(n, w)),
                rub.s * math::dot<S>(n, v) - rub.c * up + math::dot<S>(t, w)};
    }

    void push(const Rub& rub, const math::Vec<S>& q, System<S>& system) {
        const math::Vec<S>& n = rub.normal;
        const math::Vec<S> t(-n.y(), n.x());
        const math::Vec<S> flat = q.x() * t + (rub.s * q.y()) * n;
        const S up = -rub.c * q.y();
        // N x t = (-s n, c) and N x p = t.
        const math::Vec<S> turn = q.y() * t - (rub.s * q.x()) * n;
        const math::Vec3<S> twist(turn.x(), turn.y(), rub.c * q.x());
        const auto turned = [&](Spin& ball) {
            ball.spin -= twist / (ball.inertia * ball.mass * ball.radius);
        };
        system.balls()[rub.one].velocity -= flat / spins_[rub.one].mass;
        heights_[rub.one] -= up / spins_[rub.one].mass;
        turned(spins_[rub.one]);
        if (rub.other == kFixed) return;
        system.balls()[rub.other].velocity += flat / spins_[rub.other].mass;
        heights_[rub.other] += up / spins_[rub.other].mass;
        turned(spins_[rub.other]);
    }

    std::vector<Spin> spins_;
    std::vector<S> heights_;  // vertical velocities
    std::vector<Rub> rubs_;
};

}  // namespace osculo::impact::symmetric

#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/symmetric/friction.hpp"
#include "osculo/impact/symmetric/normal_phase.hpp"

namespace osculo::impact {

/// All contacts of a cluster at once: symmetric, in whatever order they stand.
///
/// e = 1: reflections. Contacts that approach fall into groups that share balls. A group whose
/// outcome is unique (well_posed.hpp: it generates a finite group of reflections) is reflected one
/// contact at a time until none of it approaches. Any other gets its generalised reflection
/// (B. Smith, D. M. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun, "Reflections on Simultaneous
/// Impact", ACM Trans. Graph. 31, 2012): twice the impulses of its inelastic impact (Projection).
/// The latter alone would be discontinuous where the outcome is not: for a cradle hit from both
/// sides it turns on whether the weaker blow is zero or all but zero. Both keep energy and momentum
/// and only push. This is repeated while contacts approach. It ends unless the contacts cannot all
/// separate (E. Vouga et al., "All's Well That Ends Well", ACM Trans. Graph. 36, 2017), for two
/// contacts after pi / beta + 1 steps; many steps of two contacts in turn are made at once (Wedge).
/// If they cannot (between parallel walls), the impact is inelastic. A cap ends it in any case;
/// then what still approaches has been stopped, and the outcome says that it is not that of the
/// law.
///
/// e < 1: impulse by impulse, J = (1 - e) J(inelastic) + e J(reflections); what then approaches is
/// projected; if different e make that gain energy, it is drawn towards the inelastic impact until
/// it does not. e = 0 is the inelastic impact.
///
/// With spins, friction follows: ClusterFriction with the impulses accumulated at each contact.
/// Where it makes pairs approach, these are stopped, which adds to the impulses, and friction is
/// relaxed again, a few times. Against a tilted nose the cluster takes the restitution in the
/// plane, max(0, (1 + e) cos^2 theta - 1); if that and the other contacts would gain energy (the
/// nose's downward impulse is not part of the normal phase), the effect of friction is scaled down.
/// Noses with compliance or cloth friction count as plain Coulomb friction here.
///
/// For one contact: Restitution, Frictional, CushionSimple and CushionHan2005 to rounding.
/// Only + - * / sqrt. No allocation once it has seen clusters as large.
template <math::Scalar S>
class SymmetricSolver {
public:
    static constexpr const char* kName = "symmetric";
    static constexpr int kMostReflections = 10000;

    explicit SymmetricSolver(int most_reflections = kMostReflections)
        : normals_(most_reflections) {}

    /// Changes velocities, spins and the impulses of the contacts. Masses > 0, e in [0, 1].
    template <class ClusterType>
    ClusterOutcome resolve(ClusterType& cluster) {
        ClusterOutcome outcome;
        normals_.load(cluster);
        normals_.resolve(outcome);
        if constexpr (requires { cluster.balls.front().spin; }) resolve_friction(cluster, outcome);
        hand_back(cluster);
        return outcome;
    }

    /// After resolve() of the same cluster: lets its contacts part at [least](k) [m/s] at least, by
    /// normal impulses alone (impact/pressing.hpp). Changes nothing if not all of them can.
    template <class ClusterType, class Least>
    void part(ClusterType& cluster, const Least& least) {
        if (normals_.part(least)) hand_back(cluster);
    }

    /// Closing speed of a contact of the cluster just resolved that is rounding [m/s].
    [[nodiscard]] S noise(std::size_t contact) const {
        return normals_.system().most_noise(contact);
    }

private:
    template <class ClusterType>
    void hand_back(ClusterType& cluster) const {
        for (std::size_t i = 0; i < cluster.balls.size(); ++i) {
            cluster.balls[i].velocity = normals_.system().balls()[i].velocity;
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            const S impulse = normals_.impulse(k);
            // Less than nothing by rounding.
            cluster.contacts[k].impulse = impulse > S(0) ? impulse : S(0);
        }
    }

    static constexpr int kFrictionPasses = 4;

    /// Friction, with normals that it makes approach.
    template <class ClusterType>
    void resolve_friction(ClusterType& cluster, ClusterOutcome& outcome) {
        auto& system = normals_.system();
        friction_.load(cluster, system);
        for (auto& contact : cluster.contacts) contact.friction_impulse = math::Vec<S>(S(0), S(0));
        const S turning = friction_.turning();
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            friction_.press(k, normals_.impulse(k));
        }
        friction_.choose_coefficients(cluster, system);
        normals_.save_velocities(velocities_);
        before_.assign(normals_.impulses().begin(), normals_.impulses().end());
        const S size = math::square_root<S>(normals_.size() * normals_.size() + turning);
        for (int pass = 0; pass < kFrictionPasses; ++pass) {
            outcome.friction_settled = friction_.relax(system, size);
            pressed_.assign(normals_.impulses().begin(), normals_.impulses().end());
            outcome.no_approach = normals_.stop();
            bool changed = false;
            for (std::size_t k = 0; k < pressed_.size(); ++k) {
                const S more = normals_.impulses()[k] - pressed_[k];
                if (!(more > S(math::kClusterApproach) * math::epsilon<S>() * size)) continue;
                if (friction_.press_again(k, system.contacts()[k].root * more)) changed = true;
            }
            if (!changed) break;
        }
        const S share = normals_.draw_towards(velocities_, before_, turning, friction_.turning());
        for (std::size_t i = 0; i < cluster.balls.size(); ++i) {
            auto& spin = cluster.balls[i].spin;
            spin = share == S(1) ? friction_.spin(i)
                                 : math::Vec3<S>(spin + share * (friction_.spin(i) - spin));
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            cluster.contacts[k].friction_impulse = share * friction_.impulse(k);
        }
    }

    symmetric::NormalPhase<S> normals_;
    symmetric::ClusterFriction<S> friction_;
    std::vector<S> before_;                 // impulses before friction,
    std::vector<S> pressed_;                // before a pass of it
    std::vector<math::Vec<S>> velocities_;  // before friction
};

}  // namespace osculo::impact

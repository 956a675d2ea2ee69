#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/symmetric/approaching.hpp"
#include "osculo/impact/symmetric/friction.hpp"
#include "osculo/impact/symmetric/projection.hpp"
#include "osculo/impact/symmetric/system.hpp"
#include "osculo/impact/symmetric/well_posed.hpp"

namespace osculo::impact {

/// How the resolution of a cluster ended.
enum class ClusterStatus {
    separated,  ///< no pair approaches
    jammed,     ///< the contacts that bear cannot all separate: inelastic, whatever e
    capped,     ///< too many reflections: what still approached has been stopped
};

struct ClusterOutcome {
    ClusterStatus status = ClusterStatus::separated;
    int reflections = 0;           ///< generalised ones, for e > 0
    bool well_posed = true;        ///< false: another law or order gives another outcome
    bool no_approach = true;       ///< false: rounding leaves some pair approaching
    bool friction_settled = true;  ///< false: friction was ended before its last digits
};

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
/// contacts after pi / beta + 1 steps. If they cannot (between parallel walls), the impact is
/// inelastic; a cap ends it in any case, with an inelastic impact of the rest.
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
    static constexpr int kMostReflections = 10000;

    explicit SymmetricSolver(int most_reflections = kMostReflections)
        : most_reflections_(most_reflections) {}

    /// Changes velocities, spins and the impulses of the contacts. Masses > 0, e in [0, 1].
    template <class ClusterType>
    ClusterOutcome resolve(ClusterType& cluster) {
        ClusterOutcome outcome;
        system_.load(cluster);
        impulses_.assign(system_.contacts().size(), S(0));
        size_ = system_.size();
        reach_.find(system_, slight(),
                    [&](std::size_t k) { return approaching_.approaches(system_, k, least()); });
        outcome.well_posed = reach_.well_posed();
        resolve_normals(outcome);
        if constexpr (requires { cluster.balls.front().spin; }) resolve_friction(cluster, outcome);
        for (std::size_t i = 0; i < cluster.balls.size(); ++i) {
            cluster.balls[i].velocity = system_.balls()[i].velocity;
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            const S impulse = system_.contacts()[k].root * impulses_[k];
            // Less than nothing by rounding.
            cluster.contacts[k].impulse = impulse > S(0) ? impulse : S(0);
        }
        return outcome;
    }

    /// Closing speed of a contact of the cluster just resolved that is rounding [m/s].
    [[nodiscard]] S noise(std::size_t contact) const { return system_.most_noise(contact); }

private:
    using Vec = math::Vec<S>;

    static constexpr int kMostProjections = 8;
    static constexpr int kRefinements = 2;
    static constexpr int kFrictionPasses = 4;
    /// Reflections after which to ask whether they can end.
    static constexpr int kPatience = 64;

    [[nodiscard]] S least() const { return S(math::kClusterApproach) * math::epsilon<S>() * size_; }
    /// Tolerance of cosines: outcomes on both sides differ by as little.
    [[nodiscard]] static S slight() { return math::square_root<S>(math::epsilon<S>()); }

    void resolve_normals(ClusterOutcome& outcome) {
        if (!(size_ > S(0))) return;
        bool some_bounce = false;
        bool some_stick = false;
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            const S& e = system_.contacts()[k].restitution;
            if (e > S(0)) some_bounce = true;
            if (e < S(1)) some_stick = true;
        }
        save_velocities(start_);
        if (!some_stick) {
            reflect(outcome);
            outcome.no_approach = stop();
            return;
        }
        outcome.no_approach = stop();
        if (!some_bounce) return;

        // Now the reflections, from the beginning, then the blend.
        save_velocities(inelastic_);
        stopping_.swap(impulses_);
        begin_again();
        reflect(outcome);
        stop();
        restore_velocities(start_);
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            const S& e = system_.contacts()[k].restitution;
            const S x = (S(1) - e) * stopping_[k] + e * impulses_[k];
            impulses_[k] = S(0);
            push(k, x);
        }
        system_.apply();
        outcome.no_approach = stop();
        draw_towards(inelastic_, stopping_, S(0), S(0));
    }

    void begin_again() {
        restore_velocities(start_);
        impulses_.assign(system_.contacts().size(), S(0));
    }

    /// Reflections, generalised where the outcome is not unique.
    void reflect(ClusterOutcome& outcome) {
        const S noise = least();
        bool patient = true;
        while (approaching_.find(system_, noise, slight())) {
            if (patient && outcome.reflections >= kPatience) {
                patient = false;
                if (projection_.jammed(system_, [&](std::size_t k) { return reach_.has(k); })) {
                    outcome.status = ClusterStatus::jammed;
                    begin_again();
                    return;
                }
            }
            ++outcome.reflections;
            if (approaching_.has_joint()) {
                projection_.solve(system_, [&](std::size_t k) {
                    if (!approaching_.is_joint(k)) return S(-1);
                    return S(noise / system_.contacts()[k].root);
                });
                push_projected(S(2));
            }
            if (!reflect_in_turn(outcome, noise) || outcome.reflections >= most_reflections_) {
                outcome.status = ClusterStatus::capped;
                return;
            }
        }
    }
    /// One by one, for the order does not matter, until none of them approaches or it is time to
    /// ask whether that can be. False at the cap.
    bool reflect_in_turn(ClusterOutcome& outcome, const S& noise) {
        for (bool first = true;; first = false) {
            bool changed = false;
            for (const std::size_t k : approaching_.unique()) {
                if (!approaching_.approaches(system_, k, noise)) continue;
                share_out(k, system_.reflect(k));
                changed = true;
            }
            if (!changed) return true;
            if (!first && ++outcome.reflections >= most_reflections_) return false;
            if (!first && outcome.reflections % kPatience == 0) return true;
        }
    }

    /// An impulse of a contact that may be there more than once (where two segments meet): to all
    /// of them alike.
    void share_out(std::size_t k, const S& impulse) {
        const auto same = [&](std::size_t l) {
            return symmetric::product<S>(system_.contacts()[k].column,
                                         system_.contacts()[l].column) > S(1) - slight();
        };
        const auto& all = approaching_.unique();
        const S share = impulse / S(static_cast<double>(std::ranges::count_if(all, same)));
        for (const std::size_t l : all) {
            if (same(l)) impulses_[l] += share;
        }
    }

    void push_projected(const S& factor) {
        for (std::size_t k = 0; k < impulses_.size(); ++k) push(k, factor * projection_.x(k));
        system_.apply();
        for (int pass = 0; pass < kRefinements; ++pass) {
            projection_.refine(system_, factor, [&](std::size_t k, const S& x) { push(k, x); });
            system_.apply();
        }
    }
    void push(std::size_t k, const S& x) {
        impulses_[k] += x;
        system_.push(k, system_.contacts()[k].root * x);
    }

    /// The inelastic impact of all contacts: stops what approaches by more than the rounding of the
    /// two velocities. False if something still does.
    bool stop() {
        for (int pass = 0;; ++pass) {
            // A second pass is finer; a third would chase the rounding of the impulses.
            if (separated([&](std::size_t k) {
                    return pass < 2 ? system_.noise(k) : system_.most_noise(k);
                })) {
                return true;
            }
            if (pass == kMostProjections) return false;
            projection_.solve(system_, [&](std::size_t k) { return system_.noise(k); });
            push_projected(S(1));
        }
    }
    template <class Noise>
    [[nodiscard]] bool separated(const Noise& noise) const {
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            if (system_.separation(k) < -noise(k)) return false;
        }
        return true;
    }

    /// Friction, with normals that it makes approach.
    template <class ClusterType>
    void resolve_friction(ClusterType& cluster, ClusterOutcome& outcome) {
        friction_.load(cluster, system_);
        for (auto& contact : cluster.contacts) contact.friction_impulse = Vec(S(0), S(0));
        const S turning = friction_.turning();
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            friction_.press(k, system_.contacts()[k].root * impulses_[k]);
        }
        friction_.choose_coefficients(cluster, system_);
        save_velocities(inelastic_);
        stopping_.assign(impulses_.begin(), impulses_.end());
        const S size = math::square_root<S>(size_ * size_ + turning);
        for (int pass = 0; pass < kFrictionPasses; ++pass) {
            outcome.friction_settled = friction_.relax(system_, size);
            pressed_.assign(impulses_.begin(), impulses_.end());
            outcome.no_approach = stop();
            bool changed = false;
            for (std::size_t k = 0; k < impulses_.size(); ++k) {
                const S more = impulses_[k] - pressed_[k];
                if (!(more > S(math::kClusterApproach) * math::epsilon<S>() * size)) continue;
                if (friction_.press_again(k, system_.contacts()[k].root * more)) changed = true;
            }
            if (!changed) break;
        }
        const S share = draw_towards(inelastic_, stopping_, turning, friction_.turning());
        for (std::size_t i = 0; i < cluster.balls.size(); ++i) {
            auto& spin = cluster.balls[i].spin;
            spin = share == S(1) ? friction_.spin(i)
                                 : math::Vec3<S>(spin + share * (friction_.spin(i) - spin));
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            cluster.contacts[k].friction_impulse = share * friction_.impulse(k);
        }
    }

    void save_velocities(std::vector<Vec>& velocities) const {
        velocities.clear();
        for (const auto& ball : system_.balls()) velocities.push_back(ball.velocity);
    }
    void restore_velocities(const std::vector<Vec>& velocities) {
        for (std::size_t i = 0; i < velocities.size(); ++i) {
            system_.balls()[i].velocity = velocities[i];
        }
    }

    /// If there is more energy than in the beginning: the state nearest to this one, between it
    /// and another that has no more, where there is as much. Neither approaches, so nothing between
    /// them does. [turning]: what the spins have besides, twice their energy, in the other state
    /// (and in the beginning) and here. Returns the share of this state in the result.
    S draw_towards(const std::vector<Vec>& velocities, const std::vector<S>& impulses,
                   const S& turning_there, const S& turning_here) {
        const S size = system_.size();
        const S allowed = size_ * size_ + turning_there;
        const S have = size * size + turning_here;
        if (!(have > allowed * (S(1) + S(math::kClusterGain) * math::epsilon<S>()))) return S(1);
        const S there_size = system_.size([&](std::size_t i) { return velocities[i]; });
        const S there = there_size * there_size + turning_there;
        // The energy is convex along the line: below the chord.
        S share = (allowed - there) / (have - there);
        if (!(share > S(0))) share = S(0);
        for (std::size_t i = 0; i < velocities.size(); ++i) {
            Vec& v = system_.balls()[i].velocity;
            v = velocities[i] + share * (v - velocities[i]);
        }
        for (std::size_t k = 0; k < impulses.size(); ++k) {
            impulses_[k] = impulses[k] + share * (impulses_[k] - impulses[k]);
        }
        return share;
    }
    int most_reflections_;
    symmetric::System<S> system_;
    symmetric::Projection<S> projection_;
    symmetric::Reach<S> reach_;
    symmetric::Approaching<S> approaching_;
    symmetric::ClusterFriction<S> friction_;
    S size_{0};                   // |y| in the beginning
    std::vector<S> impulses_;     // accumulated, in units of sqrt(m)
    std::vector<S> stopping_;     // of the inelastic impact, or before friction
    std::vector<S> pressed_;      // before a pass of friction
    std::vector<Vec> start_;      // velocities in the beginning,
    std::vector<Vec> inelastic_;  // after the inelastic impact, or before friction
};

}  // namespace osculo::impact

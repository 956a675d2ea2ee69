#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/symmetric/friction.hpp"
#include "osculo/impact/symmetric/projection.hpp"
#include "osculo/impact/symmetric/system.hpp"
#include "osculo/impact/symmetric/well_posed.hpp"

namespace osculo::impact {

/// How the resolution of a cluster ended.
enum class ClusterStatus {
    separated,  ///< no pair approaches
    jammed,     ///< the contacts cannot all separate: what still approached lost its approach
    capped,     ///< too many reflections: the same
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
/// e = 1: generalised reflections (B. Smith, D. M. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun,
/// "Reflections on Simultaneous Impact", ACM Trans. Graph. 31, 2012): while contacts approach,
/// twice the impulses of their inelastic impact (Projection) are applied. Energy and momentum are
/// kept, impulses push. That ends unless the contacts cannot all separate (E. Vouga et al., "All's
/// Well That Ends Well", ACM Trans. Graph. 36, 2017), for two contacts after at most pi / beta + 1
/// steps (beta: well_posed.hpp); a cap ends it in any case, with an inelastic impact of the rest.
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
        resolve_normals(outcome);
        outcome.well_posed = symmetric::cluster_is_well_posed<S>(
            system_, [&](std::size_t k) { return impulses_[k]; }, least(), slight());
        if constexpr (requires { cluster.balls.front().spin; }) resolve_friction(cluster, outcome);
        for (std::size_t i = 0; i < cluster.balls.size(); ++i) {
            cluster.balls[i].velocity = system_.balls()[i].velocity;
        }
        for (std::size_t k = 0; k < cluster.contacts.size(); ++k) {
            cluster.contacts[k].impulse = system_.contacts()[k].root * impulses_[k];
        }
        return outcome;
    }

private:
    using Vec = math::Vec<S>;

    /// What separates approach from rounding, in units of epsilon |y|: reflections and projections
    /// leave some 10. Stopping a pair that approaches by so little takes the square of it from the
    /// energy, nothing.
    static constexpr int kApproach = 256;
    static constexpr int kMostProjections = 8;
    static constexpr int kFrictionPasses = 4;
    /// Reflections after which to ask whether they can end.
    static constexpr int kPatience = 64;
    /// A gain of energy that is not rounding, in units of epsilon.
    static constexpr int kGain = 8;

    [[nodiscard]] S least() const { return S(kApproach) * math::epsilon<S>() * size_; }
    /// Tolerance of cosines: outcomes on both sides differ by as little.
    [[nodiscard]] static S slight() { return math::square_root<S>(math::epsilon<S>()); }

    void resolve_normals(ClusterOutcome& outcome) {
        if (!(size_ > S(0))) return;
        bool some_bounce = false;
        bool some_stick = false;
        for (const auto& contact : system_.contacts()) {
            if (contact.restitution > S(0)) some_bounce = true;
            if (contact.restitution < S(1)) some_stick = true;
        }
        if (!some_stick) {
            reflect(outcome);
            outcome.no_approach = stop();
            return;
        }
        save_velocities(start_);
        project(least());
        outcome.no_approach = stop();
        if (!some_bounce) return;

        // Now the reflections, from the beginning, then the blend.
        save_velocities(inelastic_);
        stopping_.swap(impulses_);
        impulses_.assign(stopping_.size(), S(0));
        restore_velocities(start_);
        reflect(outcome);
        stop();
        restore_velocities(start_);
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            const S& e = system_.contacts()[k].restitution;
            impulses_[k] = (S(1) - e) * stopping_[k] + e * impulses_[k];
            system_.push(k, system_.contacts()[k].root * impulses_[k]);
        }
        system_.apply();
        outcome.no_approach = stop();
        draw_towards(inelastic_, stopping_, S(0), S(0));
    }

    /// Generalised reflections.
    void reflect(ClusterOutcome& outcome) {
        const S noise = least();
        for (int step = 0; step < most_reflections_; ++step) {
            std::size_t count = 0;
            std::size_t last = 0;
            for (std::size_t k = 0; k < impulses_.size(); ++k) {
                if (!approaches(k, noise)) continue;
                ++count;
                last = k;
            }
            if (count == 0) return;
            if (step == kPatience && projection_.jammed(system_)) {
                outcome.status = ClusterStatus::jammed;
                return;
            }
            if (count == 1) {
                impulses_[last] += system_.reflect(last);
            } else {
                projection_.solve(system_, [&](std::size_t k) {
                    return approaches(k, noise) ? S(noise / system_.contacts()[k].root) : S(-1);
                });
                push_projected(S(2));
            }
            ++outcome.reflections;
        }
        outcome.status = ClusterStatus::capped;
    }
    [[nodiscard]] bool approaches(std::size_t k, const S& noise) const {
        return system_.contacts()[k].root * system_.separation(k) < -noise;
    }

    /// The inelastic impact of all contacts.
    void project(const S& noise) {
        projection_.solve(system_,
                          [&](std::size_t k) { return S(noise / system_.contacts()[k].root); });
        push_projected(S(1));
    }
    void push_projected(const S& factor) {
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            const S x = factor * projection_.x(k);
            if (!(x > S(0))) continue;
            impulses_[k] += x;
            system_.push(k, system_.contacts()[k].root * x);
        }
        system_.apply();
    }

    /// Stops inelastically what approaches by more than the rounding of the two velocities. False
    /// if something still does.
    bool stop() {
        for (int pass = 0;; ++pass) {
            bool approach = false;
            for (std::size_t k = 0; k < impulses_.size() && !approach; ++k) {
                approach = system_.separation(k) < -system_.noise(k);
            }
            if (!approach) return true;
            if (pass == kMostProjections) return false;
            projection_.solve(system_, [&](std::size_t k) { return system_.noise(k); });
            push_projected(S(1));
        }
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
                if (!(more > S(0))) continue;
                friction_.press(k, system_.contacts()[k].root * more);
                changed = true;
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
        if (!(have > allowed * (S(1) + S(kGain) * math::epsilon<S>()))) return S(1);
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
    symmetric::ClusterFriction<S> friction_;
    S size_{0};                   // |y| in the beginning
    std::vector<S> impulses_;     // accumulated, in units of sqrt(m)
    std::vector<S> stopping_;     // of the inelastic impact, or before friction
    std::vector<S> pressed_;      // before a pass of friction
    std::vector<Vec> start_;      // velocities in the beginning,
    std::vector<Vec> inelastic_;  // after the inelastic impact, or before friction
};

}  // namespace osculo::impact

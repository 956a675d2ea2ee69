#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/approaching.hpp"
#include "osculo/impact/symmetric/projection.hpp"
#include "osculo/impact/symmetric/system.hpp"
#include "osculo/impact/symmetric/wedge.hpp"
#include "osculo/impact/symmetric/well_posed.hpp"

namespace osculo::impact {

/// How the resolution of a cluster ended.
enum class ClusterStatus {
    separated,   ///< no pair approaches
    jammed,      ///< the contacts that bear cannot all separate: inelastic, whatever e
    capped,      ///< too many reflections: what still approached has been stopped
    unresolved,  ///< the same, for rounding hides that it approaches
};

struct ClusterOutcome {
    ClusterStatus status = ClusterStatus::separated;
    int reflections = 0;           ///< for e > 0; those of a wedge made at once count as one
    bool well_posed = true;        ///< false: another law or order gives another outcome
    bool no_approach = true;       ///< false: rounding leaves some pair approaching
    bool friction_settled = true;  ///< false: friction was ended before its last digits

    /// Whether the velocities are those of the law.
    [[nodiscard]] bool resolved() const {
        return no_approach &&
               (status == ClusterStatus::separated || status == ClusterStatus::jammed);
    }
};

namespace symmetric {

/// The normal impulses of a cluster, as SymmetricSolver has it: reflections, inelastic impact and
/// their blend.
template <math::Scalar S>
class NormalPhase {
public:
    using Vec = math::Vec<S>;

    explicit NormalPhase(int most_reflections) : most_reflections_(most_reflections) {}

    template <class ClusterType>
    void load(const ClusterType& cluster) {
        system_.load(cluster);
        impulses_.assign(system_.contacts().size(), S(0));
        size_ = system_.size();
    }

    [[nodiscard]] System<S>& system() { return system_; }
    [[nodiscard]] const System<S>& system() const { return system_; }
    /// |y| in the beginning.
    [[nodiscard]] const S& size() const { return size_; }
    /// Accumulated, in units of sqrt(m).
    [[nodiscard]] const std::vector<S>& impulses() const { return impulses_; }
    /// Of a contact, in the plane.
    [[nodiscard]] S impulse(std::size_t k) const {
        return system_.contacts()[k].root * impulses_[k];
    }

    void resolve(ClusterOutcome& outcome) {
        reach_.find(system_, slight(),
                    [&](std::size_t k) { return approaching_.approaches(system_, k, least()); });
        outcome.well_posed = reach_.well_posed();
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
            outcome.no_approach = reflect_all(outcome);
            return;
        }
        outcome.no_approach = stop();
        if (!some_bounce) return;

        // Now the reflections, from the beginning, then the blend.
        save_velocities(inelastic_);
        stopping_.swap(impulses_);
        begin_again();
        reflect_all(outcome);
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
    /// Lets contacts part at [least](k) at least [m/s], by impulses that take as little as possible
    /// of the energy of what they change. False, and nothing is changed, if not all of them can.
    template <class Least>
    bool part(const Least& least) {
        save_velocities(start_);
        stopping_ = impulses_;
        for (std::size_t k = 0; k < impulses_.size(); ++k) system_.demand(k, least(k));
        const bool possible = stop();
        for (std::size_t k = 0; k < impulses_.size(); ++k) system_.demand(k, S(0));
        if (!possible) {
            restore_velocities(start_);
            impulses_ = stopping_;
        }
        return possible;
    }
    void save_velocities(std::vector<Vec>& velocities) const {
        velocities.clear();
        for (const auto& ball : system_.balls()) velocities.push_back(ball.velocity);
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

private:
    static constexpr int kMostProjections = 8;
    static constexpr int kRefinements = 2;
    /// Reflections after which to ask whether they can end.
    static constexpr int kPatience = 64;

    [[nodiscard]] S least() const { return S(math::kClusterApproach) * math::epsilon<S>() * size_; }
    /// Tolerance of cosines: outcomes on both sides differ by as little.
    [[nodiscard]] static S slight() { return math::square_root<S>(math::epsilon<S>()); }

    void begin_again() {
        restore_velocities(start_);
        impulses_.assign(system_.contacts().size(), S(0));
    }

    /// Reflections, and a stop of what they leave. False if something still approaches.
    bool reflect_all(ClusterOutcome& outcome) {
        reflect(outcome);
        const bool separated = stop();
        // Stopping what is next to nothing takes next to nothing, but not where that stands for
        // all there is: a ball 1e27 times as heavy as one that cannot yield.
        const S kept = system_.size() / size_;
        if (outcome.status == ClusterStatus::separated &&
            !(kept * kept > S(1) - S(math::kClusterEnergy) * math::epsilon<S>())) {
            outcome.status = ClusterStatus::unresolved;
        }
        return separated;
    }

    /// Reflections, generalised where the outcome is not unique.
    void reflect(ClusterOutcome& outcome) {
        const S noise = least();
        bool patient = true;
        while (approaching_.find(system_, noise, slight())) {
            if (outcome.reflections >= most_reflections_) {
                outcome.status = ClusterStatus::capped;
                return;
            }
            if (patient && outcome.reflections >= kPatience) {
                patient = false;
                if (projection_.jammed(system_, [&](std::size_t k) { return reach_.has(k); })) {
                    outcome.status = ClusterStatus::jammed;
                    begin_again();
                    return;
                }
            }
            ++outcome.reflections;
            if (!patient && reflect_wedge(noise)) continue;
            if (approaching_.has_joint()) reflect_jointly(noise);
            reflect_in_turn(outcome, noise);
        }
    }
    /// The generalised reflection, twice the inelastic impact.
    void reflect_jointly(const S& noise) {
        save_velocities(turning_);
        shares_ = impulses_;
        projection_.solve(system_, [&](std::size_t k) {
            if (!approaching_.is_joint(k)) return S(-1);
            return S(noise / system_.contacts()[k].root);
        });
        push_projected(S(2));
        keep_energy();
    }
    /// One contact approaches, and no other one will but a second one, then the first one again,
    /// and so on: as many of these reflections as there can be. False if it is not so.
    bool reflect_wedge(const S& noise) {
        if (approaching_.has_joint() || approaching_.unique().size() != 1) return false;
        const auto& contacts = system_.contacts();
        const std::size_t one = approaching_.unique().front();
        const auto closing = [&](std::size_t k) {
            return S(contacts[k].root * system_.separation(k));
        };
        const auto with = [&](std::size_t k, std::size_t l) {
            return product<S>(contacts[k].column, contacts[l].column);
        };
        const S start = closing(one);
        const auto next = [&](std::size_t k) {
            return k != one && closing(k) - S(2) * start * with(k, one) < -noise;
        };
        std::size_t other = 0;
        while (other < contacts.size() && !next(other)) ++other;
        if (other == contacts.size()) return false;
        const S versine = symmetric::versine<S>(contacts[one].column, contacts[other].column);
        if (!(versine > S(0) && versine < S(1))) return false;
        // The impulses only grow, so a contact that is still apart has been all the time.
        const auto stays = [&](std::size_t k, const S& first, const S& second) {
            const auto push = [](const S& a, const S& x) { return a < S(0) ? S(a * x) : S(0); };
            return closing(k) + push(with(k, one), first) + push(with(k, other), second) >= -noise;
        };
        const auto impulses = wedge_.reflections(
            start, closing(other), versine, [&](const S& first, const S& second) {
                for (std::size_t k = 0; k < contacts.size(); ++k) {
                    if (k != one && k != other && !stays(k, first, second)) return false;
                }
                return true;
            });
        if (!(impulses.first > S(0))) return false;
        save_velocities(turning_);
        shares_ = impulses_;
        push(one, impulses.first);
        push(other, impulses.second);
        system_.apply();
        keep_energy();
        return true;
    }
    /// After a reflection by d: it is perpendicular to y + d / 2, so that energy is kept. But where
    /// impulses cancel (of a ball between two points that are opposite but for an angle), their
    /// rounding makes d err by epsilon over that angle: then it is made as long as keeps the
    /// energy, f d with f = 1 - 2 (y + d / 2).d / d^2.
    void keep_energy() {
        auto& balls = system_.balls();
        const S far = system_.size([&](std::size_t i) { return balls[i].velocity - turning_[i]; });
        if (!(far > S(0))) return;
        S along(0);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const S root = balls[i].root / far;
            const Vec middle = (turning_[i] + balls[i].velocity) / S(2);
            along += math::dot<S>(root * (balls[i].velocity - turning_[i]), root * middle);
        }
        const S share = system_.size() / far;
        const S rounding = S(math::kClusterGain) * math::epsilon<S>() * share * share;
        if (!(math::abs<S>(along) > rounding)) return;
        const S factor = S(1) - S(2) * along;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            Vec& v = balls[i].velocity;
            v = turning_[i] + factor * (v - turning_[i]);
        }
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            impulses_[k] = shares_[k] + factor * (impulses_[k] - shares_[k]);
        }
    }
    /// One by one, for the order does not matter, until none of them approaches or it is time to
    /// ask whether that can be, or at the cap.
    void reflect_in_turn(ClusterOutcome& outcome, const S& noise) {
        for (bool first = true;; first = false) {
            bool changed = false;
            for (const std::size_t k : approaching_.unique()) {
                if (!approaching_.approaches(system_, k, noise)) continue;
                share_out(k, system_.reflect(k));
                changed = true;
            }
            if (!changed) return;
            if (first) continue;
            ++outcome.reflections;
            if (outcome.reflections >= most_reflections_) return;
            if (outcome.reflections % kPatience == 0) return;
        }
    }

    /// An impulse of a contact that may be there more than once (where two segments meet): to all
    /// of them alike.
    void share_out(std::size_t k, const S& impulse) {
        const auto same = [&](std::size_t l) {
            const Column<S>& a = system_.contacts()[k].column;
            const Column<S>& b = system_.contacts()[l].column;
            return a.one == b.one && a.other == b.other && product<S>(a, b) > S(1) - slight();
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
            // What is next to nothing may be refined to less: contacts do not pull.
            projection_.refine(system_, factor, [&](std::size_t k, const S& x) {
                push(k, impulses_[k] + x < S(0) ? S(-impulses_[k]) : x);
            });
            system_.apply();
        }
    }
    void push(std::size_t k, const S& x) {
        impulses_[k] += x;
        system_.push(k, system_.contacts()[k].root * x);
    }

    template <class Noise>
    [[nodiscard]] bool separated(const Noise& noise) const {
        for (std::size_t k = 0; k < impulses_.size(); ++k) {
            if (system_.separation(k) < -noise(k)) return false;
        }
        return true;
    }

    void restore_velocities(const std::vector<Vec>& velocities) {
        for (std::size_t i = 0; i < velocities.size(); ++i) {
            system_.balls()[i].velocity = velocities[i];
        }
    }

    int most_reflections_;
    System<S> system_;
    Projection<S> projection_;
    Wedge<S> wedge_;
    Reach<S> reach_;
    Approaching<S> approaching_;
    S size_{0};
    std::vector<S> impulses_;
    std::vector<S> stopping_;     // of the inelastic impact
    std::vector<S> shares_;       // before a generalised reflection
    std::vector<Vec> start_;      // velocities in the beginning,
    std::vector<Vec> turning_;    // before a generalised reflection,
    std::vector<Vec> inelastic_;  // after the inelastic impact
};

}  // namespace symmetric
}  // namespace osculo::impact

#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/system.hpp"

namespace osculo::impact::symmetric {

/// Whether what comes out of a double impact depends continuously on what goes in (after A. P.
/// Ivanov; NUMERICS 4.1): the velocities at which neither of two contacts approaches form a wedge
/// of the angle beta, cos beta = -a1.a2 in the metric of the masses, and beta has to be pi / n, n a
/// whole number for e = 1 and 2 otherwise. For other angles the outcome depends on which contact
/// was first, by however little: every answer is a model.
///
/// [cosine] of beta; at most [tolerance] from that of pi / n. Angles below pi / 64 do not count.
template <math::Scalar S>
[[nodiscard]] bool wedge_is_well_posed(const S& cosine, bool elastic, const S& tolerance) {
    const S sine_squared = (S(1) - cosine) * (S(1) + cosine);
    if (cosine < S(0) && sine_squared <= S(2) * tolerance) return true;  // the same contact twice
    // sin^2(pi / 64) = 0.00241: below it lies what is left of parallel walls.
    if (cosine > S(0) && sine_squared < S(0.0024)) return false;
    if (!elastic) return math::abs<S>(cosine) <= tolerance;
    // U_(n-1)(cos beta) = sin(n beta) / sin beta by Chebyshev's recursion: positive up to
    // n = pi / beta, and there its slope is n / sin^2 beta.
    S before(1);
    S now = S(2) * cosine;
    for (int n = 2; n <= 64; ++n) {
        if (math::abs<S>(now) * sine_squared <= S(n) * tolerance) return true;
        if (!(now > S(0))) return false;
        const S next = S(2) * cosine * now - before;
        before = now;
        now = next;
    }
    return false;
}

/// a1.a2 of two contacts of a cluster; 0 without a common ball.
template <math::Scalar S>
[[nodiscard]] S product(const Column<S>& a, const Column<S>& b) {
    S sum(0);
    for (const std::size_t ball : {a.one, a.other}) {
        if (ball == kFixed) continue;
        const math::Vec<S>& here = ball == a.one ? a.at_one : a.at_other;
        if (ball == b.one) sum += math::dot<S>(here, b.at_one);
        if (ball == b.other) sum += math::dot<S>(here, b.at_other);
    }
    return sum;
}

/// The contacts of a cluster that can come to bear: those that approach at first and, as a blow at
/// one contact makes another approach if a1.a2 < 0, those that can be reached from there.
template <math::Scalar S>
class Reach {
public:
    /// [approaches](k): at first. [tolerance]: of cosines.
    template <class Approaches>
    void find(const System<S>& system, const S& tolerance, const Approaches& approaches) {
        const auto& contacts = system.contacts();
        all_.clear();
        has_.assign(contacts.size(), false);
        well_posed_ = true;
        const auto add = [&](std::size_t k) {
            all_.push_back(k);
            has_[k] = true;
        };
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (approaches(k)) add(k);
        }
        for (std::size_t next = 0; next < all_.size(); ++next) {
            const auto& one = contacts[all_[next]];
            for (std::size_t k = 0; k < contacts.size(); ++k) {
                if (k == all_[next]) continue;
                const auto& other = contacts[k];
                const S cosine = -product<S>(one.column, other.column);
                if (!has_[k] && cosine > tolerance) add(k);
                if (!has_[k] || !well_posed_) continue;
                const bool elastic = one.restitution == S(1) && other.restitution == S(1);
                well_posed_ = wedge_is_well_posed<S>(cosine, elastic, tolerance);
            }
        }
    }

    [[nodiscard]] bool has(std::size_t k) const { return has_[k]; }
    /// Whether every two of them are. Then every order of impacts pair by pair ends in the same
    /// velocities, for they generate a finite group of reflections and the velocities at which none
    /// approaches are one of its chambers.
    [[nodiscard]] bool well_posed() const { return well_posed_; }

private:
    std::vector<std::size_t> all_;
    std::vector<bool> has_;
    bool well_posed_ = true;
};

}  // namespace osculo::impact::symmetric

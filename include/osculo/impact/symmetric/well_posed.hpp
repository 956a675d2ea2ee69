#pragma once

#include <algorithm>
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

/// The same of all contacts that can come to bear: those that approach at first and, as a blow at
/// one contact makes another approach if a1.a2 < 0, those that can be reached from there. If every
/// two of them are well posed, every order of impacts pair by pair ends in the same velocities, for
/// they generate a finite group of reflections and the velocities at which none approaches are one
/// of its chambers. [reached] comes with the contacts that approach at first.
template <math::Scalar S>
[[nodiscard]] bool cluster_is_well_posed(const System<S>& system, const S& tolerance,
                                         std::vector<std::size_t>& reached) {
    const auto& contacts = system.contacts();
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const auto& one = contacts[reached[next]];
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const auto& other = contacts[k];
            if (k == reached[next]) continue;
            const S cosine = -product<S>(one.column, other.column);
            if (std::find(reached.begin(), reached.end(), k) == reached.end()) {
                if (!(cosine > tolerance)) continue;
                reached.push_back(k);
            }
            const bool elastic = one.restitution == S(1) && other.restitution == S(1);
            if (!wedge_is_well_posed<S>(cosine, elastic, tolerance)) return false;
        }
    }
    return true;
}

}  // namespace osculo::impact::symmetric

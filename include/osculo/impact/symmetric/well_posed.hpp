#pragma once

#include <cstddef>

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

/// The same of every two contacts that share a ball and have both borne an impulse > least (in
/// units of sqrt(m), by x(k)). Contacts without a common ball are at right angles.
template <math::Scalar S, class Impulse>
[[nodiscard]] bool cluster_is_well_posed(const System<S>& system, const Impulse& x, const S& least,
                                         const S& tolerance) {
    const auto& contacts = system.contacts();
    const auto at = [](const Column<S>& column, std::size_t ball) -> const math::Vec<S>* {
        if (column.one == ball) return &column.at_one;
        return column.other == ball ? &column.at_other : nullptr;
    };
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (!(x(k) > least)) continue;
        for (std::size_t l = 0; l < k; ++l) {
            if (!(x(l) > least)) continue;
            const Column<S>& a = contacts[k].column;
            const Column<S>& b = contacts[l].column;
            S product(0);
            bool shared = false;
            for (const std::size_t ball : {a.one, a.other}) {
                if (ball == kFixed) continue;
                if (const math::Vec<S>* there = at(b, ball)) {
                    product += math::dot<S>(*at(a, ball), *there);
                    shared = true;
                }
            }
            if (!shared) continue;
            const bool elastic = contacts[k].restitution == S(1) && contacts[l].restitution == S(1);
            if (!wedge_is_well_posed<S>(-product, elastic, tolerance)) return false;
        }
    }
    return true;
}

}  // namespace osculo::impact::symmetric

#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::impact {

/// Frictionless impact with restitution e in [0, 1] (PHYSICS 4; e = 1 is the law of Ko & Bang 1.1,
/// 1.2): the relative normal velocity u becomes -e u, everything else is kept.
struct Restitution {
    static constexpr const char* kName = "restitution";

    /// Two balls of mass m1, m2 [kg]; [normal] along the line of centres, any length > 0.
    ///
    /// J = (1 + e) m1 m2 / (m1 + m2) (v1 - v2).n. Momentum and energy (e = 1) are kept to rounding
    /// of the velocities: the quotient (v1 - v2).n / n.n is rounded once.
    template <math::Scalar S>
    static void resolve(const S& e, const S& m1, const S& m2, const math::Vec<S>& normal,
                        math::Vec<S>& v1, math::Vec<S>& v2) {
        const math::Vec<S> relative = v1 - v2;
        const S factor = (S(1) + e) * normal_component(relative, normal);
        // Each share m / (m1 + m2) is applied with one rounding: stored, the two shares would not
        // add up to 1, which acts like a restitution above or below e at every impact.
        const math::Wide<S> total = math::wide_sum<S>(m1, m2);
        v1 -= math::quotient(math::wide_product<S>(factor, m2), total) * normal;
        v2 += math::quotient(math::wide_product<S>(factor, m1), total) * normal;
    }

    /// A ball and something that does not move.
    template <math::Scalar S>
    static void resolve(const S& e, const math::Vec<S>& normal, math::Vec<S>& v) {
        v -= ((S(1) + e) * normal_component(v, normal)) * normal;
    }

private:
    /// v.n / n.n, rounded once: a bias of its rounding would gain or lose energy at every bounce
    /// off the same cushion.
    template <math::Scalar S>
    static S normal_component(const math::Vec<S>& v, const math::Vec<S>& n) {
        return math::quotient(math::wide_dot<S>(v, n), math::wide_dot<S>(n, n));
    }
};

}  // namespace osculo::impact

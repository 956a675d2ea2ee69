#pragma once

#include "osculo/impact/friction.hpp"
#include "osculo/impact/restitution.hpp"
#include "osculo/impact/spinning_ball.hpp"
#include "osculo/math/wide.hpp"

namespace osculo::impact {

/// Two balls with restitution and friction (PHYSICS 4, NUMERICS 7.2; D. Alciatore, TP A.14, there
/// for equal spheres and one ball at rest).
///
/// With n from ball 1 to ball 2, W = r1 w1 + r2 w2 and m the reduced mass:
///
///     Jn = (1 + e) m (v1 - v2).n                                       along n, as Restitution
///     u  = (v1 - v2 + W x n) without its n part                        slip, in space
///     Jt = min(mu(|u|) Jn, |u| / M)    against u on ball 1, along u on ball 2
///     M  = (1 + 1/k1) / m1 + (1 + 1/k2) / m2                           Jt = |u| / M stops the slip
///     w_i gains (n x Jt_1) / (k_i m_i r_i), the same direction for both
///
/// The slip keeps its direction while it lasts, so the smaller of the two impulses is exact for
/// Coulomb's law. The vertical part of Jt changes the spins; the vertical velocities it would give
/// are dropped, for the table keeps the balls down. That takes m1 m2 / (m1 + m2) times the square
/// of the difference of those velocities / 2 or more out of the energy and nothing out of the
/// momentum in the plane and the angular momentum about the vertical.
///
/// Error: velocities as Restitution plus 12 epsilon of Jt / m_i, spins 12 epsilon of the change,
/// both besides the error of the slip, 4 epsilon (|v1| + |v2| + |W|). Exchanging the balls (and
/// turning n round) or mirroring the scene at an axis exchanges or mirrors the bits of the result.
template <math::Scalar S>
struct Frictional {
    static constexpr const char* kName = "frictional";

    S restitution;         ///< e in [0, 1]
    Friction<S> friction;  ///< mu

    /// [normal]: from one to other, any length > 0. Masses, radii and inertia ratios > 0. Without
    /// approach there is no friction.
    void resolve(const math::Vec<S>& normal, SpinningBall<S>& one, SpinningBall<S>& other) const {
        const math::Vec<S> n = normal / math::norm<S>(normal);
        const math::Vec<S> relative = one.velocity - other.velocity;
        const math::Vec3<S> surface = one.radius * one.spin + other.radius * other.spin;
        const S approach = math::dot<S>(relative, n);
        Restitution::resolve<S>(restitution, one.mass, other.mass, normal, one.velocity,
                                other.velocity);

        // Along t = z x n and along z.
        const math::Vec<S> slip(math::cross<S>(n, relative) + surface.z(),
                                surface.x() * n.y() - surface.y() * n.x());
        const S speed = math::norm<S>(slip);
        if (!(speed > S(0)) || !(approach > S(0))) return;

        // Impulses over the reduced mass; each ball's share of it is the other's part of the mass.
        const math::Wide<S> total = math::wide_sum<S>(one.mass, other.mass);
        const S share_one = math::quotient(math::Wide<S>(other.mass), total);
        const S share_other = math::quotient(math::Wide<S>(one.mass), total);
        const S compliance =
            share_one * (S(1) + S(1) / one.inertia) + share_other * (S(1) + S(1) / other.inertia);
        const S sliding = friction(speed) * ((S(1) + restitution) * approach);
        const S sticking = speed / compliance;
        const S strength = sliding < sticking ? sliding : sticking;
        const math::Vec<S> impulse = slip * (strength / speed);

        const math::Vec<S> t(-n.y(), n.x());
        // As in Restitution: one rounding for each share of the impulse.
        one.velocity -= math::quotient(math::wide_product<S>(impulse.x(), other.mass), total) * t;
        other.velocity += math::quotient(math::wide_product<S>(impulse.x(), one.mass), total) * t;
        // n x (t, z parts) = (z, -t).
        const math::Vec3<S> twist(-impulse.y() * t.x(), -impulse.y() * t.y(), impulse.x());
        one.spin -= (share_one / (one.inertia * one.radius)) * twist;
        other.spin -= (share_other / (other.inertia * other.radius)) * twist;
    }
};

}  // namespace osculo::impact

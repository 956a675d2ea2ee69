#pragma once

#include <type_traits>

#include "osculo/impact/restitution.hpp"
#include "osculo/impact/spinning_ball.hpp"

namespace osculo::impact {

/// A ball against a plane at rest whose normal N is tilted up by theta from the horizontal n: what
/// the cushion laws with Newton's restitution have in common.
///
/// In the frame (n, t = z x n, z), with N = (c, 0, s), c = cos theta, s = sin theta, p = (s, 0, -c)
/// and the ball's inertia k m r^2, per mass of the ball:
///
///     P = (1 + e) c vn                                                            along -N
///     u = (s vn + r wt) p + (vt + r (c wz - s wn)) t                              slip
///     Q = tangential(c vn, |u|)                                                   against u
///     vn -= c P + s Qp,   vt -= Qt
///     wn += s Qt / (k r),   wt -= Qp / (k r),   wz -= c Qt / (k r)                from N x Q
///
/// and u becomes u - (1 + 1/k) Q. The vertical velocity c Qp - s P is dropped: a law that gains no
/// energy in space gains none in the plane. If the ball would still approach, which takes
/// e < about tan^2 theta + mu tan theta, the table it is pressed on keeps it from sliding down
/// under the nose: it loses the rest of vn.
///
/// [tangential]: of the speeds of approach and slip, both > 0; returns an impulse per mass.
/// [normal]: in the table's plane from the ball towards the cushion, any length > 0. A ball that
/// does not approach is left alone. Requires r, k > 0, -1 < s < 1, e in [0, 1].
/// Error <= 16 epsilon (|v| + r |w|) in the velocity and 16 epsilon (|v| / r + |w|) (1 + 1 / k) in
/// the spin, besides what [tangential] errs. For s = 0 the normal velocity is that of Restitution,
/// bit for bit.
template <math::Scalar S, class Tangential>
void resolve_tilted_plane(const std::type_identity_t<S>& e, const std::type_identity_t<S>& s,
                          const math::Vec<S>& normal, SpinningBall<S>& ball,
                          Tangential&& tangential) {
    const math::Vec<S> n = normal / math::norm<S>(normal);
    const math::Vec<S> t(-n.y(), n.x());
    const S approach = math::dot<S>(n, ball.velocity);
    if (!(approach > S(0))) return;
    const S c_squared = (S(1) - s) * (S(1) + s);
    const S c = math::square_root<S>(c_squared);
    const math::Vec<S> spin(ball.spin.x(), ball.spin.y());
    const math::Vec<S> slip(s * approach + ball.radius * math::dot<S>(t, spin),
                            math::dot<S>(t, ball.velocity) +
                                ball.radius * (c * ball.spin.z() - s * math::dot<S>(n, spin)));

    // vn (1 - (1 + e) c^2) is a restitution of its own.
    Restitution::resolve<S>(s == S(0) ? e : S((S(1) + e) * c_squared - S(1)), normal,
                            ball.velocity);
    const S speed = math::norm<S>(slip);
    if (speed > S(0)) {
        const math::Vec<S> q = slip * (tangential(S(c * approach), speed) / speed);
        ball.velocity -= (s * q.x()) * n + q.y() * t;
        const math::Vec<S> twist = (s * q.y()) * n - q.x() * t;
        ball.spin += math::Vec3<S>(twist.x(), twist.y(), -c * q.y()) / (ball.inertia * ball.radius);
    }
    if (s == S(0)) return;
    const S left = math::dot<S>(n, ball.velocity);
    if (left > S(0)) ball.velocity -= left * n;
}

/// Coulomb's law for the above: min(mu P, |u| / (1 + 1/k)), for the slip keeps its direction while
/// it lasts and |u| / (1 + 1/k) stops it.
template <math::Scalar S>
struct CoulombFriction {
    S restitution;
    S friction;
    S inertia;

    [[nodiscard]] S operator()(const S& approach, const S& slip) const {
        const S sliding = friction * ((S(1) + restitution) * approach);
        const S sticking = slip / (S(1) + S(1) / inertia);
        return sliding < sticking ? sliding : sticking;
    }
};

}  // namespace osculo::impact

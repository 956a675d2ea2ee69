#pragma once

#include "osculo/impact/mathavan/integrate.hpp"
#include "osculo/impact/spinning_ball.hpp"

namespace osculo::impact {

/// A cushion whose nose presses the ball into the cloth (S. Mathavan, M. R. Jackson, R. M. Parkin,
/// "A theoretical analysis of billiard ball dynamics under cushion impacts", Proc. IMechE C 224,
/// 2010; NUMERICS 7.3): friction at the nose and at the cloth during the impact, Stronge's
/// energetic restitution. With the normal impulse p per mass at the nose as the independent
/// variable, N, n, t, p and u as in resolve_tilted_plane, d and d' the directions of the slips at
/// nose and cloth:
///
///     f  = mu d                      at the nose, or what holds it
///     q  = sin theta - cos theta fp  what keeps the ball at its height; the cloth gives it if > 0
///     g  = mu' q d'                  at the cloth, or what holds it
///     vn' = -c - s fp - gn           vt' = -ft - gt          per p
///     (r wn)' = (s ft - gt) / k      (r wt)' = (gn - fp) / k      (r wz)' = -c ft / k
///
/// which for k = 2/5 are the authors' equations. The impact ends when the work that the nose gives
/// back, c times the integral of -vn, is e^2 times the work it took.
///
/// The equations depend on the directions of two slips only, so they are smooth but where a slip
/// vanishes. They are integrated by Taylor series of high order from one such event to the next:
/// bounded steps, + - * / sqrt only. The result errs by about 1e-16 of |v| + r |w| in the median
/// and up to some 1e-12 (where a held contact breaks loose while barely overcome, an implicit
/// method takes over that is no better for wider types). Where friction all but jams the ball, or a
/// slip all but passes through zero, the model itself magnifies rounding more than that.
template <math::Scalar S>
struct CushionMathavan2010 {
    static constexpr const char* kName = "mathavan_2010";

    S restitution;     ///< e in [0, 1]
    S friction;        ///< mu >= 0 at the nose
    S height;          ///< h [m] of the nose above the table, 0 < h < 2 r
    S cloth_friction;  ///< mu' >= 0

    /// [normal]: in the table's plane from the ball towards the cushion, any length > 0. A ball
    /// that does not approach is left alone.
    void resolve(const math::Vec<S>& normal, SpinningBall<S>& ball) const {
        const math::Vec<S> n = normal / math::norm<S>(normal);
        const math::Vec<S> t(-n.y(), n.x());
        const S speed = math::dot<S>(n, ball.velocity);
        if (!(speed > S(0))) return;
        const mathavan::Constants<S> k((height - ball.radius) / ball.radius, friction,
                                       cloth_friction, ball.inertia);
        const math::Vec<S> spin(ball.spin.x(), ball.spin.y());
        const S vt = math::dot<S>(t, ball.velocity);
        const S wn = ball.radius * math::dot<S>(n, spin);
        const S wt = ball.radius * math::dot<S>(t, spin);
        const S wz = ball.radius * ball.spin.z();

        mathavan::Impact<S> impact{
            in_units_of(speed, math::Vec<S>(k.s * speed + wt, vt + (k.c * wz - k.s * wn))),
            in_units_of(speed, math::Vec<S>(speed - wt, vt + wn))};
        mathavan::Integration<S>(k, restitution, impact).run();

        const math::Vec<S>& f = impact.at_cushion;
        const math::Vec<S>& g = impact.at_cloth;
        ball.velocity += (speed * (impact.approach - S(1))) * n - (speed * (f.y() + g.y())) * t;
        const math::Vec<S> twist = (k.s * f.y() - g.y()) * n + (g.x() - f.x()) * t;
        ball.spin +=
            math::Vec3<S>(twist.x(), twist.y(), -k.c * f.y()) * (speed / (k.inertia * ball.radius));
    }

private:
    /// The slip over the approach. Only the direction of a much larger slip matters.
    static math::Vec<S> in_units_of(const S& speed, const math::Vec<S>& slip) {
        const S most = S(4) / math::epsilon<S>();
        const S size = math::norm<S>(slip);
        if (size < most * speed) return slip / speed;
        return slip * (most / size);
    }
};

}  // namespace osculo::impact

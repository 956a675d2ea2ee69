#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::impact::mathavan {

/// What a point of contact does during a step.
enum class Mode {
    slipping,
    leaving,   ///< slips, starting from no slip at all
    straight,  ///< the same along n or p, to which the whole motion is then confined
    sticking,
    lifted  ///< the cloth only: the ball is pulled up and the cloth cannot hold it
};

/// The constants of one impact, in units of the ball's mass and radius. Friction f per impulse at
/// the cushion, along p and t, and g at the cloth, along n and t, change the slips by
///
///     up' = -s c - a fp + b gn        un' = -c + b fp - d gn
///     ut' = -d ft - h gt              uy' = -h ft - d gt          (p, t at the cushion; n, t
///     below)
///
/// with a = s^2 + 1/k, b = 1/k - s, d = 1 + 1/k, h = 1 - s/k: a, not d, because the cloth takes up
/// the vertical impulse, q = s - c fp per impulse (downwards, so the cloth presses if q > 0).
template <math::Scalar S>
struct Constants {
    S s, c;
    S cushion_friction, cloth_friction;
    S inertia;
    S a, b, d, h;

    Constants(const S& sine, const S& mu_cushion, const S& mu_cloth, const S& k)
        : s(sine),
          c(math::square_root<S>((S(1) - sine) * (S(1) + sine))),
          cushion_friction(mu_cushion),
          cloth_friction(mu_cloth),
          inertia(k),
          a(sine * sine + S(1) / k),
          b(S(1) / k - sine),
          d(S(1) + S(1) / k),
          h(S(1) - sine / k) {}

    [[nodiscard]] S press(const S& fp) const { return s - c * fp; }
    /// Change of vn per impulse.
    [[nodiscard]] S approach_rate(const S& fp, const S& gn) const { return -c - s * fp - gn; }
    [[nodiscard]] math::Vec<S> pull_at_cushion(const math::Vec<S>& g) const {
        return {-s * c + b * g.x(), -h * g.y()};
    }
    [[nodiscard]] math::Vec<S> pull_at_cloth(const math::Vec<S>& f) const {
        return {-c + b * f.x(), -h * f.y()};
    }
    /// What the friction at the cushion must be for no slip there while the cloth slips along [d0].
    [[nodiscard]] math::Vec<S> holding_at_cushion(const math::Vec<S>& d0) const {
        S fp = (-s * c + b * cloth_friction * s * d0.x()) / (a + b * cloth_friction * c * d0.x());
        if (!(press(fp) > S(0))) return {-s * c / a, S(0)};
        return {fp, -h * (cloth_friction * press(fp) * d0.y()) / d};
    }
    /// What the friction at the cloth must be for no slip there.
    [[nodiscard]] math::Vec<S> holding_at_cloth(const math::Vec<S>& f) const {
        return pull_at_cloth(f) / d;
    }
};

}  // namespace osculo::impact::mathavan

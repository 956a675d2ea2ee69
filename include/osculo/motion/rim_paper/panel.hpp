#pragma once

#include <algorithm>

#include "osculo/math/hyperbolic.hpp"
#include "osculo/motion/rim_paper/field.hpp"

namespace osculo::motion {

/// Radial motion at one value of a panel's variable u.
template <math::Scalar S>
struct RimAlong {
    RimPlace<S> place;
    S tilt_rate;  ///< dq / dt
    S time_rate;  ///< dt / d|u|
};

/// A stretch of the radial motion, over the variable that takes the singularities of
/// dt = dq / sqrt(F) away (NUMERICS 3.2), which are near a minimum m of F:
///
///   F > 0 there     z - m = side e sinh u,   F ~ k ((z - m)^2 + e^2)
///   F < 0 there     z - m = side e cosh u,   F ~ k ((z - m)^2 - e^2): it turns at u = 0
///
/// The first is anchored at m, the second at the turn, from where z is side 2 e sinh^2(u / 2).
template <math::Scalar S>
struct RimPanel {
    RimAnchor<S> anchor;
    S e;
    int side;  ///< 1: z = m + ..., -1: z = m - ...
    bool turns;
    S from = S(0);  ///< u at the start
    S to = S(0);    ///< and at the end

    /// |u| at z: of a turn, at the distance [y] >= 0 from it, else at z - m = [y].
    [[nodiscard]] S variable(const S& y) const {
        if (!turns) return math::inverse_sinh<S>(S(side) * y / e);
        const S half = math::square_root<S>(std::max<S>(y, S(0)) / (S(2) * e));
        return S(2) * math::inverse_sinh<S>(half);
    }

    [[nodiscard]] RimAlong<S> at(const S& u) const {
        return turns ? around_turn(u) : around_minimum(u);
    }

private:
    [[nodiscard]] RimAlong<S> around_minimum(const S& u) const {
        const math::SinhCosh<S> h = math::sinh_cosh<S>(u);
        const S y = S(side) * (e * h.sinh);
        const RimPlace<S> p = anchor.at(y);
        const S speed = math::square_root<S>(std::max<S>(anchor.value_at(y), S(0)));
        const bool inwards = (from < to) == (side > 0);
        return {p, inwards ? speed : S(-speed), S(p.steepness() * (e * h.cosh) / speed)};
    }
    [[nodiscard]] RimAlong<S> around_turn(const S& u) const {
        const math::SinhCosh<S> h = math::sinh_cosh<S>(S(u / S(2)));
        const S y = S(side) * (S(2) * e * h.sinh * h.sinh);
        const RimPlace<S> p = anchor.at(y);
        const S slope = S(side) * anchor.mean_slope(p, y) * mean_steepness<S>(p, anchor.place);
        const S root = math::square_root<S>(std::max<S>(S(2) * e * slope, S(0)));
        return {p, S(S(side) * root * h.sinh), S(p.steepness() * (S(2) * e) * h.cosh / root)};
    }
};

}  // namespace osculo::motion

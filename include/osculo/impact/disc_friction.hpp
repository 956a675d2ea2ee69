#pragma once

#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/frictional.hpp"

namespace osculo::impact {

/// Friction between the boundaries of things that turn about the vertical only: discs, and balls in
/// the plane. Of spins (0, 0, wz) the general laws leave
///
///     two discs    u = (v1 - v2).t + r1 w1 + r2 w2,  t = z x n,  n from 1 to 2
///                  Jt = min(mu(|u|) Jn, |u| / ((1 + 1/k1) / m1 + (1 + 1/k2) / m2)) against u
///                  v1 -= Jt t / m1,  v2 += Jt t / m2,  w_i -= Jt / (k_i m_i r_i)
///     a cushion    u = v.t + r w,  Jt = min(mu (1 + e) m vn, m |u| / (1 + 1/k)),  upright face
///
/// whose third components they compute from zeros: (0, 0, wz) stays (0, 0, wz). Momentum and the
/// angular momentum about the contact are kept to rounding, energy never grows, and no height of
/// anything matters. Errors: as those of the laws.
struct DiscFriction {
    static constexpr const char* kName = "disc_friction";

    template <math::Scalar S>
    struct Laws {
        Frictional<S> ball_ball;
        CushionSimple<S> ball_cushion;
    };
};

}  // namespace osculo::impact

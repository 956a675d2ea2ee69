#pragma once

#include "osculo/impact/tilted_plane.hpp"

namespace osculo::impact {

/// A cushion whose nose touches the ball at height h (I. Han, "Dynamics in carom and three cushion
/// billiards", J. Mech. Sci. Technol. 19, 2005, eqs. 14-22; PHYSICS 4): restitution and friction
/// act in the plane of contact, tilted by sin theta = h / r - 1. Han's A = 7/(2m) is
/// (1 + 1/k)/m for a ball of inertia k m r^2.
template <math::Scalar S>
struct CushionHan2005 {
    static constexpr const char* kName = "han_2005";

    S restitution;  ///< e in [0, 1]
    S friction;     ///< mu >= 0
    S height;       ///< h [m] of the nose above the table, 0 < h < 2 r

    /// [normal], errors, preconditions: as resolve_tilted_plane.
    void resolve(const math::Vec<S>& normal, SpinningBall<S>& ball) const {
        resolve_tilted_plane<S>(restitution, (height - ball.radius) / ball.radius, normal, ball,
                                CoulombFriction<S>{restitution, friction, ball.inertia});
    }
};

}  // namespace osculo::impact

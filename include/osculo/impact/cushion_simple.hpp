#pragma once

#include "osculo/impact/tilted_plane.hpp"

namespace osculo::impact {

/// An upright cushion (PHYSICS 4, "simple"): the normal velocity is reversed times e. With friction
/// mu > 0 the slip at the point of contact, vertical part included, is opposed by Coulomb's law;
/// mu = 0 leaves everything else as it is, bit for bit as Restitution does.
template <math::Scalar S>
struct CushionSimple {
    static constexpr const char* kName = "simple";

    S restitution;  ///< e in [0, 1]
    S friction;     ///< mu >= 0

    /// [normal], errors, preconditions: as resolve_tilted_plane.
    void resolve(const math::Vec<S>& normal, SpinningBall<S>& ball) const {
        resolve_tilted_plane<S>(restitution, S(0), normal, ball,
                                CoulombFriction<S>{restitution, friction, ball.inertia});
    }
};

}  // namespace osculo::impact

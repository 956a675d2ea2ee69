#pragma once

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/frictional.hpp"

/// What of the binary laws with friction a cluster takes: restitution, Coulomb's friction and the
/// tilt of the contact.
namespace osculo::impact {

// Named only: who uses them includes them.
template <math::Scalar S>
struct CushionMathavan2010;
template <math::Scalar S>
struct CushionStronge;

template <math::Scalar S>
struct Surface {
    S restitution;         ///< e in [0, 1], in space
    Friction<S> friction;  ///< mu
    S tilt;                ///< sin theta
};

/// Exactly that, for a pair of balls and the two elementary cushions; [radius] of the ball.
template <math::Scalar S>
[[nodiscard]] Surface<S> surface(const Frictional<S>& law) {
    return {law.restitution, law.friction, S(0)};
}
template <math::Scalar S>
[[nodiscard]] Surface<S> surface(const CushionSimple<S>& law, const S&) {
    return {law.restitution, {law.friction, S(0), S(0)}, S(0)};
}
template <math::Scalar S>
[[nodiscard]] Surface<S> surface(const CushionHan2005<S>& law, const S& radius) {
    return {law.restitution, {law.friction, S(0), S(0)}, (law.height - radius) / radius};
}

/// Without the compliance of the nose: a ball is not flung back sideways.
template <math::Scalar S>
[[nodiscard]] Surface<S> surface(const CushionStronge<S>& law, const S& radius) {
    return {law.restitution, {law.friction, S(0), S(0)}, (law.height - radius) / radius};
}
/// Without the friction of the cloth during the impact, and with the restitution of velocities
/// instead of energies.
template <math::Scalar S>
[[nodiscard]] Surface<S> surface(const CushionMathavan2010<S>& law, const S& radius) {
    return {law.restitution, {law.friction, S(0), S(0)}, (law.height - radius) / radius};
}

/// A contact with friction; [other]: kFixed for a cushion.
template <math::Scalar S>
[[nodiscard]] SpinningContact<S> contact(std::size_t one, std::size_t other,
                                         const math::Vec<S>& normal, const Surface<S>& surface) {
    return {one, other, normal, surface.restitution, surface.friction, surface.tilt};
}

}  // namespace osculo::impact

#pragma once

#include "osculo/math/first_root.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

/// First contact of two balls in uniform motion, |x1 - x2| = r1 + r2 while approaching (PHYSICS 3),
/// or never(). The result does not depend on which ball is named first.
///
/// [first] and [second] start at the same instant. [reach] = r1 + r2 [m]. Error <= 1 ulp of the
/// time for the rounded difference of their states. Times after [horizon] may be given as never().
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& first,
                              const motion::LinearPath<S>& second, const S& reach,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return math::first_entry<S>(math::difference<S>(first.position, second.position),
                                first.velocity - second.velocity, reach, history, horizon);
}

}  // namespace osculo::detect

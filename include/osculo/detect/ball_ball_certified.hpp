#pragma once

#include "osculo/detect/certified_crossing.hpp"

namespace osculo::detect {

/// First contact of two balls on certified paths that start at the same instant, until the first of
/// them ends, or never(): |x1 - x2| = [reach] while approaching (PHYSICS 3).
///
/// See first_certified() for what is certain and for the error. Times after [horizon] may be given
/// as never().
template <math::Scalar S, class First, class Second>
requires motion::CertifiedPath<First, S> && motion::CertifiedPath<Second, S>
[[nodiscard]] S first_contact(const First& first, const Second& second, const S& reach,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const CircleCrossing<BetweenPaths<S, First, Second>> crossing{{first, second}, reach, false};
    return detail::first_certified_contact<S>(crossing, std::min<S>(first.end, second.end), history,
                                              horizon);
}

}  // namespace osculo::detect

#pragma once

#include "osculo/math/first_root_parabolic.hpp"
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

/// True only if first_contact() would find nothing, or nothing before [horizon], once the paths
/// have been shifted to a common start, by [first_shift] and [second_shift] s: told by a fraction
/// of its arithmetic. For pairs that have not just been resolved.
template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::LinearPath<S>& first, const S& first_shift,
                                   const motion::LinearPath<S>& second, const S& second_shift,
                                   const S& reach, const S& horizon) {
    const math::Vec<S> high = first.position.rounded() - second.position.rounded();
    const math::Vec<S> low = first.position.remainder() - second.position.remainder();
    const math::Vec<S> first_way = first.velocity * first_shift;
    const math::Vec<S> second_way = second.velocity * second_shift;
    const math::Vec<S> c = (high + low) + (first_way - second_way);
    const S error = S(math::kRejectionSlack) * math::epsilon<S>() *
                    (math::norm1<S>(high) + math::norm1<S>(low) + math::norm1<S>(first_way) +
                     math::norm1<S>(second_way));
    return math::certainly_no_entry<S>(c, error, first.velocity - second.velocity, reach, horizon);
}

/// The same for two balls with constant accelerations, until the first of their paths ends
/// (NUMERICS 1.5). Error <= 1 ulp of the time for the rounded difference of their states.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ParabolicPath<S>& first,
                              const motion::ParabolicPath<S>& second, const S& reach,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return math::first_entry<S>(
        math::ParabolicApproach<S>{math::difference<S>(first.position, second.position),
                                   first.velocity - second.velocity,
                                   first.half_acceleration - second.half_acceleration, reach},
        std::min<S>(first.end, second.end), history, horizon);
}

}  // namespace osculo::detect

#pragma once

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/wide.hpp"

namespace osculo::math {

/// A point in time [s]: wide, so that a local duration loses nothing after 1e9 events or at 1e12 s.
template <Scalar S>
using Instant = Wide<S>;

/// The time from `earlier` to `later` [s], to 1/2 ulp. Both must be finite.
template <Scalar S>
[[nodiscard]] S duration(const Instant<S>& earlier, const Instant<S>& later) {
    return narrow(Instant<S>(later - earlier));
}

/// The instant a duration after another one; `never` stays never.
template <Scalar S>
[[nodiscard]] Instant<S> after(const Instant<S>& start, const S& wait) {
    return is_finite<S>(wait) ? Instant<S>(start + wait) : Instant<S>(wait);
}

/// The least time that passes after this instant, other than none: shorter ones are lost in a sum
/// with it [s].
template <Scalar S>
[[nodiscard]] S resolution(const Instant<S>& instant) {
    return S(kSameInstant) * wide_epsilon<S>() * narrow(instant);
}

/// True for the instant of what does not happen.
template <Scalar S>
[[nodiscard]] bool is_never(const Instant<S>& instant) {
    return !is_finite<S>(narrow(instant));
}

}  // namespace osculo::math

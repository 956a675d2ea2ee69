#pragma once

#include <algorithm>

#include "osculo/detect/ball_arc.hpp"
#include "osculo/math/first_root_parabolic.hpp"

namespace osculo::detect {

/// First contact of a ball with constant acceleration with the circular part of an arc before its
/// path ends, from outside or from inside, or never().
///
/// The circle of an arc with an opening can be entered and left twice on a parabola, each time
/// through the opening or not; all four are looked at. Error <= 1 ulp for the rounded difference of
/// position and centre.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ParabolicPath<S>& path, const S& radius,
                              const geometry::Arc<S>& arc, const math::ContactHistory<S>& history,
                              const S& horizon) {
    using Approach = math::ParabolicApproach<S>;
    if (path.half_acceleration.x() == S(0) && path.half_acceleration.y() == S(0)) {
        const S t = first_contact<S>(motion::LinearPath<S>{path.position, path.velocity}, radius,
                                     arc, history, std::min<S>(horizon, path.end));
        return t <= path.end ? t : math::never<S>();
    }
    const S last = std::min<S>(path.end, horizon);
    const math::Vec<S> c = math::difference<S>(path.position, arc.center);
    const bool starts_outside = detail::is_outside<S>(c, arc.radius);

    // From outside: crossings that come down to the outer circle, or being pressed onto it; what
    // has come inside through the opening is not there.
    const Approach outer{c, path.velocity, path.half_acceleration, S(arc.radius + radius)};
    math::ContactHistory<S> outer_history = history;
    outer_history.just_resolved = history.just_resolved && starts_outside;
    const S best =
        math::first_entry<S>(outer, last, outer_history, math::never<S>(), [&](const S& t) {
            const math::Vec<S> place = outer.place(t);
            return detail::is_outside<S>(place, arc.radius) && arc.covers(place);
        });
    const S room = arc.radius - radius;
    if (!(room > S(0)) || (arc.full && starts_outside)) return best;

    // From inside: crossings that go up to the inner circle.
    const Approach inner{c, path.velocity, path.half_acceleration, room};
    const S t = math::first_exit<S>(inner, std::min<S>(last, best), !starts_outside,
                                    [&](const S& at) { return arc.covers(inner.place(at)); });
    return math::is_finite<S>(t) ? t : best;
}

}  // namespace osculo::detect

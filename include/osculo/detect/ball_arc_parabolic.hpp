#pragma once

#include <algorithm>

#include "osculo/detect/ball_arc.hpp"
#include "osculo/math/first_root_parabolic.hpp"

namespace osculo::detect {

/// First contact of a ball with constant acceleration with the circular part of an arc before its
/// path ends, from outside or from inside, or never().
///
/// The circle of an arc with an opening can be entered and left twice on a parabola, each time
/// through the opening or not; all four are looked at. Error <= 2 ulp but for extreme grazes.
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
    const S rr = arc.radius * arc.radius;
    const bool starts_outside =
        math::wide_dot<S>(c, c) >= math::wide_product<S>(arc.radius, arc.radius);
    /// From the path's start, or from where it was at a crossing that was no contact.
    const auto approach_after = [&](const S& start, const S& reach) {
        motion::ParabolicPath<S> rest = path;
        if (start > S(0)) rest.shift(start);
        return Approach{math::difference<S>(rest.position, arc.center), rest.velocity,
                        rest.half_acceleration, reach};
    };

    // From outside: crossings that come down to the outer circle. A ball that starts inside is no
    // contact where it starts.
    S best = math::never<S>();
    S start(0);
    math::ContactHistory<S> outer = history;
    outer.just_resolved = history.just_resolved || !starts_outside;
    for (int k = 0; k < 2; ++k) {
        const Approach p = approach_after(start, S(arc.radius + radius));
        const S t = math::first_entry<S>(p, S(last - start), outer);
        if (!math::is_finite<S>(t)) break;
        const math::Vec<S> place = p.place(t);
        if (math::dot<S>(place, place) >= rr && arc.covers(place)) {
            best = start + t;
            break;
        }
        start += t;
        outer.just_resolved = true;  // that crossing is behind it
    }
    if (arc.full && starts_outside) return best;

    // From inside: crossings that go up to the inner circle.
    const S room = arc.radius - radius;
    if (!(room > S(0))) return best;
    start = S(0);
    const S until = std::min<S>(last, best);
    for (int k = 0; k < 2; ++k) {
        const Approach p = approach_after(start, room);
        const bool inside = k == 0 && !starts_outside;
        const S t = math::first_exit<S>(p, S(until - start), inside, k > 0);
        if (!math::is_finite<S>(t)) break;
        if (arc.covers(p.place(t))) return start + t;
        start += t;
    }
    return best;
}

}  // namespace osculo::detect

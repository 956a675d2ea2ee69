#pragma once

#include "osculo/geometry/arc.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

/// First contact of a ball in uniform motion with the circular part of an arc, from outside or from
/// inside, or never(): distance to the centre = arc radius +- r while the gap closes, in a
/// direction within the arc's angles (the ends themselves are points of their own).
///
/// A ball that comes through the opening of the circle and then meets the arc from inside is found
/// too. Error <= 1 ulp for the rounded difference of position and centre.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::LinearPath<S>& path, const S& radius,
                              const geometry::Arc<S>& arc, const math::ContactHistory<S>& history,
                              const S& horizon) {
    const math::Vec<S> c = math::difference<S>(path.position, arc.center);
    const math::Vec<S>& v = path.velocity;
    const auto covered_at = [&](const S& t) { return arc.covers(math::Vec<S>(c + v * t)); };

    const bool outside = math::wide_dot<S>(c, c) >= math::wide_product<S>(arc.radius, arc.radius);
    if (outside) {
        const S t = math::first_entry<S>(c, v, S(arc.radius + radius), history, horizon);
        if (math::is_finite<S>(t) && covered_at(t)) return t;
        if (arc.full) return math::never<S>();
    }
    const S room = arc.radius - radius;
    if (!(room > S(0))) return math::never<S>();  // too large to be inside
    math::ContactHistory<S> inner = history;
    inner.just_resolved = history.just_resolved && !outside;
    // From outside only a ball that gets wholly inside first can meet the arc from there.
    if (outside && !(math::accurate_dot<S>(c, v) < S(0))) return math::never<S>();
    const S t = math::first_exit<S>(c, v, room, inner);
    return math::is_finite<S>(t) && covered_at(t) ? t : math::never<S>();
}

/// From the ball towards the nearest point of the arc's circle, any length.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_normal(const math::WidePoint<S>& position,
                                          const geometry::Arc<S>& arc) {
    const math::Vec<S> c = math::difference<S>(position, arc.center);
    const bool outside = math::wide_dot<S>(c, c) >= math::wide_product<S>(arc.radius, arc.radius);
    return outside ? math::Vec<S>(-c) : c;
}

}  // namespace osculo::detect

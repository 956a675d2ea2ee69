#pragma once

#include "osculo/geometry/arc.hpp"
#include "osculo/math/first_root.hpp"
#include "osculo/motion/path.hpp"

namespace osculo::detect {

namespace detail {

/// Whether |c| >= r.
template <math::Scalar S>
[[nodiscard]] bool is_outside(const math::Vec<S>& c, const S& r) {
    const S cc = math::dot<S>(c, c);
    const S rr = r * r;
    const S blur = S(math::kRejectionSlack) * math::epsilon<S>() * (cc + rr);
    if (cc > rr + blur) return true;
    if (cc < rr - blur) return false;
    return math::wide_dot<S>(c, c) >= math::wide_product<S>(r, r);
}

}  // namespace detail

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

    const bool outside = detail::is_outside<S>(c, arc.radius);
    if (outside) {
        const S t = math::first_entry<S>(c, v, S(arc.radius + radius), history, horizon);
        // What does not come near from outside does not get inside either.
        if (!math::is_finite<S>(t) || covered_at(t)) return t;
    }
    const S room = arc.radius - radius;
    if (!(room > S(0))) return math::never<S>();  // too large to be inside
    math::ContactHistory<S> inner = history;
    inner.just_resolved = history.just_resolved && !outside;
    const S t = math::first_exit<S>(c, v, room, inner, !outside);
    return math::is_finite<S>(t) && covered_at(t) ? t : math::never<S>();
}

/// From the ball towards the nearest point of the arc's circle, any length.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_normal(const math::WidePoint<S>& position,
                                          const geometry::Arc<S>& arc) {
    const math::Vec<S> c = math::difference<S>(position, arc.center);
    return detail::is_outside<S>(c, arc.radius) ? math::Vec<S>(-c) : c;
}

}  // namespace osculo::detect

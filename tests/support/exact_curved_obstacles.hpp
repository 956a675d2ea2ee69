#pragma once

#include "support/exact_obstacles.hpp"
#include "support/exact_parabolic.hpp"

/// First contacts on curved paths with segments and arcs from their definition, for the data as
/// stored.
namespace osculo::support {

template <class R>
[[nodiscard]] ExactVec<R> place_at(const ExactVec<R>& c, const ExactVec<R>& v, const ExactVec<R>& a,
                                   const R& t) {
    return c.moved(v, t).moved(a, R(t * t));
}

/// How far from a place the computed one may be, t known to rounding.
template <math::Scalar S, class R>
[[nodiscard]] R place_blur(const ExactVec<R>& c, const ExactVec<R>& v, const ExactVec<R>& a,
                           const R& t) {
    return 8 * exact<R>(math::epsilon<S>()) * (c.norm() + t * (v.norm() + t * a.norm()));
}

template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] ObstacleContact<R> exact_contact(const motion::ParabolicPath<S>& path,
                                               const S& radius,
                                               const geometry::Segment<S>& segment) {
    const ExactVec<R> c = exact_difference<S, R>(path.position, segment.from);
    const ExactVec<R> v(path.velocity);
    const ExactVec<R> a(path.half_acceleration);
    const ExactVec<R> normal(segment.normal);
    const ExactVec<R> tangent(segment.tangent);
    const R r = exact<R>(radius);
    const R length = exact<R>(segment.length);
    const R side = ExactVec<R>(rounded_difference<S, R>(path.position, segment.from)).dot(normal);
    ObstacleContact<R> contact;
    for (const int sign : {1, -1}) {
        if (sign < 0 && segment.one_sided) break;
        const bool starts_here = sign > 0 ? side >= 0 : side < 0;
        const Polynomial<R, 3> gap{R(sign * c.dot(normal) - r), R(sign * v.dot(normal)),
                                   R(sign * a.dot(normal))};
        for (const auto& m : meetings<R, 3>(gap, exact<R>(path.end))) {
            if (!m.crossing && !starts_here) continue;
            const R foot = place_at(c, v, a, m.time).dot(tangent);
            const R blur = place_blur<S, R>(c, v, a, m.time);
            if (abs(foot) <= blur || abs(R(foot - length)) <= blur) contact.at_an_end = true;
            if (foot < 0 || foot > length) continue;
            if (!contact.time || m.time < *contact.time) contact.time = m.time;
            break;
        }
    }
    return contact;
}

/// Every time at which the ball comes into contact with the whole circle, from outside or inside,
/// is looked at; the earliest that is within the arc's angles counts.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] ObstacleContact<R> exact_contact(const motion::ParabolicPath<S>& path,
                                               const S& radius, const geometry::Arc<S>& arc) {
    const math::Vec<S> seen = rounded_difference<S, R>(path.position, arc.center);
    const ExactVec<R> c(seen);
    const ExactVec<R> v(path.velocity);
    const ExactVec<R> a(path.half_acceleration);
    const ExactVec<R> start(arc.start);
    const ExactVec<R> end(arc.end);
    const R big = exact<R>(arc.radius);
    const bool starts_outside = c.norm() >= big;
    ObstacleContact<R> contact;
    const auto covered = [&](const R& t) {
        if (arc.full) return true;
        const ExactVec<R> at = place_at(c, v, a, t);
        const R after_start = start.cross(at);
        const R before_end = at.cross(end);
        const R blur = place_blur<S, R>(c, v, a, t);
        if (abs(after_start) <= blur || abs(before_end) <= blur) contact.at_an_end = true;
        return arc.reflex ? after_start >= 0 || before_end >= 0
                          : after_start >= 0 && before_end >= 0;
    };
    ParabolicCase<S> circle{seen, path.velocity, path.half_acceleration, S(arc.radius + radius),
                            path.end};
    for (const auto& m : meetings<R, 5>(gap_function<R>(circle), exact<R>(path.end))) {
        if (place_at(c, v, a, m.time).norm() < big || !covered(m.time)) continue;
        contact.time = m.time;
        break;
    }
    circle.s = arc.radius - radius;
    if (!(circle.s > S(0)) || (arc.full && starts_outside)) return contact;
    bool inside = !starts_outside;
    for (const auto& m : exact_exits<S, R>(circle)) {
        if (!m.crossing && !inside) continue;
        if (covered(m.time)) {
            if (!contact.time || m.time < *contact.time) contact.time = m.time;
            break;
        }
        inside = false;
    }
    return contact;
}

}  // namespace osculo::support

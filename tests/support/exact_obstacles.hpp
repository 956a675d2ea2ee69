#pragma once

#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/segment.hpp"
#include "osculo/motion/path.hpp"
#include "support/exact_contact.hpp"

/// First contacts with segments and arcs from their definition, for the data as stored.
namespace osculo::support {

template <class R>
struct ObstacleContact {
    std::optional<R> time;
    /// Rounding decides whether this or the end point next to it is hit: both are right.
    bool at_an_end = false;
};

template <class R>
struct ExactVec {
    R x;
    R y;

    ExactVec(const R& px, const R& py) : x(px), y(py) {}
    template <math::Scalar S>
    explicit ExactVec(const math::Vec<S>& v) : x(exact<R>(S(v.x()))), y(exact<R>(S(v.y()))) {}

    [[nodiscard]] R dot(const ExactVec& o) const { return x * o.x + y * o.y; }
    [[nodiscard]] R cross(const ExactVec& o) const { return x * o.y - y * o.x; }
    [[nodiscard]] R norm() const { return sqrt(dot(*this)); }
    [[nodiscard]] ExactVec moved(const ExactVec& v, const R& t) const {
        return {R(x + v.x * t), R(y + v.y * t)};
    }
};

/// Where the ball is, seen from `origin`.
template <math::Scalar S, class R>
[[nodiscard]] ExactVec<R> exact_difference(const math::WidePoint<S>& p,
                                           const math::Vec<S>& origin) {
    return {R(exact<R>(p.x) - exact<R>(S(origin.x()))), R(exact<R>(p.y) - exact<R>(S(origin.y())))};
}
/// The same rounded once, where that is what detection starts from.
template <math::Scalar S, class R>
[[nodiscard]] math::Vec<S> rounded_difference(const math::WidePoint<S>& p,
                                              const math::Vec<S>& origin) {
    const ExactVec<R> d = exact_difference<S, R>(p, origin);
    return {rounded<S>(d.x), rounded<S>(d.y)};
}

template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] ObstacleContact<R> exact_contact(const motion::LinearPath<S>& path, const S& radius,
                                               const geometry::Segment<S>& segment) {
    const ExactVec<R> c = exact_difference<S, R>(path.position, segment.from);
    const ExactVec<R> v(path.velocity);
    const ExactVec<R> normal(segment.normal);
    const ExactVec<R> tangent(segment.tangent);
    R distance = c.dot(normal);
    R speed = v.dot(normal);
    if (distance < 0) {
        if (segment.one_sided) return {};
        distance = -distance;
        speed = -speed;
    }
    if (speed >= 0) return {};
    const R r = exact<R>(radius);
    const R t = distance > r ? R((distance - r) / -speed) : R(0);
    const R foot = c.dot(tangent) + v.dot(tangent) * t;
    const R length = exact<R>(segment.length);
    const R blur = 8 * exact<R>(math::epsilon<S>()) * (c.norm() + v.norm() * t);
    const bool at_an_end = abs(foot) <= blur || abs(R(foot - length)) <= blur;
    if (foot < 0 || foot > length) return {std::nullopt, at_an_end};
    return {t, at_an_end};
}

/// The two ways to meet a circle are tried in turn, each at every root; the earliest that is within
/// the arc's angles counts.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] ObstacleContact<R> exact_contact(const motion::LinearPath<S>& path, const S& radius,
                                               const geometry::Arc<S>& arc) {
    const math::Vec<S> seen = rounded_difference<S, R>(path.position, arc.center);
    const ExactVec<R> c(seen);
    const ExactVec<R> v(path.velocity);
    const ExactVec<R> start(arc.start);
    const ExactVec<R> end(arc.end);
    const R big = exact<R>(arc.radius);
    const S outer = arc.radius + radius;
    const S inner = arc.radius - radius;
    ObstacleContact<R> contact;
    const auto consider = [&](const R& t) {
        const ExactVec<R> at = c.moved(v, t);
        const R after_start = start.cross(at);
        const R before_end = at.cross(end);
        const bool inside =
            arc.reflex ? after_start >= 0 || before_end >= 0 : after_start >= 0 && before_end >= 0;
        const R blur = 8 * exact<R>(math::epsilon<S>()) * (c.norm() + v.norm() * t);
        if (!arc.full && (abs(after_start) <= blur || abs(before_end) <= blur)) {
            contact.at_an_end = true;
        }
        if ((arc.full || inside) && (!contact.time || t < *contact.time)) contact.time = t;
    };
    const R distance = c.norm();
    const R slope = c.dot(v);
    if (v.norm() == 0) return contact;
    if (distance >= big) {  // from outside
        const auto t = exact_entry<S, R>(PointCase<S>{seen, path.velocity, outer});
        if (t) consider(*t);
    }
    if (inner > S(0) && !(arc.full && distance >= big)) {  // from inside
        const GapFunction<R> gap(PointCase<S>{seen, path.velocity, inner});
        if (distance < big && slope >= 0 && gap.gap >= 0) {
            consider(R(0));
        } else if (gap.discriminant > 0) {
            const R t = (sqrt(gap.discriminant) - slope) / gap.quadratic;
            if (t > 0) consider(t);
        } else if (distance < big) {  // overlaps by rounding; outwards from the closest approach on
            consider(R(-slope / gap.quadratic));
        }
    }
    return contact;
}

}  // namespace osculo::support

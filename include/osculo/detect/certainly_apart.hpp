#pragma once

#include <algorithm>

#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/rim.hpp"
#include "osculo/geometry/segment.hpp"
#include "osculo/math/certainly_outside.hpp"
#include "osculo/math/error_bounds.hpp"
#include "osculo/motion/path.hpp"

/// Tells most contacts of curved paths that do not happen by a fraction of the arithmetic of
/// first_contact(): certain, on the safe side of rounding, so that asking changes no result.
namespace osculo::detect {

namespace detail {

/// A relative path c + b t + a t^2, 0 <= t <= until, computed in S. [place] and [speed] bound the
/// absolute terms that c and b are sums of.
template <math::Scalar S>
struct RoundedPath {
    math::Vec<S> c, b, a;
    S place, speed;
    S until;

    [[nodiscard]] static RoundedPath from(const motion::ParabolicPath<S>& path,
                                          const math::Vec<S>& origin, const S& until) {
        const math::Vec<S> start = path.position.rounded();
        return {start - origin,
                path.velocity,
                path.half_acceleration,
                S(math::norm1<S>(start) + math::norm1<S>(origin)),
                math::norm1<S>(path.velocity),
                until};
    }

    [[nodiscard]] bool stays_outside(const S& s) const {
        return math::certainly_outside<S>(c, b, a, s, until, place, speed,
                                          S(2 * math::kRejectionSlack) * math::epsilon<S>());
    }
};

/// Whether a ball on that path stays farther than [reach] from a point until [horizon].
template <math::Scalar S>
[[nodiscard]] bool stays_outside(const motion::ParabolicPath<S>& path, const math::Vec<S>& point,
                                 const S& reach, const S& horizon) {
    const S until = std::min<S>(path.end, horizon);
    return math::is_finite<S>(until) &&
           RoundedPath<S>::from(path, point, until).stays_outside(reach);
}

}  // namespace detail

/// True only if first_contact() would find nothing, or nothing before [horizon], once the paths
/// have been shifted to a common start, by [first_shift] and [second_shift] s.
template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::ParabolicPath<S>& first, const S& first_shift,
                                   const motion::ParabolicPath<S>& second, const S& second_shift,
                                   const S& reach, const S& horizon) {
    const S until =
        std::min<S>(horizon, std::min<S>(first.end - first_shift, second.end - second_shift));
    if (!math::is_finite<S>(until)) return false;
    const math::Vec<S> one = first.position.rounded();
    const math::Vec<S> other = second.position.rounded();
    detail::RoundedPath<S> path{one - other,
                                first.velocity - second.velocity,
                                first.half_acceleration - second.half_acceleration,
                                S(math::norm1<S>(one) + math::norm1<S>(other)),
                                S(math::norm1<S>(first.velocity) + math::norm1<S>(second.velocity)),
                                std::max<S>(until, S(0))};
    const auto shift = [&path](const motion::ParabolicPath<S>& by, const S& t, const S& sign) {
        if (!(t > S(0))) return;
        const math::Vec<S> bend = t * by.half_acceleration;
        path.c += (sign * t) * (by.velocity + bend);
        path.b += (sign * S(2)) * bend;
        path.place += t * (math::norm1<S>(by.velocity) + math::norm1<S>(bend));
        path.speed += S(2) * math::norm1<S>(bend);
    };
    shift(first, first_shift, S(1));
    shift(second, second_shift, S(-1));
    return path.stays_outside(reach);
}

/// The same for a ball and an obstacle.
template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::ParabolicPath<S>& path, const S& radius,
                                   const geometry::Point<S>& point, const S& horizon) {
    return detail::stays_outside<S>(path, point.at, radius, horizon);
}

template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::ParabolicPath<S>& path, const S& /*radius*/,
                                   const geometry::Rim<S>& rim, const S& horizon) {
    return detail::stays_outside<S>(path, rim.center, rim.radius, horizon);
}

/// Outside of the arc's circle only.
template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::ParabolicPath<S>& path, const S& radius,
                                   const geometry::Arc<S>& arc, const S& horizon) {
    const S reach = (arc.radius + radius) * (S(1) + S(math::kRejectionSlack) * math::epsilon<S>());
    return detail::stays_outside<S>(path, arc.center, reach, horizon);
}

/// On one side of the segment's line, or beyond one of its ends: the parabola lies between its ends
/// and the corner of its tangents there.
template <math::Scalar S>
[[nodiscard]] bool certainly_apart(const motion::ParabolicPath<S>& path, const S& radius,
                                   const geometry::Segment<S>& segment, const S& horizon) {
    const S until = std::min<S>(path.end, horizon);
    if (!math::is_finite<S>(until)) return false;
    const auto p = detail::RoundedPath<S>::from(path, segment.from, until);
    const math::Vec<S> corner = p.c + (until / S(2)) * p.b;
    const math::Vec<S> end = p.c + until * (p.b + until * p.a);
    const S terms = p.place + until * (p.speed + until * math::norm1<S>(p.a));
    const S blur =
        S(4 * math::kRejectionSlack) * math::epsilon<S>() * (terms + radius + segment.length);
    const auto all_beyond = [&](const math::Vec<S>& direction, const S& least) {
        return math::dot<S>(p.c, direction) > least && math::dot<S>(corner, direction) > least &&
               math::dot<S>(end, direction) > least;
    };
    const math::Vec<S> back = -segment.normal;
    return all_beyond(segment.normal, S(radius + blur)) || all_beyond(back, S(radius + blur)) ||
           (segment.one_sided && all_beyond(back, blur)) ||
           all_beyond(segment.tangent, S(segment.length + blur)) ||
           all_beyond(math::Vec<S>(-segment.tangent), blur);
}

}  // namespace osculo::detect

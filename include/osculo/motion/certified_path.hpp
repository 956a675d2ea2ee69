#pragma once

#include <concepts>

#include "osculo/motion/path.hpp"

namespace osculo::motion {

/// Where a ball is on its path and how fast.
template <math::Scalar S>
struct PathPoint {
    math::WidePoint<S> position;  ///< [m]
    math::Vec<S> velocity;        ///< [m/s]
};

/// A path of any shape that can be told from a parabola by less than a known distance (NUMERICS
/// 2.2), for motion that is not quadratic in time. For 0 <= t <= t + h <= end, all in S:
///
///     path.position          where it starts, t = 0 [m]
///     path.end               until when it is valid [s]; may be infinite
///     path.at(t)             place and velocity at t
///     path.quadratic(t)      the parabola of second order that touches it at t
///     path.jerk_bound(t, h)  at least |third derivative of the place| on [t, t + h] [m/s^3],
///     finite
///                            for h > 0 small enough
///
/// from which |place(t + h) - quadratic(t) at h| <= jerk_bound(t, h) h^3 / 6. What at() and
/// quadratic() give may err by math::kPathNoise epsilon of the way gone since the start, the
/// velocity by as many epsilon of that at the start; of a path with a member `size` [m], by that of
/// the way and the size together.
template <class Path, class S>
concept CertifiedPath = math::Scalar<S> && requires(const Path& path, const S& t, const S& h) {
    { path.position } -> std::convertible_to<math::WidePoint<S>>;
    { path.end } -> std::convertible_to<S>;
    { path.at(t) } -> std::convertible_to<PathPoint<S>>;
    { path.quadratic(t) } -> std::convertible_to<ParabolicPath<S>>;
    { path.jerk_bound(t, h) } -> std::convertible_to<S>;
};

/// A parabola as a certified path, so that it can meet one.
template <math::Scalar S>
struct QuadraticPath : ParabolicPath<S> {
    [[nodiscard]] PathPoint<S> at(const S& t) const {
        return {math::displaced<S>(this->position, this->velocity, this->half_acceleration, t),
                this->velocity + (S(2) * t) * this->half_acceleration};
    }
    [[nodiscard]] ParabolicPath<S> quadratic(const S& t) const {
        ParabolicPath<S> path = *this;
        path.shift(t);
        return path;
    }
    [[nodiscard]] S jerk_bound(const S& /*t*/, const S& /*h*/) const { return S(0); }
};

}  // namespace osculo::motion

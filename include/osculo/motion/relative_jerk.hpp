#pragma once

#include <algorithm>

#include "osculo/math/error_bounds.hpp"
#include "osculo/motion/resisted.hpp"

namespace osculo::motion {

/// At least |the difference of the third derivatives| of the places of two balls that slow down, on
/// [t, t + h] [m/s^3]: next to nothing for two that go side by side, where the sum of their jerks
/// is not.
///
/// A ball slows down at f(v) = a + k v + b v^2, so its third derivative is g(v) = f'(v) f(v) along
/// its velocity. For one law, g of two velocities differs by at most max(g', g / v) times their
/// difference, over the speeds there are; and that difference never grows, for such forces are the
/// gradients of convex functions of the velocity. What the laws differ in adds to both. Slower
/// speeds than (v - h f(v)) there are none.
template <math::Scalar S>
[[nodiscard]] S relative_jerk_bound(const ResistedPath<S>& one, const ResistedPath<S>& other,
                                    const S& t, const S& h) {
    struct Ball {
        math::Vec<S> velocity;  // at t
        S speed, least;
        S constant, linear, quadratic;  // a, k, b
    };
    const auto ball = [&](const ResistedPath<S>& path) {
        const S start = math::norm<S>(path.velocity);
        const Slowed<S>& now = path.slowed(t);
        const S speed = now.q * start;
        const S lost = h * path.slowing.rate(now.q) * start;
        return Ball{now.q * path.velocity,     speed,          S(speed - lost),
                    S(path.slowing.m * start), path.slowing.k, S(path.slowing.c / start)};
    };
    const S sum = one.jerk_bound(t, h) + other.jerk_bound(t, h);
    if (one.stands() || other.stands() || !math::is_finite<S>(sum)) return sum;
    const Ball first = ball(one);
    const Ball second = ball(other);
    const S rounding = S(math::kPathNoise) * math::epsilon<S>();
    const auto apart = [&](const S& x, const S& y) {
        const S larger = std::max<S>(x, y);
        return S(math::abs<S>(x - y) + rounding * larger);
    };

    const S v = std::max<S>(first.speed, second.speed);
    const S a = std::max<S>(first.constant, second.constant);
    const S k = std::max<S>(first.linear, second.linear);
    const S b = std::max<S>(first.quadratic, second.quadratic);
    const S f = a + v * (k + v * b);
    const S slope = k + S(2) * b * v;
    const S f_apart =
        apart(first.constant, second.constant) +
        v * (apart(first.linear, second.linear) + v * apart(first.quadratic, second.quadratic));
    const S slope_apart =
        apart(first.linear, second.linear) + S(2) * v * apart(first.quadratic, second.quadratic);
    const S velocities_apart =
        math::norm<S>(first.velocity - second.velocity) +
        rounding * (math::norm1<S>(one.velocity) + math::norm1<S>(other.velocity)) + h * f_apart;
    const S least = std::min<S>(first.least, second.least) - velocities_apart / S(2);
    if (!(least > S(0))) return sum;
    const S steepest = std::max<S>(S(2) * b * f + slope * slope, slope * f / least);
    const S bound =
        (steepest * velocities_apart + slope_apart * f + slope * f_apart) * (S(1) + rounding);
    return bound < sum ? bound : sum;  // sum, if it is no number
}

}  // namespace osculo::motion

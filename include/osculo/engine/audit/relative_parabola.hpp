#pragma once

#include <utility>

#include "osculo/engine/audit/polynomial_zeros.hpp"
#include "osculo/engine/audit/smallest_gap.hpp"

namespace osculo::engine {

/// Motion with constant acceleration seen from something else: start + velocity t +
/// half_acceleration t^2 for 0 <= t <= time.
template <math::Scalar S>
struct RelativeParabola {
    using Wide = math::Wide<S>;

    math::WidePoint<S> start;              ///< [m]
    math::WidePoint<S> velocity;           ///< [m/s]
    math::WidePoint<S> half_acceleration;  ///< [m/s^2]
    Wide time;                             ///< [s]

    [[nodiscard]] math::WidePoint<S> at(const Wide& t) const {
        return {start.x + (velocity.x + half_acceleration.x * t) * t,
                start.y + (velocity.y + half_acceleration.y * t) * t};
    }
    [[nodiscard]] math::WidePoint<S> velocity_at(const Wide& t) const {
        const Wide two_t = t * Wide(S(2));
        return {velocity.x + half_acceleration.x * two_t, velocity.y + half_acceleration.y * two_t};
    }
};

/// The path in S, in shares of its time: c + v x + a x^2 for 0 <= x <= 1 [m].
template <math::Scalar S>
struct SharedOut {
    math::Vec<S> c, v, a;

    explicit SharedOut(const RelativeParabola<S>& path) : c(path.start.rounded()) {
        const math::Wide<S>& t = path.time;
        v = {math::narrow(math::Wide<S>(path.velocity.x * t)),
             math::narrow(math::Wide<S>(path.velocity.y * t))};
        a = {math::narrow(math::Wide<S>(path.half_acceleration.x * t * t)),
             math::narrow(math::Wide<S>(path.half_acceleration.y * t * t))};
    }

    /// n.x along the path, of which foot [m] is taken away.
    [[nodiscard]] std::array<S, 3> along(const math::Vec<S>& n, const S& foot) const {
        return {math::dot<S>(n, c) - foot, math::dot<S>(n, v), math::dot<S>(n, a)};
    }
};

/// A share of the path's time, in seconds, with Newton's steps at f(t) = 0 in wide precision: f
/// returns a wide value and its slope in S.
template <math::Scalar S, class Function>
[[nodiscard]] math::Wide<S> sharpened(const RelativeParabola<S>& path, const S& share,
                                      Function&& f) {
    using Wide = math::Wide<S>;
    Wide t = path.time * Wide(share);
    // A step from a zero to anywhere else is none: the zero is double, and good enough as it is.
    const S most = math::square_root<S>(math::epsilon<S>()) * math::narrow(path.time);
    for (int i = 0; i < 2; ++i) {
        const auto [value, slope] = f(t);
        const S step = math::narrow(Wide(value)) / slope;
        if (!(math::abs<S>(step) <= most)) break;
        const Wide next = t - Wide(step);
        if (next < Wide(S(0)) || path.time < next) break;
        t = next;
    }
    return t;
}

/// When the path turns from approaching the origin to leaving it or back, in ascending order.
///
/// Half the slope of |x|^2 is a cubic. What its zero errs by counts in second order in the
/// distance, and less where the cubic is flat.
template <math::Scalar S>
[[nodiscard]] Few<math::Wide<S>, 3> turning_times(const RelativeParabola<S>& path) {
    const SharedOut<S> x(path);
    const S vv = math::dot<S>(x.v, x.v);
    const std::array<S, 4> slope{math::dot<S>(x.c, x.v), vv + S(2) * math::dot<S>(x.a, x.c),
                                 S(3) * math::dot<S>(x.a, x.v), S(2) * math::dot<S>(x.a, x.a)};
    Few<math::Wide<S>, 3> times;
    for (const S& share : zeros_between_0_and_1<S, 4>(slope)) {
        times.add(sharpened<S>(path, share, [&](const math::Wide<S>& t) {
            const math::WidePoint<S> place = path.at(t);
            const math::WidePoint<S> velocity = path.velocity_at(t);
            const math::Vec<S> v = velocity.rounded();
            return std::pair{
                inner<S>(place, velocity),
                S(math::dot<S>(v, v) +
                  S(2) * math::dot<S>(place.rounded(), path.half_acceleration.rounded()))};
        }));
    }
    return times;
}

/// When n.x = foot, in ascending order.
template <math::Scalar S>
[[nodiscard]] Few<math::Wide<S>, 2> crossing_times(const RelativeParabola<S>& path,
                                                   const math::Vec<S>& n, const S& foot) {
    const math::WidePoint<S> wide_n(n);
    Few<math::Wide<S>, 2> times;
    for (const S& share : zeros_between_0_and_1<S, 3>(SharedOut<S>(path).along(n, foot))) {
        times.add(sharpened<S>(path, share, [&](const math::Wide<S>& t) {
            return std::pair{math::Wide<S>(inner<S>(path.at(t), wide_n) - math::Wide<S>(foot)),
                             math::narrow(math::Wide<S>(inner<S>(path.velocity_at(t), wide_n)))};
        }));
    }
    return times;
}

}  // namespace osculo::engine

#pragma once

#include <algorithm>

#include "osculo/detect/ball_segment.hpp"

namespace osculo::detect {

namespace detail {

/// A ball's distance from a line less its radius: gap + speed t + half_acceleration t^2.
template <math::Scalar S>
struct LineApproach {
    math::Wide<S> gap, speed, half_acceleration;

    /// The zero at which the distance falls, or never(). There is at most one.
    [[nodiscard]] S falling_zero() const {
        using Wide = math::Wide<S>;
        const Wide zero{S(0)};
        const Wide four_a = half_acceleration * Wide(S(4));
        const Wide disc = speed * speed - four_a * gap;
        if (!(disc > zero)) return math::never<S>();
        const Wide root = math::wide_square_root(disc);
        // Two forms of the same zero, each without cancellation on its side.
        if (speed < zero) return math::quotient(Wide(gap * Wide(S(2))), Wide(root - speed));
        if (!(half_acceleration < zero)) return math::never<S>();
        return math::quotient(Wide(speed + root), Wide(half_acceleration * Wide(S(-2))));
    }

    /// Whether there is a gap at t.
    [[nodiscard]] bool is_open(const S& t) const {
        using Wide = math::Wide<S>;
        const Wide rise = (half_acceleration * Wide(t) + speed) * Wide(t);
        return rise + gap > Wide(S(0));
    }
};

/// First contact with the line from the side where the gap is measured, t >= 0, wherever the foot
/// is. [starts_here]: the ball's centre is on that side at t = 0.
template <math::Scalar S>
[[nodiscard]] S first_contact(LineApproach<S> line, const S& radius, bool starts_here,
                              const math::ContactHistory<S>& history) {
    const S gap = math::narrow(line.gap);
    const S speed = math::narrow(line.speed);
    const S pull = math::narrow(line.half_acceleration);
    const bool approaches = speed < S(0) || (speed == S(0) && pull < S(0));
    const S noticeable = S(math::kTouch) * math::epsilon<S>() * radius;
    const bool resolved = history.just_resolved && starts_here;
    if (resolved && !approaches) {  // t (speed + pull t): the root at zero is the last contact
        return pull < S(0) ? S(-speed / pull) : math::never<S>();
    }
    // Touching, an approach that is mere rounding counts when it has become noticeable.
    const bool noise = history.noise > S(0) && -speed <= history.noise && gap <= noticeable;
    if (resolved || (starts_here && approaches && noise)) {
        line.gap = math::Wide<S>(noticeable);
        return line.falling_zero();
    }
    if (gap > S(0)) return line.falling_zero();
    if (approaches) return starts_here ? S(0) : math::never<S>();
    const S t = line.falling_zero();
    if (math::is_finite<S>(t) || !starts_here || !(pull < S(0))) return t;
    // Overlapping by rounding, and pulled back before they part.
    return math::quotient(line.speed, math::Wide<S>(line.half_acceleration * math::Wide<S>(S(-2))));
}

}  // namespace detail

/// First contact of a ball with constant acceleration with the straight part of a segment before
/// its path ends, or never(): as for uniform motion, from either side of a two-sided segment,
/// whichever side it starts on.
///
/// Discriminant and zero in wide precision: the decision is exact and the error <= 1 ulp for the
/// stored, rounded normal.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ParabolicPath<S>& path, const S& radius,
                              const geometry::Segment<S>& segment,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const math::WidePoint<S> wide_c = math::wide_difference<S>(path.position, segment.from);
    const math::Vec<S> c = wide_c.rounded();
    const S side = math::accurate_dot<S>(c, segment.normal);
    const S last = std::min<S>(path.end, horizon);
    S best = math::never<S>();
    for (const bool left : {true, false}) {
        if (!left && segment.one_sided) break;
        const math::Vec<S> normal = left ? segment.normal : math::Vec<S>(-segment.normal);
        const bool starts_here = left ? side >= S(0) : side < S(0);
        const detail::LineApproach<S> line{detail::line_gap<S>(wide_c, normal, radius),
                                           math::wide_dot<S>(path.velocity, normal),
                                           math::wide_dot<S>(path.half_acceleration, normal)};
        const S t = detail::first_contact<S>(line, radius, starts_here, history);
        if (!(t >= S(0) && t <= last && t < best)) continue;
        if (t == last && line.is_open(t)) continue;  // rounded down to the end of the path
        const math::Vec<S> place = c + t * (path.velocity + t * path.half_acceleration);
        const S foot = math::dot<S>(place, segment.tangent);
        if (foot >= S(0) && foot <= segment.length) best = t;
    }
    return best;
}

}  // namespace osculo::detect

#pragma once

#include "osculo/motion/rim_tipping/field.hpp"

/// A rigid ball on the circular edge of a hole, that tips over it (PHYSICS 5, NUMERICS 3.5): its
/// centre is at the distance r from the edge, in the direction that has the tilt from the vertical,
/// and the edge can only push. Until where does it touch the edge, and how fast is it there?
namespace osculo::motion {

/// How the contact with the edge ends.
enum class TippingOutcome {
    lift_off,  ///< the edge pushes no more: the ball flies
    back,      ///< it tips back and leaves over the edge as it came
    down,      ///< it is on its side of the edge, at a tilt of 90 degrees, and still touches
};

/// The end of the contact.
template <math::Scalar S>
struct Tipping {
    TippingOutcome outcome;
    S sine, cosine;  ///< of the tilt
    S speed;  ///< of the centre, around the edge [m/s]: inwards times cosine, down times sine
    S along;  ///< of the centre, along the edge [m/s]
};

/// An edge that lets a ball of inertia k m r^2 roll straight over it without slipping, or, k = 0,
/// slide: contact is lost where cos(tilt) = (2 + (1 + k) v^2 / (g r)) / (3 + k), and at once from
/// v = sqrt(g r) on. [speed] towards the hole, when the tilt is 0. Requires gravity, radius > 0.
template <math::Scalar S>
[[nodiscard]] Tipping<S> tip_straight(const S& gravity, const S& radius, const S& inertia,
                                      const S& speed) {
    const S unit = gravity * radius;
    const S square = speed * speed / unit;
    if (!(square < S(1))) return {TippingOutcome::lift_off, S(0), S(1), speed, S(0)};
    // 1 - cos, which does not cancel.
    const S drop = (S(1) + inertia) * (S(1) - square) / (S(3) + inertia);
    const S sine = math::square_root<S>(drop * (S(2) - drop));
    const S gained = speed * speed + S(2) * unit * drop / (S(1) + inertia);
    return {TippingOutcome::lift_off, sine, S(S(1) - drop), math::square_root<S>(gained), S(0)};
}

/// An edge without friction, for a ball that comes to it with the speeds [inwards] > 0 and [along]:
/// angular momentum about the hole and energy are kept. The zeros of push and speed are isolated
/// between their turns, so none is missed. Requires gravity > 0, rim > radius > 0.
template <math::Scalar S>
[[nodiscard]] Tipping<S> tip_frictionless(const S& gravity, const S& rim, const S& radius,
                                          const S& inwards, const S& along) {
    using Field = TippingField<S>;
    const S unit = math::square_root<S>(gravity * radius);
    const S start = inwards / unit;
    if (!(start < S(1))) return {TippingOutcome::lift_off, S(0), S(1), inwards, along};
    const S moment = rim / radius * (along / unit);
    const Field field{S(rim / radius), S(start * start), S(moment * moment)};
    const typename Field::SpeedSquare speed_square{field};
    const typename Field::Push push{field};
    const auto first = [&](const auto& f) {
        const auto borders = field.borders(f);
        return first_fall<S>(f, borders, S(0), false, [&](std::size_t i) {
            return i == 0 || f(borders.z[i]) > S(0) ? 1 : -1;
        });
    };
    const S lost = first(push);
    const S turn = first(speed_square);
    if (turn < lost) return {TippingOutcome::back, S(0), S(1), S(-inwards), along};
    const bool lifts = lost < S(1);
    const RimPlace<S> p = field.at(lifts ? lost : S(1));
    const S square = speed_square(p.z);
    return {lifts ? TippingOutcome::lift_off : TippingOutcome::down, p.q, p.c,
            S(unit * math::square_root<S>(square > S(0) ? square : S(0))),
            S(along * (field.rim / p.d))};
}

}  // namespace osculo::motion

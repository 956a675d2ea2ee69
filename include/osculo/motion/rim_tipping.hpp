#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/polynomial.hpp"
#include "osculo/motion/rim_paper/field.hpp"

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

namespace detail {

/// Functions of z = tan(tilt / 2), lengths in r and speeds in sqrt(g r), for a ball that comes to
/// the rim R with the speeds u inwards and w along it: L = R w is kept, and so is the energy.
template <math::Scalar S>
struct TippingField {
    S rim, inwards, along;

    [[nodiscard]] RimPlace<S> at(const S& z) const { return {z, S(S(1) - z), S(rim - S(1))}; }
    [[nodiscard]] static S drop(const S& z) { return S(2) * z * z / (S(1) + z * z); }
    [[nodiscard]] S moment_square() const { return rim * rim * along * along; }

    /// speed^2 = u^2 + 2 (1 - cos) - L^2 (1/d^2 - 1/R^2).
    struct SpeedSquare {
        const TippingField& field;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            const S& w = field.along;
            return field.inwards * field.inwards + S(2) * drop(z) -
                   w * w * p.q * (field.rim + p.d) / (p.d * p.d);
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return S(4) / (S(1) + z * z) * (p.q - field.moment_square() * p.c / (p.d * p.d * p.d));
        }
    };
    /// What the edge pushes with, over m g: cos - speed^2 + L^2 sin / d^3.
    struct Push {
        const TippingField& field;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            const S& w = field.along;
            const S& rim = field.rim;
            return (S(1) - field.inwards * field.inwards) - S(3) * drop(z) +
                   w * w * p.q * (rim * rim + rim * p.d + p.d * p.d) / (p.d * p.d * p.d);
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            const S dd = p.d * p.d;
            return S(6) / (S(1) + z * z) *
                   (field.moment_square() * field.rim * p.c / (dd * dd) - p.q);
        }
    };
    /// q d^n - K c, whose zeros are those of a slope. q d^n / c rises from 0 without end, but for
    /// one stretch on which it may fall.
    struct Balance {
        const TippingField& field;
        int n;
        S constant;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return p.q * power(p.d, n) - constant * p.c;
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return S(2) / (S(1) + z * z) *
                   (p.c * power(p.d, n - 1) * (p.d - S(n) * p.q) + constant * p.q);
        }
        [[nodiscard]] static S power(const S& d, int n) {
            S result(1);
            for (int i = 0; i < n; ++i) result *= d;
            return result;
        }
    };

    /// Where the function whose slope has the zeros of that balance turns, from 0 to 1.
    struct Borders {
        std::array<S, 5> z;
        std::size_t count = 0;
        void add(const S& at) { z[count++] = at; }
    };
    [[nodiscard]] Borders borders(int n, const S& constant) const {
        Borders result;
        result.add(S(0));
        const Balance balance{*this, n, constant};
        // q d^n / c falls where q (n + 1 - n q^2) > R.
        const math::Cubic<S> rise{S(-rim), S(n + 1), S(0), S(-n)};
        const S top = math::square_root<S>(S(n + 1) / S(3 * n));
        std::array<S, 4> ends{S(0), S(1), S(1), S(1)};
        std::size_t last = 1;
        if (rise(top) > S(0)) {
            const auto half_tangent = [](const S& q) {
                return q / (S(1) + math::square_root<S>((S(1) - q) * (S(1) + q)));
            };
            ends[1] = half_tangent(math::bracketed_root<S>(rise, S(0), top, true));
            ends[2] = half_tangent(math::bracketed_root<S>(rise, top, S(1), false));
            last = 3;
        }
        for (std::size_t i = 0; i < last; ++i) {
            const bool rising = balance(ends[i]) < S(0);
            if (rising == (balance(ends[i + 1]) < S(0))) continue;
            result.add(math::bracketed_root<S>(balance, ends[i], ends[i + 1], rising));
        }
        result.add(S(1));
        return result;
    }

    /// The first z in (0, 1] at which f comes down to 0, or 2.
    template <class Function>
    [[nodiscard]] static S first_fall(const Function& f, const Borders& borders) {
        for (std::size_t i = 0; i + 1 < borders.count; ++i) {
            const S& low = borders.z[i];
            const S& high = borders.z[i + 1];
            if (f(high) > S(0)) continue;
            return f(low) > S(0) ? math::bracketed_root<S>(f, low, high, false) : low;
        }
        return S(2);
    }
};

}  // namespace detail

/// An edge without friction, for a ball that comes to it with the speeds [inwards] > 0 and [along]:
/// angular momentum about the hole and energy are kept. The zeros of push and speed are isolated
/// between their turns, so none is missed. Requires gravity > 0, rim > radius > 0.
template <math::Scalar S>
[[nodiscard]] Tipping<S> tip_frictionless(const S& gravity, const S& rim, const S& radius,
                                          const S& inwards, const S& along) {
    using Field = detail::TippingField<S>;
    const S unit = math::square_root<S>(gravity * radius);
    const Field field{S(rim / radius), S(inwards / unit), S(along / unit)};
    if (!(field.inwards < S(1))) {
        return {TippingOutcome::lift_off, S(0), S(1), inwards, along};
    }
    const typename Field::SpeedSquare speed_square{field};
    const S lost = Field::first_fall(typename Field::Push{field},
                                     field.borders(4, S(field.moment_square() * field.rim)));
    const S turn = Field::first_fall(speed_square, field.borders(3, field.moment_square()));
    if (turn < lost) return {TippingOutcome::back, S(0), S(1), S(-inwards), along};
    const bool lifts = lost < S(1);
    const RimPlace<S> p = field.at(lifts ? lost : S(1));
    const S square = speed_square(p.z);
    return {lifts ? TippingOutcome::lift_off : TippingOutcome::down, p.q, p.c,
            S(unit * math::square_root<S>(square > S(0) ? square : S(0))),
            S(along * field.rim / p.d)};
}

}  // namespace osculo::motion

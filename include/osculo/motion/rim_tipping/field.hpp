#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/polynomial.hpp"
#include "osculo/motion/rim_paper/field.hpp"

/// The motion of a ball that touches the edge of a hole (NUMERICS 3.5), as functions of
/// z = tan(tilt / 2). Lengths are in r. The edge may make the ball roll, so that what moves it has
/// to turn it too: with k m r^2 of inertia that takes n = 1 + k times as much, 1 if it slides.
/// Speeds are in sqrt(g r / n), in which the energy is
///
///   speed^2 = speed0^2 + 2 (c0 - c) - L^2 (1/d^2 - 1/d0^2)   around the edge; L / d along it
///
/// and the edge pushes with m g / n times n c - speed^2 + L^2 q / d^3.
namespace osculo::motion {

/// The two functions, and where they come down to zero. They turn where q d^m / c has a certain
/// value, which rises from 0 without end but for one stretch on which it may fall: between these
/// places they are monotone, so no zero of theirs is missed.
template <math::Scalar S>
struct TippingField {
    S rim;            ///< R
    S at_rim;         ///< speed^2 where the tilt is 0; < 0 if the ball does not get there
    S moment_square;  ///< L^2
    S heaviness{1};   ///< n

    [[nodiscard]] RimPlace<S> at(const S& z) const { return {z, S(S(1) - z), S(rim - S(1))}; }
    /// 1 - c.
    [[nodiscard]] static S drop(const S& z) { return S(2) * z * z / (S(1) + z * z); }

    struct SpeedSquare {
        static constexpr int kPower = 3;
        const TippingField& field;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return field.at_rim + S(2) * drop(z) -
                   field.moment_square * p.q * (field.rim + p.d) /
                       (field.rim * field.rim * p.d * p.d);
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return S(4) / (S(1) + z * z) * (p.q - field.moment_square * p.c / (p.d * p.d * p.d));
        }
        /// q d^3 / c where it turns.
        [[nodiscard]] S balance() const { return field.moment_square; }
    };
    struct Push {
        static constexpr int kPower = 4;
        const TippingField& field;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            const S& edge = field.rim;
            return (field.heaviness - field.at_rim) - (field.heaviness + S(2)) * drop(z) +
                   field.moment_square * p.q * (edge * edge + edge * p.d + p.d * p.d) /
                       (edge * edge * p.d * p.d * p.d);
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            const S dd = p.d * p.d;
            return S(2) / (S(1) + z * z) *
                   (S(3) * field.moment_square * field.rim * p.c / (dd * dd) -
                    (field.heaviness + S(2)) * p.q);
        }
        /// q d^4 / c where it turns.
        [[nodiscard]] S balance() const {
            return S(3) * field.moment_square * field.rim / (field.heaviness + S(2));
        }
    };

    /// Places from 0 to 1 in ascending order: both ends, and where a function turns.
    struct Borders {
        std::array<S, 5> z;
        std::size_t count = 0;
        void add(const S& at) { z[count++] = at; }
    };
    template <class Function>
    [[nodiscard]] Borders borders(const Function& f) const {
        constexpr int kPower = Function::kPower;
        Borders result;
        result.add(S(0));
        const Balance balance{*this, kPower, f.balance()};
        // q d^m / c falls where q (m + 1 - m q^2) > R.
        const math::Cubic<S> rise{S(-rim), S(kPower + 1), S(0), S(-kPower)};
        const S top = math::square_root<S>(S(kPower + 1) / S(3 * kPower));
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

private:
    /// q d^m - K c, whose zeros are those of a slope.
    struct Balance {
        const TippingField& field;
        int m;
        S constant;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return p.q * power(p.d, m) - constant * p.c;
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p = field.at(z);
            return S(2) / (S(1) + z * z) *
                   (p.c * power(p.d, m - 1) * (p.d - S(m) * p.q) + constant * p.q);
        }
        [[nodiscard]] static S power(const S& d, int n) {
            S result(1);
            for (int i = 0; i < n; ++i) result *= d;
            return result;
        }
    };
};

/// The first z on the way from [from] to the end, 1 or, [outwards], 0, at which f comes down to 0,
/// or 2 if it does not. f is not below 0 at the start but for rounding. [sign](i): that of f at the
/// border i.
template <math::Scalar S, class Function, class Sign>
[[nodiscard]] S first_fall(const Function& f, const typename TippingField<S>::Borders& borders,
                           const S& from, bool outwards, const Sign& sign) {
    S start = from;
    for (std::size_t n = 0; n < borders.count; ++n) {
        const std::size_t i = outwards ? borders.count - 1 - n : n;
        const S& end = borders.z[i];
        if (outwards ? end > start : end < start) continue;
        if (!(sign(i) > 0)) {
            if (!(f(start) > S(0)) || !(f(end) < S(0))) return f(start) > S(0) ? end : start;
            return outwards ? math::bracketed_root<S>(f, end, start, true)
                            : math::bracketed_root<S>(f, start, end, false);
        }
        start = end;
    }
    return S(2);
}

}  // namespace osculo::motion

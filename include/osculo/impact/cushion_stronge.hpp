#pragma once

#include "osculo/impact/tilted_plane.hpp"
#include "osculo/math/trigonometry.hpp"

namespace osculo::impact {

/// The tangential impulse of a compliant contact (W. J. Stronge, "Impact Mechanics", ch. 5; PHYSICS
/// 4, NUMERICS 7.3), for resolve_tilted_plane.
///
/// The contact is a normal and a tangential spring. With b = 1 + 1/k, rho the ratio of the
/// tangential to the normal frequency and a phase phi of the normal spring from 0 to pi, at time
/// phi in the compression and pi/2 + e (phi - pi/2) in the restitution (units of the normal
/// spring's; speeds in mu times the approach, lengths to match):
///
///     normal force sin phi;  the tangential spring x holds while |x| <= L = (b / rho^2) sin phi
///     sticking:  x' = g, g' = -rho^2 x           slipping:  x = +-L, g' = -+ b sin phi
///
/// g is the slip speed of the two surfaces far from the contact. The contact sticks at once if
/// g < b / rho^2, else when the slip has fallen to L', slips backwards (with a small e: forwards)
/// when L falls below |x| again, and stays so to the end. All phases are closed forms but for the
/// beginning of the second slip: |x| / L then rises through 1 once only, and bisected Newton steps
/// find where. No energy is gained: both springs end relaxed and friction opposes the slip.
template <math::Scalar S>
struct CompliantFriction {
    S restitution;      ///< e in [0, 1]
    S friction;         ///< mu >= 0
    S frequency_ratio;  ///< 1 < rho < 2
    S inertia;          ///< k > 0

    /// Impulse per mass. Relative error of the slip it leaves: about 40 epsilon of the slip before.
    [[nodiscard]] S operator()(const S& approach, const S& slip) const {
        const S& e = restitution;
        const S b = S(1) + S(1) / inertia;
        const S unit = friction * approach;
        if (!(unit > S(0))) return S(0);
        const S stiffness = b / (frequency_ratio * frequency_ratio);  // L / sin phi
        // g - L' falls to zero at a cosine of (g0 - b) / (stiffness - b) while L' = stiffness cos
        // phi, thereafter of (g0 - b) / (stiffness / e - e b).
        const S late = e * b - (e > S(0) ? S(stiffness / e) : S(0));
        const bool can_stick_late = e * frequency_ratio > S(1);
        const S latest = can_stick_late ? S(b + late) : b;
        const S g = slip / unit;
        if (!(g < latest)) return unit * (S(1) + e);

        Stick stick{};
        if (g <= stiffness) {
            stick = {S(0), g, math::quarter_turn<S>(), math::quarter_turn<S>()};
        } else if (g < b) {
            const S cosine = (b - g) / (b - stiffness);
            const S sine = math::square_root<S>((S(1) - cosine) * (S(1) + cosine));
            stick = {stiffness * sine, stiffness * cosine,
                     math::first_quadrant_angle<S>(cosine, sine), math::quarter_turn<S>()};
        } else {
            S cosine = (g - b) / late;
            if (cosine > S(1)) cosine = S(1);  // by rounding
            const S sine = math::square_root<S>((S(1) - cosine) * (S(1) + cosine));
            stick = {stiffness * sine, -stiffness / e * cosine, S(0),
                     math::first_quadrant_angle<S>(sine, cosine)};
        }
        return unit * (g - slip_after(stick, stiffness, b)) / b;
    }

private:
    /// A sticking contact from its beginning: spring, speed, how long the compression still lasts
    /// and what is left of phi from there (or from here, if that is later) to its end.
    struct Stick {
        S spring;
        S speed;
        S to_turn;
        S phase_left;

        [[nodiscard]] S spring_at(const S& rho, const math::SinCos<S>& a) const {
            return spring * a.cos + speed / rho * a.sin;
        }
        [[nodiscard]] S speed_at(const S& rho, const math::SinCos<S>& a) const {
            return speed * a.cos - rho * spring * a.sin;
        }
    };

    [[nodiscard]] S slip_after(const Stick& stick, const S& stiffness, const S& b) const {
        const S& e = restitution;
        const S& rho = frequency_ratio;
        const auto swing = [&](const S& left) {
            return math::sin_cos<S>(rho * (stick.to_turn + e * (stick.phase_left - left)));
        };
        // In w = pi - phi, from phase_left down to 0: the bound's excess over the spring is
        // positive above the root and negative below.
        const S end = stick.spring_at(rho, swing(S(0)));
        const S side = end < S(0) ? S(-1) : S(1);
        S below(0);
        S above = stick.phase_left;
        S w = above * S(0.5);
        S step = above;
        for (int i = 0; i < 4 * math::ScalarTraits<S>::kDigits; ++i) {
            const auto phase = math::sin_cos<S>(w);
            const auto a = swing(w);
            const S excess = stiffness * phase.sin - side * stick.spring_at(rho, a);
            (excess < S(0) ? below : above) = w;
            const S slope = stiffness * phase.cos + side * e * stick.speed_at(rho, a);
            const S last = step;
            S next = w - excess / slope;
            // Newton's step, unless it leaves the bracket or does not halve the last one.
            if (!(next > below && next < above && math::abs<S>(next - w) < S(0.5) * last)) {
                next = below + (above - below) * S(0.5);
            }
            step = math::abs<S>(next - w);
            w = next;
            if (!(step > S(2) * math::epsilon<S>() * w)) break;
        }
        const auto half = math::sin_cos<S>(S(0.5) * w);
        // 1 - cos w = 2 sin^2(w / 2).
        return stick.speed_at(rho, swing(w)) - side * b * e * S(2) * half.sin * half.sin;
    }
};

/// A cushion with normal and tangential compliance, at the height h of its nose (h = r: upright, as
/// the literature and the recorded shots have it): a ball that slips little is flung back
/// sideways, so it can leave with its english reversed.
template <math::Scalar S>
struct CushionStronge {
    static constexpr const char* kName = "stronge";

    S restitution;           ///< e in [0, 1]
    S friction;              ///< mu >= 0
    S height;                ///< h [m] of the nose above the table, 0 < h < 2 r
    S frequency_ratio{1.8};  ///< of the tangential to the normal oscillation, 1 < rho < 2

    /// [normal], preconditions: as resolve_tilted_plane.
    void resolve(const math::Vec<S>& normal, SpinningBall<S>& ball) const {
        resolve_tilted_plane<S>(
            restitution, (height - ball.radius) / ball.radius, normal, ball,
            CompliantFriction<S>{restitution, friction, frequency_ratio, ball.inertia});
    }
};

}  // namespace osculo::impact

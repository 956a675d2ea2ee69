#pragma once

#include "osculo/impact/spinning_ball.hpp"
#include "osculo/math/trigonometry.hpp"

namespace osculo::impact {

/// Why a strike is impossible.
enum class StrikeFault {
    none,
    speed,      ///< not positive (or not a number)
    elevation,  ///< not in [0, pi/2]
    outside,    ///< the tip would pass beside the ball
    miscue      ///< the tip would slip off the ball
};

/// A cue striking a ball at rest (PHYSICS 4, NUMERICS 7.4; D. Alciatore, TP A.30, squirt TP A.31).
///
/// The tip meets the ball at the offsets a to the left and b upwards, in radii and seen along the
/// cue; the impulse has the direction d of the cue. With restitution e between tip and ball,
/// measured along d,
///
///     v = (1 + e) V / (1 + m/M + (a^2 + b^2) / k)                          TP A.30: e = 1
///     velocity = v cos(elevation) along the azimuth, turned by squirt
///     spin = v / (k r) (b left - a sin(elevation) forward - a cos(elevation) up)
///     tan(squirt) = -(a/k) sqrt(1 - a^2) / (1 + m / m_end + (1 - a^2) / k)
///
/// for inertia k m r^2 of the ball; the downward part of the velocity is dropped, for the ball lies
/// on the table. Only the velocity squirts, the spin keeps the cue's frame.
template <math::Scalar S>
struct CueStrike {
    S speed;         ///< V > 0 of the cue [m/s]
    S azimuth;       ///< of the shot, from x towards y [rad]
    S elevation;     ///< of the cue's butt, 0 .. pi/2 [rad]
    S side;          ///< a, positive to the left of the shot
    S height;        ///< b, positive upwards
    S mass;          ///< M > 0 of the cue [kg]
    S end_mass;      ///< of the part of the cue that is pushed aside [kg]; 0: no squirt
    S restitution;   ///< e of the tip in [0, 1]; 1 loses nothing
    S miscue_limit;  ///< largest sqrt(a^2 + b^2); 1 allows every strike

    static constexpr double kMiscueLimit = 0.55;

    [[nodiscard]] StrikeFault fault() const {
        if (!(speed > S(0))) return StrikeFault::speed;
        // pi/2 rounded down to double: nothing in between is meant.
        if (!(elevation >= S(0)) || !(elevation < S(1.5707963267948968))) {
            return StrikeFault::elevation;
        }
        // First without squares, which may overflow.
        if (!(math::abs<S>(side) < S(1)) || !(math::abs<S>(height) < S(1))) {
            return StrikeFault::outside;
        }
        const S offset = side * side + height * height;
        if (!(offset < S(1))) return StrikeFault::outside;
        if (offset > miscue_limit * miscue_limit) return StrikeFault::miscue;
        return StrikeFault::none;
    }

    /// Sets velocity and spin. Requires fault() == none. Relative error <= 12 epsilon of the speed
    /// and the spin, besides that of the sines and cosines.
    void resolve(SpinningBall<S>& ball) const {
        const auto [sin_azimuth, cos_azimuth] = math::sin_cos<S>(azimuth);
        const auto [sin_elevation, cos_elevation] = math::sin_cos<S>(elevation);
        const S k = ball.inertia;
        const S v = (S(1) + restitution) * speed /
                    (S(1) + ball.mass / mass + (side * side + height * height) / k);

        const S depth_squared = (S(1) - side) * (S(1) + side);  // 1 - a^2
        const S squirt = -(side / k) * math::square_root<S>(depth_squared) * end_mass /
                         (end_mass + ball.mass + depth_squared / k * end_mass);
        // (cos, sin) of atan(squirt), |squirt| < 1 / sqrt(k).
        const S along = S(1) / math::square_root<S>(S(1) + squirt * squirt);
        const math::Vec<S> forward(cos_azimuth, sin_azimuth);
        const math::Vec<S> left(-sin_azimuth, cos_azimuth);
        ball.velocity = (v * cos_elevation * along) * (forward + squirt * left);

        const S rate = v / (k * ball.radius);
        const math::Vec<S> spin = rate * (height * left - (side * sin_elevation) * forward);
        ball.spin = math::Vec3<S>(spin.x(), spin.y(), -rate * side * cos_elevation);
    }
};

}  // namespace osculo::impact

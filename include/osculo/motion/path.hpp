#pragma once

#include "osculo/math/vec.hpp"

namespace osculo::motion {

/// Straight uniform motion: at position + velocity t, t [s] counted from the path's own start.
template <math::Scalar S>
struct LinearPath {
    math::WidePoint<S> position;  ///< [m]
    math::Vec<S> velocity;        ///< [m/s]

    /// Moves the start of the path on by t [s].
    void shift(const S& t) { position = math::displaced<S>(position, velocity, t); }

    [[nodiscard]] bool stands() const { return velocity.x() == S(0) && velocity.y() == S(0); }
};

/// Constant acceleration: at position + velocity t + half_acceleration t^2 for 0 <= t <= end.
template <math::Scalar S>
struct ParabolicPath {
    math::WidePoint<S> position;     ///< [m]
    math::Vec<S> velocity;           ///< [m/s]
    math::Vec<S> half_acceleration;  ///< [m/s^2]
    S end;                           ///< [s]; may be infinite if there is no acceleration

    /// Moves the start of the path on by t [s] <= end.
    void shift(const S& t) {
        position = math::displaced<S>(position, velocity, half_acceleration, t);
        velocity += (S(2) * t) * half_acceleration;
        end = end > t ? S(end - t) : S(0);
    }

    [[nodiscard]] bool stands() const {
        return velocity.x() == S(0) && velocity.y() == S(0) && half_acceleration.x() == S(0) &&
               half_acceleration.y() == S(0);
    }
};

}  // namespace osculo::motion

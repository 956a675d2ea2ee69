#pragma once

#include "osculo/motion/resisted.hpp"

namespace osculo::motion {

/// A disc that slides on its face (an air hockey puck, a coin) or a ball in free flight: it slows
/// down as Resisted says, and nothing but impacts changes how it turns about the vertical.
struct Disc : Resisted {
    static constexpr const char* kName = "disc";
    static constexpr bool kSpin = true;

    template <math::Scalar S>
    struct State : Resisted::State<S> {
        math::Vec3<S> spin{S(0), S(0), S(0)};  ///< [rad/s]; about the vertical only: (0, 0, wz)
        S radius{1};                           ///< [m]
        S inertia{S(1) / S(2)};                ///< k = I / (m R^2): 1/2 for a uniform disc
    };
};

}  // namespace osculo::motion

#pragma once

#include "osculo/math/exponential.hpp"

namespace osculo::impact {

/// Coefficient of sliding friction at the slip speed u [m/s]: mu(u) = a + b e^(-c u), c in [s/m];
/// constant for b = 0. Alciatore's fit of Marlow's measurements of pool balls (TP A.14, TP A.28):
/// a = 0.009951, b = 0.108, c = 1.088. All three >= 0.
///
/// Error <= (2 |mu| + kExponentialError b) epsilon. The exponential is formed by arithmetic alone,
/// so the bits are the same everywhere.
template <math::Scalar S>
struct Friction {
    S a{0};
    S b{0};
    S c{0};

    [[nodiscard]] S operator()(const S& slip_speed) const {
        if (!(b > S(0))) return a;
        return a + b * math::decaying_exponential<S>(c * slip_speed);
    }
};

}  // namespace osculo::impact

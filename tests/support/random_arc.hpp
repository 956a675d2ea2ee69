#pragma once

#include <cmath>

#include "osculo/geometry/arc.hpp"
#include "support/random.hpp"

namespace osculo::support {

/// An arc around the origin, half to three times as large as 1; one in [one_full_in] is full.
[[nodiscard]] inline geometry::Arc<double> random_arc(Random& random, int one_full_in) {
    const double start = random.uniform<double>(0, 6.28);
    const double sweep = random.uniform<double>(0.1, 6.2);
    const bool full = random.below(one_full_in) == 0;
    return {math::Vec<double>(0, 0),
            random.uniform<double>(0.5, 3),
            math::Vec<double>(std::cos(start), std::sin(start)),
            math::Vec<double>(std::cos(start + sweep), std::sin(start + sweep)),
            sweep > 3.141592653589793,
            full};
}

}  // namespace osculo::support

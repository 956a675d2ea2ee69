#pragma once

#include <cmath>

#include "support/builder.hpp"
#include "support/random.hpp"

namespace osculo::support {

/// Disks of one size at random, on a jittered lattice in the unit square, all moving, covering
/// [density] of it (up to 0.5). Walls included.
template <class Type>
[[nodiscard]] Builder<Type> gas(int disks, double density, std::uint64_t seed) {
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;
    Random random(seed);
    Builder<Type> builder;
    builder.box(S(0), S(0), S(1), S(1));
    const double radius = std::sqrt(density / (disks * 3.141592653589793));
    const int columns = static_cast<int>(std::ceil(std::sqrt(disks)));
    const double spacing = 1.0 / columns;
    const double room = spacing / 2 - radius;
    for (int k = 0; k < disks; ++k) {
        const double x = (k % columns + 0.5) * spacing + random.uniform<double>(-room, room);
        const double y = (k / columns + 0.5) * spacing + random.uniform<double>(-room, room);
        const S vx = random.signed_unit<S>();
        builder.ball(Vec(S(x), S(y)), Vec(vx, random.signed_unit<S>()), S(radius));
    }
    return builder;
}

}  // namespace osculo::support

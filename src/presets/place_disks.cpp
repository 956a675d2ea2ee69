#include "presets/place_disks.hpp"

#include <cmath>

namespace osculo::presets {

double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

Point random_in_disk(std::mt19937_64& random) {
    for (;;) {
        const double x = 2 * uniform(random) - 1;
        const double y = 2 * uniform(random) - 1;
        if (x * x + y * y <= 1) return {x, y};
    }
}

Point random_direction(std::mt19937_64& random) {
    for (;;) {
        const auto [x, y] = random_in_disk(random);
        const double squared = x * x + y * y;
        if (squared > 0.01) {
            const double length = std::sqrt(squared);
            return {x / length, y / length};
        }
    }
}

std::vector<Point> place_disks(std::uint32_t count, double radius, std::mt19937_64& random) {
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
    const std::uint32_t rows = (count + columns - 1) / columns;
    const double width = 1.0 / columns;
    const double height = 1.0 / rows;
    // A thousandth less than there is, so that rounding never makes neighbours overlap.
    const double room_x = 0.999 * (width - 2 * radius);
    const double room_y = 0.999 * (height - 2 * radius);
    if (!(room_x > 0 && room_y > 0)) return {};

    std::vector<Point> centers;
    centers.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double shake_x = uniform(random) - 0.5;
        const double shake_y = uniform(random) - 0.5;
        centers.push_back({(i % columns + 0.5) * width + shake_x * room_x,
                           (i / columns + 0.5) * height + shake_y * room_y});
    }
    return centers;
}

}  // namespace osculo::presets

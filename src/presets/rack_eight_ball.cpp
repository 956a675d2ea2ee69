#include <array>
#include <cmath>
#include <string>

#include "presets/tables.hpp"

namespace osculo::presets {

// The rules ask for the 8 in the middle of the third row and a solid and a striped ball in the two
// corners of the last [WPA rules of eight-ball]; the rest of the order is free.
void add_eight_ball(Scene& scene, const Bed& bed, double gap) {
    constexpr std::array<std::array<int, 5>, 5> kRows{
        {{1}, {9, 2}, {3, 8, 10}, {11, 7, 14, 4}, {5, 13, 15, 6, 12}}};
    const double spacing = 2 * kPoolBallRadius + gap;
    const double row_height = spacing * std::sqrt(0.75);
    for (std::size_t row = 0; row < kRows.size(); ++row) {
        const auto rows_up = static_cast<double>(row);
        for (std::size_t column = 0; column <= row; ++column) {
            const double columns_right = static_cast<double>(column) - rows_up / 2;
            Ball ball;
            ball.id = std::to_string(kRows[row][column]);
            ball.mass = kPoolBallMass;
            ball.radius = kPoolBallRadius;
            ball.position = {bed.width / 2 + columns_right * spacing,
                             0.75 * bed.length + rows_up * row_height};
            scene.balls.push_back(ball);
        }
    }
}

}  // namespace osculo::presets

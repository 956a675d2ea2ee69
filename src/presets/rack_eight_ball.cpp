#include <array>

#include "presets/racks.hpp"

namespace osculo::presets {

// The rules ask for the 8 in the middle of the third row and a solid and a striped ball in the two
// corners of the last [WPA rules of eight-ball]; the rest of the order is free.
void add_eight_ball(Scene& scene, const Bed& bed, const RackOptions& options) {
    constexpr std::array<std::array<int, 5>, 5> kRows{
        {{1}, {9, 2}, {3, 8, 10}, {11, 7, 14, 4}, {5, 13, 15, 6, 12}}};
    Racker racker(scene, bed, kPoolBallMass, kPoolBallRadius, options);
    for (std::size_t row = 0; row < kRows.size(); ++row) {
        const auto rows_up = static_cast<double>(row);
        for (std::size_t column = 0; column <= row; ++column) {
            const double columns_right = static_cast<double>(column) - rows_up / 2;
            racker.add_shaken(std::to_string(kRows[row][column]),
                              {bed.width / 2 + columns_right * racker.spacing(),
                               0.75 * bed.length + rows_up * racker.row_height()});
        }
    }
    racker.add_cue({bed.width / 2, bed.length / 4});
}

}  // namespace osculo::presets

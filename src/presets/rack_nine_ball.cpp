#include <array>
#include <cmath>

#include "presets/racks.hpp"

namespace osculo::presets {

// The 1 at the apex on the foot spot and the 9 in the middle of the diamond, the others anywhere
// [WPA rules of nine-ball].
void add_nine_ball(Scene& scene, const Bed& bed, const RackOptions& options) {
    struct Row {
        int count;
        std::array<int, 3> balls;
    };
    constexpr std::array<Row, 5> kRows{
        {{1, {1}}, {2, {2, 3}}, {3, {4, 9, 5}}, {2, {6, 7}}, {1, {8}}}};
    Racker racker(scene, bed, kPoolBallMass, kPoolBallRadius, options);
    double rows_up = 0;
    for (const Row& row : kRows) {
        for (int column = 0; column < row.count; ++column) {
            const double columns_right = column - (row.count - 1) / 2.0;
            racker.add_shaken(std::to_string(row.balls[static_cast<std::size_t>(column)]),
                              {bed.width / 2 + columns_right * racker.spacing(),
                               0.75 * bed.length + rows_up * racker.row_height()});
        }
        ++rows_up;
    }
    racker.add_cue({bed.width / 2, bed.length / 4});
}

}  // namespace osculo::presets

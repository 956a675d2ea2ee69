#include <numbers>

#include "presets/pocketed_table.hpp"

// Noses, jaws and pockets of the 7 ft table of pooltool, commit 9a8abfe, whose makers measured a
// Showood table. The bed is 0.9906 m x 1.9812 m (39 in x 78 in), the cushions are 0.0508 m (2 in)
// deep. The numbers are kept as they are there, to the last bit: recorded shots refer to them.

namespace osculo::presets {
namespace {

constexpr double kPi = std::numbers::pi;

// The jaws turn by 90 degrees less 45 + 5.3 at corners, and by 90 less 7.14 at the sides.
constexpr double kCornerTurn = 39.7 * kPi / 180;
constexpr double kSideTurn = 82.86 * kPi / 180;

constexpr PocketedTable kTable{.bed = kPool7ft,
                               .corner = {.rail_end = {0.09100172278778172, 0},
                                          .center = {0.09100172278778172, -0.02095},
                                          .radius = 0.02095,
                                          .rail_angle = kPi / 2,
                                          .jaw_angle = kPi / 2 + kCornerTurn,
                                          .jaw_end = {0.07761953701082995, -0.00483107932176755},
                                          .tip = {0.022249704426935857, -0.0508}},
                               .side = {.rail_end = {0, 0.91508373076875},
                                        .center = {-0.00795, 0.91508373076875},
                                        .radius = 0.00795,
                                        .rail_angle = 0,
                                        .jaw_angle = kSideTurn,
                                        .jaw_end = {-0.00696186091167262, 0.9229720817461166},
                                        .tip = {-0.0508, 0.9284141466272995}},
                               .corner_pocket = {-0.029486352775479032, -0.029486352775479032},
                               .corner_pocket_radius = 0.062,
                               .side_pocket = {-0.0685, 0.9906},
                               .side_pocket_radius = 0.0645};

}  // namespace

void add_pool_7ft(Scene& scene) {
    add_pocketed_table(scene, kTable);
}

}  // namespace osculo::presets

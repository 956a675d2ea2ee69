#include <numbers>

#include "presets/pocketed_table.hpp"

// Tables as the World Pool-Billiard Association asks for them [WPA equipment specifications:
// playing surface, rail and cushion, pocket openings and measurements], in the middle of what it
// allows:
//
//   bed            9 ft: 100 in x 50 in; 8 ft: 92 in x 46 in (many tables at home called 8 ft are
//                  88 in x 44 in)
//   cushions       1 7/8 to 2 in from the nose to the back: 2 in
//   corner pocket  mouth 4 1/2 to 4 5/8 in, cut angle 142 degrees, shelf 1 to 2 1/4 in
//   side pocket    mouth 5 to 5 1/8 in, cut angle 104 degrees, shelf 0 to 3/8 in
//
// It does not say how round the noses of the jaws and how wide the holes in the slate are: these
// are those of the 7 ft table that was measured (table_pool_7ft.cpp).

namespace osculo::presets {
namespace {

constexpr double kInch = 0.0254;
constexpr double kDegree = std::numbers::pi / 180;

constexpr double kCushionDepth = 2 * kInch;
constexpr PocketCut kCorner{.mouth = 4.5625 * kInch,
                            .turn = (180 - 142) * kDegree,
                            .nose_radius = 0.02095,
                            .shelf = 1.625 * kInch,
                            .pocket_radius = 0.062};
constexpr PocketCut kSide{.mouth = 5.0625 * kInch,
                          .turn = (180 - 104) * kDegree,
                          .nose_radius = 0.00795,
                          .shelf = 0.1875 * kInch,
                          .pocket_radius = 0.0645};

}  // namespace

void add_pool_8ft(Scene& scene) {
    add_pocketed_table(scene, cut_pockets(kPool8ft, kCushionDepth, kCorner, kSide));
}

void add_pool_9ft(Scene& scene) {
    add_pocketed_table(scene, cut_pockets(kPool9ft, kCushionDepth, kCorner, kSide));
}

}  // namespace osculo::presets

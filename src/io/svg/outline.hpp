#pragma once

#include <vector>

#include "io/svg/view.hpp"

namespace osculo::io::svg {

/// The outline of a closed table as far as a picture needs it.
struct Outline {
    std::vector<std::vector<Point>> cushions;  ///< their noses; pockets lie in between
    std::vector<Point> bed;                    ///< the noses joined across the pockets
    Box back;                                  ///< the backs of the cushions
    Box frame;                                 ///< around them and the rims
    double depth = 0;                          ///< from a nose to the back [m]
    std::vector<bool> has_segment;             ///< which segments of the scene are part of it
    std::vector<bool> has_arc;
};

/// The outline around the balls of a closed scene; empty (no bed) if the scene is not closed.
[[nodiscard]] Outline outline_of(const Scene& scene);

/// Points along an arc, fine enough for a picture.
[[nodiscard]] std::vector<Point> points_along(const Arc& arc);
[[nodiscard]] bool is_full_circle(const Arc& arc);

}  // namespace osculo::io::svg

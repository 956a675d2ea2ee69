#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "osculo/scene.hpp"

namespace osculo::io::svg {

/// Colours of a picture.
struct Look {
    bool is_billiards = false;  ///< cloth, wood and the colours of their balls
    std::string_view frame;
    std::string_view cushion;
    std::string_view nose;
    std::string_view bed;
    std::string_view arrow;
    std::string_view contact;       ///< dots
    std::string_view contact_text;  ///< their numbers
    std::string_view contact_halo;  ///< around the numbers
};

/// Billiards if every ball has the id of a pool, snooker or carom ball, else plain and light.
[[nodiscard]] Look look_of(const Scene& scene);

struct BallColor {
    std::string_view color;
    bool striped = false;
    bool is_light = false;  ///< needs a dark outline and dark figures
};

/// Of every ball: by id in billiards, otherwise in turn from a palette that colour-blind people can
/// tell apart.
[[nodiscard]] std::vector<BallColor> ball_colors(const Scene& scene, const Look& look);

}  // namespace osculo::io::svg

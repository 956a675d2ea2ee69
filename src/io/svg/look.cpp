#include "io/svg/look.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace osculo::io::svg {
namespace {

constexpr Look kBilliards{.is_billiards = true,
                          .frame = "#5a3a22",
                          .cushion = "#124a33",
                          .nose = "#2f8f68",
                          .bed = "#1b6f4d",
                          .arrow = "#ffe08a",
                          .contact = "#ffffff",
                          .contact_text = "#ffffff",
                          .contact_halo = "#0d3a27"};

constexpr Look kPlain{.is_billiards = false,
                      .frame = "#dfe4ea",
                      .cushion = "#aab4c0",
                      .nose = "#4d5866",
                      .bed = "#fbfbf9",
                      .arrow = "#222222",
                      .contact = "#222222",
                      .contact_text = "#222222",
                      .contact_halo = "#ffffff"};

// Solids 1 to 8; 9 to 15 are stripes of the first seven.
constexpr std::array<std::string_view, 8> kPoolColors{"#f2c230", "#2456b8", "#d6302b", "#6a3fa0",
                                                      "#f07c22", "#25b577", "#8c2332", "#1c1c1c"};

struct NamedColor {
    std::string_view id;
    BallColor color;
};
constexpr std::array kNamed{
    NamedColor{"cue", {"#f7f4ea", false, true}},    NamedColor{"white", {"#f7f4ea", false, true}},
    NamedColor{"yellow", {"#f2c230", false, true}}, NamedColor{"red", {"#d6302b", false, false}},
    NamedColor{"green", {"#1f9d55", false, false}}, NamedColor{"brown", {"#7a4a21", false, false}},
    NamedColor{"blue", {"#2456b8", false, false}},  NamedColor{"pink", {"#f29bb2", false, true}},
    NamedColor{"black", {"#1c1c1c", false, false}},
};

// The eight colours of Okabe and Ito (2008) without black, and with a darker yellow.
constexpr std::array<std::string_view, 7> kPalette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                   "#e69f00", "#56b4e9", "#b8a800"};

std::optional<BallColor> billiard_color(std::string_view id) {
    const auto named = std::ranges::find(kNamed, id, &NamedColor::id);
    if (named != kNamed.end()) return named->color;
    if (id.starts_with("red-")) return billiard_color("red");
    for (std::size_t number = 1; number <= 15; ++number) {
        if (id != std::to_string(number)) continue;
        const bool striped = number > 8;
        return BallColor{kPoolColors[striped ? number - 9 : number - 1], striped, false};
    }
    return std::nullopt;
}

}  // namespace

Look look_of(const Scene& scene) {
    const bool all = std::ranges::all_of(
        scene.balls, [](const Ball& ball) { return billiard_color(ball.id).has_value(); });
    return all && !scene.balls.empty() && scene.closed ? kBilliards : kPlain;
}

std::vector<BallColor> ball_colors(const Scene& scene, const Look& look) {
    std::vector<BallColor> colors;
    colors.reserve(scene.balls.size());
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const auto color =
            look.is_billiards ? billiard_color(scene.balls[i].id) : std::optional<BallColor>();
        colors.push_back(color.value_or(BallColor{kPalette[i % kPalette.size()]}));
    }
    return colors;
}

}  // namespace osculo::io::svg

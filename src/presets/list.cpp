#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

#include "presets/nearest_name.hpp"
#include "presets/parameters.hpp"
#include "presets/scenes.hpp"

namespace osculo::presets {
namespace {

constexpr std::array kInfos{
    Info{"box", "balls in an empty box of 1 m x 1 m",
         "balls (1, up to 100), speed (1), restitution (1), seed (2)"},
    Info{"carom", "three balls on a 10 ft carom table, one moving", "speed (4), restitution (1)"},
    Info{"cradle", "Newton's cradle: balls in a row, struck by the first",
         "balls (5, 3 to 15), gap (0), speed (1), restitution (1)"},
    Info{"pi", "Galperin's billiard: as many collisions as the first digits of pi",
         "digits (3, 1 to 7), speed (1)"},
    Info{"break", "the break of fifteen balls on a 7 ft pool table, without friction",
         "gap (1e-4), speed (9), restitution (1)"},
    Info{"gas", "disks in a square box with Maxwell's velocities",
         "balls (100), packing (0.3, up to 0.6), speed (1), restitution (1), seed (1)"},
};

using Maker = Scene (*)(const Parameters&);
constexpr std::array<Maker, kInfos.size()> kMakers{make_box, make_carom, make_cradle,
                                                   make_pi,  make_break, make_gas};

void refuse_unused(const Info& info, const Parameters& parameters) {
    const auto check = [&info](std::string_view name, bool is_given) {
        // The description names each parameter followed by its default in brackets.
        const std::string entry = std::string(name) + " (";
        if (!is_given || info.parameters.find(entry) != std::string_view::npos) return;
        throw SceneError(std::string(name),
                         "is not a parameter of the preset " + std::string(info.name) +
                             ", which takes " + std::string(info.parameters),
                         "");
    };
    check("balls", parameters.balls.has_value());
    check("packing", parameters.packing.has_value());
    check("gap", parameters.gap.has_value());
    check("speed", parameters.speed.has_value());
    check("restitution", parameters.restitution.has_value());
    check("digits", parameters.digits.has_value());
    check("seed", parameters.seed.has_value());
}

}  // namespace

std::string number_text(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};
}

std::span<const Info> list() {
    return kInfos;
}

Scene make(std::string_view name, const Parameters& parameters) {
    const auto found = std::ranges::find(kInfos, name, &Info::name);
    if (found == kInfos.end()) {
        std::array<std::string_view, kInfos.size()> names;
        std::ranges::transform(kInfos, names.begin(), &Info::name);
        throw SceneError("preset", "must be the name of a preset" + did_you_mean(name, names),
                         std::string(name));
    }
    refuse_unused(*found, parameters);
    return kMakers[static_cast<std::size_t>(found - kInfos.begin())](parameters);
}

}  // namespace osculo::presets

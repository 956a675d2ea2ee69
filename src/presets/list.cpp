#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

#include "presets/nearest_name.hpp"
#include "presets/parameters.hpp"
#include "presets/scenes.hpp"

namespace osculo::presets {
namespace {

// Made in one of two ways.
using Make = Scene (*)(const Parameters&);
using MakeShot = Shot (*)(const Parameters&);
struct Preset {
    Info info;
    Make make;
    MakeShot make_shot;
};

constexpr std::array kPresets{
    Preset{{"break", "the break of eight-ball on a 9 ft pool table",
            "speed (8, of the cue), gap (1e-4), seed (31)"},
           nullptr,
           break_shot},
    Preset{{"nine-ball", "the break of nine-ball on a 9 ft pool table",
            "speed (8, of the cue), gap (1e-4), seed (10)"},
           nullptr,
           nine_ball_shot},
    Preset{{"snooker-break", "a safe break on a 12 ft snooker table",
            "speed (3, of the cue), gap (1e-4), seed (1)"},
           nullptr,
           snooker_break_shot},
    Preset{{"three-cushion", "the opening shot of three-cushion on a 10 ft carom table",
            "speed (3.5, of the cue)"},
           nullptr,
           three_cushion_shot},
    Preset{{"frictionless-break",
            "the break of fifteen balls on a 7 ft pool table, without any friction",
            "gap (1e-4), speed (9), restitution (1)"},
           make_frictionless_break,
           nullptr},
    Preset{{"carom", "three balls on a 10 ft carom table, one moving, without any friction",
            "speed (4), restitution (1)"},
           make_carom,
           nullptr},
    Preset{{"box", "balls in an empty box of 1 m x 1 m",
            "balls (1, up to 100), speed (1), restitution (1), seed (2)"},
           make_box,
           nullptr},
    Preset{{"cradle", "Newton's cradle: balls in a row, struck by the first",
            "balls (5, 3 to 15), gap (0), speed (1), restitution (1)"},
           make_cradle,
           nullptr},
    Preset{{"pi", "Galperin's billiard: as many collisions as the first digits of pi",
            "digits (3, 1 to 7), speed (1)"},
           make_pi,
           nullptr},
    Preset{{"gas", "disks in a square box with Maxwell's velocities",
            "balls (100), packing (0.3, up to 0.6), speed (1), restitution (1), seed (1)"},
           make_gas,
           nullptr},
    Preset{{"stage-funnel", "a hall that narrows towards its hole, with posts in the way",
            "speed (3), restitution (0.85)"},
           make_stage_funnel,
           nullptr},
    Preset{{"stage-islands", "a bent room with islands and three holes",
            "speed (4), restitution (0.85)"},
           make_stage_islands,
           nullptr},
    Preset{{"stage-bumpers", "an octagon of bumpers with four holes and one heavy ball",
            "speed (5), restitution (0.9)"},
           make_stage_bumpers,
           nullptr},
};

constexpr auto kInfos = [] {
    std::array<Info, kPresets.size()> infos;
    std::ranges::transform(kPresets, infos.begin(), &Preset::info);
    return infos;
}();

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

// The preset of that name, which takes those parameters.
const Preset& preset_for(std::string_view name, const Parameters& parameters) {
    const auto found = std::ranges::find(kInfos, name, &Info::name);
    if (found == kInfos.end()) {
        std::array<std::string_view, kInfos.size()> names;
        std::ranges::transform(kInfos, names.begin(), &Info::name);
        throw SceneError("preset", "must be the name of a preset" + did_you_mean(name, names),
                         std::string(name));
    }
    refuse_unused(*found, parameters);
    return kPresets[static_cast<std::size_t>(found - kInfos.begin())];
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
    const Preset& preset = preset_for(name, parameters);
    return preset.make != nullptr ? preset.make(parameters)
                                  : scene_of(preset.make_shot(parameters));
}

std::optional<std::string> short_text(std::string_view name, const Parameters& parameters) {
    const Preset& preset = preset_for(name, parameters);
    if (preset.make_shot == nullptr) return std::nullopt;
    const Shot shot = preset.make_shot(parameters);
    static_cast<void>(scene_of(shot));  // throws if a parameter is out of range
    return text_of(shot);
}

}  // namespace osculo::presets

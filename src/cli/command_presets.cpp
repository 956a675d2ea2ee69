#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "osculo/io.hpp"
#include "osculo/presets.hpp"

namespace osculo::cli {
namespace {

struct PresetArguments {
    std::string name;
    std::string output = "-";
    presets::Parameters parameters;
};

std::string listing() {
    std::string text;
    for (const presets::Info& info : presets::list()) {
        text +=
            fmt::format("{:<20}{}\n{:<20}{}\n", info.name, info.description, "", info.parameters);
    }
    return text;
}

// As short as can be: what a table, a rack and a strike say in three lines is not spelled out.
void write_preset(const PresetArguments& arguments) {
    try {
        const auto text = presets::short_text(arguments.name, arguments.parameters);
        save_json(
            arguments.output,
            text ? *text : io::scene_to_json(presets::make(arguments.name, arguments.parameters)));
    } catch (const SceneError& error) {
        throw Failure(kInvalidScene, "preset:" + arguments.name + ": " + error.what());
    }
}

}  // namespace

void add_presets(CLI::App& app) {
    auto* const command = app.add_subcommand("presets", "List the preset scenes, or write one");
    const auto arguments = std::make_shared<PresetArguments>();
    presets::Parameters& parameters = arguments->parameters;
    command->add_option("name", arguments->name, "preset to write")->option_text("NAME");
    command->add_option("-o,--output", arguments->output, "where to write (.json, .msgpack)")
        ->option_text("FILE [-]");
    command->add_option("--balls", parameters.balls, "number of balls")->option_text("N");
    command->add_option("--packing", parameters.packing, "fraction of the area covered")
        ->option_text("F");
    command->add_option("--gap", parameters.gap, "between neighbouring balls [m]")
        ->option_text("M");
    command->add_option("--speed", parameters.speed, "of what moves at the start [m/s]")
        ->option_text("V");
    command->add_option("--restitution", parameters.restitution, "of every contact, 0 to 1")
        ->option_text("E");
    command->add_option("--digits", parameters.digits, "digits of pi")->option_text("N");
    command->add_option("--seed", parameters.seed, "of everything random")
        ->option_text("N")
        ->check(CLI::NonNegativeNumber);
    command->footer(
        "Examples:\n"
        "  osculo presets\n"
        "  osculo presets break > break.json\n"
        "  osculo presets gas --balls 1000 --packing 0.5 --seed 7 > gas.json");
    command->callback([arguments] {
        if (arguments->name.empty()) {
            write_output(listing());
        } else {
            write_preset(*arguments);
        }
    });
}

}  // namespace osculo::cli

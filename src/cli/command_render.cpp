#include <memory>

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "osculo/io.hpp"

namespace osculo::cli {
namespace {

struct RenderArguments {
    std::string input;
    std::string output = "-";
    io::SvgOptions svg;
};

void render(const RenderArguments& arguments) {
    const auto loaded = load_scene_or_run(arguments.input);
    save_text(arguments.output,
              std::visit(
                  [&](const auto& scene_or_run) { return io::to_svg(scene_or_run, arguments.svg); },
                  loaded));
}

}  // namespace

void add_render(CLI::App& app) {
    auto* const command = app.add_subcommand("render", "Draw a scene or a run as SVG");
    const auto arguments = std::make_shared<RenderArguments>();
    command->add_option("input", arguments->input, "scene or run file, - or preset:NAME")
        ->required()
        ->option_text("SCENE|RUN");
    command->add_option("-o,--output", arguments->output, "where to write the picture")
        ->option_text("FILE [-]");
    command->add_option("--width", arguments->svg.width, "width of the picture")
        ->option_text("PX [1200]")
        ->check(CLI::Range(200, 20000));
    command->footer(
        "Examples:\n"
        "  osculo render run.json -o shot.svg\n"
        "  osculo render preset:carom --width 800 > table.svg");
    command->callback([arguments] { render(*arguments); });
}

}  // namespace osculo::cli

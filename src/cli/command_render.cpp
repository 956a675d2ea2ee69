#include <memory>

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "osculo/io.hpp"
#include "osculo/simulate.hpp"

namespace osculo::cli {
namespace {

struct RenderArguments {
    std::string input;
    std::string output = "-";
    io::SvgOptions svg;
};

// A scene is run first.
void replay(const RenderArguments& arguments) {
    const auto loaded = load_scene_or_run(arguments.input);
    const auto* const scene = std::get_if<Scene>(&loaded);
    const Run run = scene != nullptr ? simulate(*scene) : std::get<Run>(loaded);
    if (run.pieces.empty() && run.event_count > 0) {
        throw Failure(kInputOutput, arguments.input +
                                        ": there are no pieces in it to show: write it with "
                                        "--record pieces");
    }
    save_text(arguments.output, io::to_html(run, arguments.svg.width));
}

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

void add_replay(CLI::App& app) {
    auto* const command = app.add_subcommand("replay", "Write a run as an HTML page that plays it");
    const auto arguments = std::make_shared<RenderArguments>();
    command->add_option("input", arguments->input, "run or scene file, - or preset:NAME")
        ->required()
        ->option_text("RUN|SCENE");
    command->add_option("-o,--output", arguments->output, "where to write the page")
        ->option_text("FILE [-]");
    command->add_option("--width", arguments->svg.width, "width of the picture")
        ->option_text("PX [1200]")
        ->check(CLI::Range(200, 20000));
    command->footer(
        "The page needs nothing else and shows every ball where it exactly is at any time.\n"
        "A scene is run first.\n"
        "Examples:\n"
        "  osculo replay preset:break -o break.html\n"
        "  osculo run scene.json -o run.json && osculo replay run.json -o run.html");
    command->callback([arguments] { replay(*arguments); });
}

}  // namespace osculo::cli

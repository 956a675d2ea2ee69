#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/summary.hpp"
#include "osculo/io.hpp"

namespace osculo::cli {
namespace {

void add_validate(CLI::App& app) {
    auto* const command = app.add_subcommand("validate", "Check that a scene breaks no rule");
    const auto name = std::make_shared<std::string>();
    command->add_option("scene", *name, kSceneHelp)->required()->option_text("SCENE");
    command->footer(
        "Example:\n"
        "  osculo validate scene.json\n"
        "Says `closed` if the scene asks for proof that no ball can leave, and has it.\n"
        "Exit code: 0 valid, 3 invalid: then one line says what is wrong where.");
    command->callback([name] {
        const Scene scene = load_scene(*name);
        write_output(fmt::format("{}: valid: {}{}\n", *name, contents(scene),
                                 scene.closed ? ", closed" : ""));
    });
}

void explain(const std::string& name, const Options& options) {
    const Scene scene = load_scene(name);
    const EngineInfo engine = choose_engine(scene, options);
    std::string text = fmt::format("{}: {}\n  engine    {}\n", name, contents(scene), engine.name);
    bool is_first = true;
    for (const std::string& reason : engine.left_out) {
        text += fmt::format("  {:<10}{}\n", is_first ? "left out" : "", reason);
        is_first = false;
    }
    write_output(text);
}

void add_explain(CLI::App& app) {
    auto* const command =
        app.add_subcommand("explain", "Say which engine a scene gets, what it leaves out and why");
    const auto name = std::make_shared<std::string>();
    const auto engine = std::make_shared<EngineOptions>();
    command->add_option("scene", *name, kSceneHelp)->required()->option_text("SCENE");
    engine->add_to(*command, "pieces");
    command->footer("Example:\n  osculo explain preset:gas --precision quad");
    command->callback([name, engine] { explain(*name, engine->options(Record::pieces)); });
}

void add_expand(CLI::App& app) {
    auto* const command =
        app.add_subcommand("expand", "Write a scene with its table, rack and defaults spelled out");
    const auto name = std::make_shared<std::string>();
    const auto output = std::make_shared<std::string>("-");
    command->add_option("scene", *name, kSceneHelp)->required()->option_text("SCENE");
    command->add_option("-o,--output", *output, "where to write (.json, .msgpack)")
        ->option_text("FILE [-]");
    command->footer("Example:\n  osculo expand scene.json > expanded.json");
    command->callback([name, output] { save_json(*output, io::scene_to_json(load_scene(*name))); });
}

}  // namespace

void add_check(CLI::App& app) {
    add_validate(app);
    add_explain(app);
    add_expand(app);
}

}  // namespace osculo::cli

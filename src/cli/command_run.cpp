#include <chrono>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/summary.hpp"
#include "cli/working.hpp"
#include "osculo/io.hpp"

namespace osculo::cli {
namespace {

struct RunArguments {
    std::string scene;
    std::string output;
    std::string svg;
    EngineOptions engine;
    std::optional<double> time;
    std::optional<std::uint64_t> events;
    bool audit = false;
    bool certify = false;
    bool quiet = false;
};

ExitCode exit_code_of(const Run& run) {
    if (run.status != Status::at_rest && run.status != Status::time_limit) return kEndedEarly;
    return run.certificate && !run.certificate->certain() ? kUncertain : kFinished;
}

Run simulate_named(const Scene& scene, const Options& options, const std::string& name) {
    try {
        return simulate(scene, options);
    } catch (const SceneError& error) {  // a limit given as an option
        throw Failure(kInvalidScene, name + ": " + error.what());
    }
}

ExitCode run(const RunArguments& arguments) {
    Scene scene = load_scene(arguments.scene);
    if (arguments.time) scene.limits.time = *arguments.time;
    if (arguments.events) scene.limits.events = *arguments.events;
    const bool shows_pieces = !arguments.output.empty() || !arguments.svg.empty();
    Options options = arguments.engine.options(shows_pieces ? Record::pieces : Record::events);
    options.audit = arguments.audit;
    options.certify = arguments.certify;

    const auto start = std::chrono::steady_clock::now();
    const Run result = [&] {
        const Working working(arguments.quiet);
        return simulate_named(scene, options, arguments.scene);
    }();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;

    // The summary goes where no result goes.
    const bool has_result_on_stdout =
        arguments.output == kStandardStream || arguments.svg == kStandardStream;
    if (!arguments.output.empty()) save_json(arguments.output, io::run_to_json(result));
    if (!arguments.svg.empty()) save_text(arguments.svg, io::to_svg(result));
    if (!arguments.quiet) {
        const std::string text = summary(result, arguments.scene, took.count());
        if (has_result_on_stdout) {
            fmt::print(stderr, "{}", text);
        } else {
            write_output(text);
        }
    }
    return exit_code_of(result);
}

}  // namespace

void add_run(CLI::App& app, ExitCode& exit_code) {
    auto* const command = app.add_subcommand("run", "Simulate a scene");
    const auto arguments = std::make_shared<RunArguments>();
    command->add_option("scene", arguments->scene, kSceneHelp)->required()->option_text("SCENE");
    command->add_option("-o,--output", arguments->output, "write the run (.json, .msgpack, -)")
        ->option_text("FILE");
    command->add_option("--svg", arguments->svg, "write a picture of the run")->option_text("FILE");
    arguments->engine.add_to(*command, "pieces with -o or --svg, else events");
    command->add_flag("--audit", arguments->audit, "check the run from its pieces alone");
    command->add_flag("--certify", arguments->certify,
                      "run again in higher precisions, and say how many digits can be trusted");
    command->add_option("--time", arguments->time, "simulated time to end at [s]")
        ->option_text("T [as in the scene]");
    command->add_option("--events", arguments->events, "number of events to end at")
        ->option_text("N [as in the scene]")
        ->check(CLI::NonNegativeNumber);
    command->add_flag("-q,--quiet", arguments->quiet, "no summary");
    command->footer(
        "Examples:\n"
        "  osculo run preset:break -o run.json --svg shot.svg\n"
        "  osculo run scene.json --time 5 --audit\n"
        "  osculo run - -o - < scene.json > run.json\n"
        "  osculo run preset:gas --certify --time 3\n"
        "Exit code: 0 at rest or at the time limit, 1 ended early, 5 not all of it certain "
        "(--certify).");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace osculo::cli

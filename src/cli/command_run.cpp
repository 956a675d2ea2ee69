#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
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
    std::string snapshot;
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

/// What cannot be asked for in the middle of a run.
void refuse_beginnings(const CLI::App& command, const std::string& name) {
    for (const char* option : {"--precision", "--record", "--audit", "--certify"}) {
        if (command.count(option) == 0) continue;
        throw Failure(kUsage, std::string(option) + ": " + name +
                                  " is a snapshot, which goes on as it was begun");
    }
}

/// Plays on to those limits, which may be beyond those it had. False if it was interrupted.
bool play(Simulation& simulation, const Limits& limits) {
    /// Between looks at whether it is interrupted.
    constexpr std::uint64_t kEvents = 10'000;
    simulation.set_limits({std::max(limits.time, simulation.limits().time),
                           std::max(limits.events, simulation.limits().events)});
    const InterruptNote interrupt;
    while (!interrupt.is_interrupted()) {
        const std::uint64_t count = simulation.event_count();
        if (limits.events <= count || limits.events - count <= kEvents) {
            simulation.play(limits);
            return true;
        }
        if (simulation.play({limits.time, count + kEvents}) != Status::event_limit) {
            simulation.play(limits);  // nothing more happens, within these limits
            return true;
        }
    }
    return false;
}

/// Plays a simulation in which there may be a stop, and keeps where it is. Nothing if it was
/// interrupted.
std::optional<Run> play_and_keep(Simulation& simulation, const RunArguments& arguments) {
    const Limits limits = {arguments.time.value_or(simulation.limits().time),
                           arguments.events.value_or(simulation.limits().events)};
    Scene limited = simulation.scene();
    limited.limits = limits;
    validate(limited);
    const bool is_finished = play(simulation, limits);
    if (!arguments.snapshot.empty()) {
        save_text(arguments.snapshot, io::simulation_to_snapshot(simulation));
    }
    if (is_finished) return simulation.result();
    fmt::print(stderr, "osculo: interrupted at {:.9g} s, after {} events{}\n", simulation.time(),
               simulation.event_count(),
               arguments.snapshot.empty() || arguments.snapshot == kStandardStream
                   ? ""
                   : fmt::format("; osculo run {} goes on", arguments.snapshot));
    return std::nullopt;
}

std::optional<Run> play(const RunArguments& arguments, std::variant<Scene, Simulation>& loaded) {
    if (auto* const simulation = std::get_if<Simulation>(&loaded)) {
        return play_and_keep(*simulation, arguments);
    }
    Scene& scene = std::get<Scene>(loaded);
    const bool shows_pieces =
        !arguments.output.empty() || !arguments.svg.empty() || !arguments.snapshot.empty();
    Options options = arguments.engine.options(shows_pieces ? Record::pieces : Record::events);
    options.audit = arguments.audit;
    options.certify = arguments.certify;
    if (!arguments.snapshot.empty()) {
        Simulation simulation(scene, options);
        return play_and_keep(simulation, arguments);
    }
    if (arguments.time) scene.limits.time = *arguments.time;
    if (arguments.events) scene.limits.events = *arguments.events;
    return simulate(scene, options);
}

ExitCode run(const RunArguments& arguments, const CLI::App& command) {
    auto loaded = load_scene_or_simulation(arguments.scene);
    if (std::holds_alternative<Simulation>(loaded)) refuse_beginnings(command, arguments.scene);

    const auto start = std::chrono::steady_clock::now();
    const std::optional<Run> played = [&] {
        const Working working(arguments.quiet);
        try {
            return play(arguments, loaded);
        } catch (const SceneError& error) {  // a limit given as an option
            throw Failure(kInvalidScene, arguments.scene + ": " + error.what());
        }
    }();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (!played) return kInterrupted;
    const Run& result = *played;

    // The summary goes where no result goes.
    const bool has_result_on_stdout =
        std::ranges::count(std::array{arguments.output, arguments.svg, arguments.snapshot},
                           kStandardStream) > 0;
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
    command
        ->add_option("scene", arguments->scene,
                     std::string(kSceneHelp) + "; or a snapshot, to go on with")
        ->required()
        ->option_text("SCENE");
    command->add_option("-o,--output", arguments->output, "write the run (.json, .msgpack, -)")
        ->option_text("FILE");
    command->add_option("--svg", arguments->svg, "write a picture of the run")->option_text("FILE");
    command
        ->add_option("--snapshot", arguments->snapshot,
                     "write where it ends or is interrupted, for run to go on from")
        ->option_text("FILE");
    arguments->engine.add_to(*command, "pieces with -o, --svg or --snapshot, else events");
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
        "  osculo run preset:break --time 1 --snapshot shot.snapshot\n"
        "  osculo run shot.snapshot -o run.json     (the same bytes as without the stop)\n"
        "Exit code: 0 at rest or at the time limit, 1 ended early, 5 not all of it certain "
        "(--certify).");
    command->callback([arguments, command, &exit_code] { exit_code = run(*arguments, *command); });
}

}  // namespace osculo::cli

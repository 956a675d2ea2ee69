// osculo-mpi: batches on more than one machine, started by mpirun.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/failure.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "mpi/block_bytes.hpp"
#include "mpi/coordinator.hpp"
#include "mpi/ranks.hpp"

namespace osculo::mpi {
namespace {

using cli::ExitCode;
using cli::Failure;

struct Arguments {
    std::string scene;
    std::string shots;
    std::string output = "-";
    std::string precision = "double";
    unsigned threads = 1;
    std::optional<double> time;
    std::optional<std::uint64_t> events;
    bool resumes = false;
    bool is_strict = false;
};

BatchOptions batch_options(const Arguments& arguments, const Scene& scene) {
    BatchOptions options;
    options.precision =
        precision_from_string(arguments.precision).value_or(Precision::double_precision);
    options.threads = arguments.threads;
    Limits limits = scene.limits;
    if (arguments.time) limits.time = *arguments.time;
    if (arguments.events) limits.events = *arguments.events;
    options.limits = limits;
    return options;
}

void play(Batch& batch, const cli::ShotBlock& block, BatchResult& result) {
    if (block.are_starts) {
        batch.run(Starts{block.states, block.present}, result);
    } else {
        batch.run(block.strikes, result);
    }
}

/// To ranks that have to end while others do not answer: for those MPI would wait for ever.
constexpr const char* kLeave = "leave";

/// Of all ranks but 0: plays what comes, until a message without content.
void work(const Ranks& ranks, Batch& batch) {
    BatchResult result;
    for (;;) {
        const Ranks::Message message = ranks.receive();
        if (message.text.empty()) return;
        if (message.text == kLeave) Ranks::abandon(cli::kFinished);
        const cli::ShotBlock block = block_from(message.text);
        play(batch, block, result);
        ranks.send(0, bytes_of(result, block.first));
    }
}

/// Of one rank alone.
void play_alone(const Scene& scene, Batch& batch, cli::ShotSource& source, cli::OutcomeSink& sink,
                cli::InvalidShots& invalid, const cli::InterruptNote& interrupt) {
    BatchResult result;
    while (!interrupt.is_interrupted() && !invalid.has_ended()) {
        cli::ShotBlock block = source.next(256);
        if (block.size() == 0) return;
        play(batch, block, result);
        const std::size_t rows = invalid.report(scene, block, result, block.size());
        sink.write(result, rows, block.first, block.errors);
    }
}

/// A block of which no message is longer than an int counts bytes, with room to spare.
std::size_t block_size(const Scene& scene) {
    const std::size_t row = std::max<std::size_t>(scene.balls.size(), 1) * sizeof(BallState);
    return std::clamp<std::size_t>((std::size_t{1} << 29U) / row, 1, 256);
}

ExitCode coordinate(const Ranks& ranks, const Arguments& arguments, const Scene& scene,
                    const BatchOptions& options, Batch& batch) {
    const auto source = cli::open_shots(arguments.shots, scene);
    const auto sink =
        cli::open_outcomes({arguments.output, 0, true, arguments.resumes}, scene, options);
    source->skip(sink->kept());
    cli::InvalidShots invalid(arguments.shots, arguments.is_strict);
    const cli::InterruptNote interrupt;
    Coordinator coordinator(ranks, scene, *source, *sink, invalid);
    if (ranks.size() == 1) {
        play_alone(scene, batch, *source, *sink, invalid, interrupt);
    } else {
        coordinator.run(block_size(scene), interrupt);
    }
    sink->finish();

    ExitCode code = invalid.count() > 0 ? cli::kInvalidScene : cli::kFinished;
    if (interrupt.is_interrupted()) {
        code = cli::kInterrupted;
        fmt::print(stderr, "osculo-mpi: interrupted, or a rank has died; --resume goes on\n");
        for (const std::string& range : coordinator.missing()) {
            fmt::print(stderr, "osculo-mpi: shots {} were handed out and are not written\n", range);
        }
    }
    const auto silent = coordinator.silent_ranks();
    for (const int rank : silent) {
        fmt::print(stderr, "osculo-mpi: rank {} has not answered{}\n", rank,
                   coordinator.missing().empty() ? "; others have played its shots" : "");
    }
    if (silent.empty()) return code;
    for (int rank = 1; rank < ranks.size(); ++rank) ranks.send(rank, kLeave);
    Ranks::abandon(code);
}

ExitCode run(const Ranks& ranks, const Arguments& arguments) {
    const Scene scene = cli::load_scene(arguments.scene);
    const BatchOptions options = batch_options(arguments, scene);
    try {
        Batch batch(scene, options);
        if (ranks.rank() != 0) {
            work(ranks, batch);
            return cli::kFinished;
        }
        const ExitCode code = coordinate(ranks, arguments, scene, options, batch);
        for (int rank = 1; rank < ranks.size(); ++rank) ranks.send(rank, {});
        return code;
    } catch (const SceneError& error) {
        throw Failure(cli::kInvalidScene, arguments.scene + ": " + error.what());
    }
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.set_help_flag("-h,--help", "print this help");
    auto* const batch = app.add_subcommand("batch", "Play many shots on one table");
    app.require_subcommand(1);
    batch->add_option("scene", arguments.scene, cli::kSceneHelp)->required()->option_text("SCENE");
    batch->add_option("shots", arguments.shots, "shots, as for osculo batch")
        ->required()
        ->option_text("SHOTS");
    batch->add_option("-o,--output", arguments.output, "outcomes, as for osculo batch")
        ->option_text("FILE [-]");
    batch->add_option("--threads", arguments.threads, "number of threads of each rank")
        ->option_text("N [1]");
    batch->add_flag("--resume", arguments.resumes, "go on with FILE where it ends");
    batch->add_flag("--strict", arguments.is_strict, "end at the first shot that is invalid");
    batch->add_option("--precision", arguments.precision, "scalar type of the computation")
        ->option_text("double|extended|quad|50|100 [double]")
        ->check(CLI::IsMember({"double", "extended", "quad", "50", "100"}));
    batch->add_option("--time", arguments.time, "simulated time to end each shot at [s]")
        ->option_text("T [as in the scene]");
    batch->add_option("--events", arguments.events, "number of events to end each shot at")
        ->option_text("N [as in the scene]");
    app.footer(
        "Example:\n"
        "  mpirun -n 8 osculo-mpi batch table.json shots.jsonl -o out.jsonl\n"
        "Rank 0 reads, hands out and writes; the others need the scene, but not the shots.");
}

int main_with(const Ranks& ranks, int argc, char** argv) {
    const bool is_first = ranks.rank() == 0;
    const auto fail = [&](int code, const char* message) {
        // What all ranks find, rank 0 says.
        if (!is_first) std::this_thread::sleep_for(std::chrono::seconds(1));
        fmt::print(stderr, "osculo-mpi: {}\n", message);
        Ranks::abandon(code);  // others may be waiting for something
    };
    CLI::App app("Batches of shots by the ranks of MPI.", "osculo-mpi");
    Arguments arguments;
    add_options(app, arguments);
    try {
        app.parse(argc, argv);
        return run(ranks, arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) fail(cli::kUsage, error.what());
        if (is_first) app.exit(error);
        return 0;
    } catch (const Failure& failure) {
        fail(failure.code(), failure.what());
    } catch (const std::exception& error) {
        fail(cli::kInputOutput, error.what());
    }
    return cli::kInputOutput;
}

}  // namespace
}  // namespace osculo::mpi

int main(int argc, char** argv) {
    osculo::cli::handle_signals();
    const osculo::mpi::Ranks ranks(argc, argv);
    return osculo::mpi::main_with(ranks, argc, argv);
}

#include <chrono>
#include <future>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/batch/array_sink.hpp"
#include "cli/batch/invalid_shots.hpp"
#include "cli/batch/outcome_sink.hpp"
#include "cli/batch/shot_source.hpp"
#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "osculo/batch.hpp"

namespace osculo::cli {
namespace {

/// Shots that are read, played and written at a time.
constexpr std::size_t kBlock = 1024;

struct BatchArguments {
    std::string scene;
    std::string shots;
    std::string output = "-";
    std::string shard;
    std::string precision = "double";
    unsigned threads = 0;
    std::optional<double> time;
    std::optional<std::uint64_t> events;
    bool resumes = false;
    bool is_strict = false;
    bool quiet = false;
};

/// Numbers of shots in a file: from the first to before the end.
struct Range {
    std::uint64_t first = 0;
    std::optional<std::uint64_t> end{};  ///< nothing: that of the file
    bool is_first_shard = true;
};

/// The part i/n of all of them; of the parts, any two differ by at most one shot.
Range shard_range(const std::string& shard, std::optional<std::uint64_t> count) {
    if (shard.empty()) return {0, count};
    std::uint64_t i = 0;
    std::uint64_t n = 0;
    int used = 0;
    const bool is_read = std::sscanf(shard.c_str(), "%lu/%lu%n", &i, &n, &used) == 2 &&
                         static_cast<std::size_t>(used) == shard.size();
    if (!is_read || i < 1 || i > n || n > 1'000'000) {
        throw Failure(kUsage, "--shard: must be i/n with i from 1 to n, but it is " + shard);
    }
    if (!count) throw Failure(kUsage, "--shard needs a file of shots, not a stream");
    const auto start = [&](std::uint64_t part) {
        return *count / n * part + *count % n * part / n;
    };
    return {start(i - 1), start(i), i == 1};
}

/// How far it is, on a terminal.
class Progress {
public:
    Progress(bool quiet, std::uint64_t done, std::optional<std::uint64_t> all)
        : is_shown_(!quiet && isatty(STDERR_FILENO) != 0), before_(done), done_(done), all_(all) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() {
        if (is_shown_) fmt::print(stderr, "\r\033[K");
    }

    void show(std::size_t of_block) const {
        if (!is_shown_) return;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start_;
        const std::uint64_t done = done_ + of_block;
        fmt::print(stderr, "\r\033[K{}{} shots, {:.0f} per second", done,
                   all_ ? fmt::format(" of {}", *all_) : "",
                   static_cast<double>(done - before_) / took.count());
    }
    void add(std::uint64_t shots) { done_ += shots; }

private:
    bool is_shown_;
    std::uint64_t before_;
    std::uint64_t done_;
    std::optional<std::uint64_t> all_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Played {
    ShotBlock block;
    BatchResult result;
    std::size_t rows = 0;  ///< that are done
};

class BatchCommand {
public:
    explicit BatchCommand(const BatchArguments& arguments)
        : arguments_(arguments),
          scene_(load_scene(arguments.scene)),
          invalid_(arguments.shots, arguments.is_strict) {
        options_.precision =
            precision_from_string(arguments.precision).value_or(Precision::double_precision);
        options_.threads = arguments.threads;
        Limits limits = scene_.limits;
        if (arguments.time) limits.time = *arguments.time;
        if (arguments.events) limits.events = *arguments.events;
        options_.limits = limits;
    }

    ExitCode run() {
        try {
            return play();
        } catch (const SceneError& error) {
            throw Failure(kInvalidScene, arguments_.scene + ": " + error.what());
        }
    }

private:
    ExitCode play() {
        const auto source = open_shots(arguments_.shots, scene_);
        const auto count = source->count();
        Range range = shard_range(arguments_.shard, count);
        Batch batch(scene_, options_);
        const auto sink = open_outcomes(
            {arguments_.output, range.first, range.is_first_shard, arguments_.resumes}, scene_,
            options_);
        const std::uint64_t kept = sink->kept();
        range.first += kept;
        source->skip(range.first);

        const InterruptNote interrupt;
        Progress progress(arguments_.quiet, kept, range.end);
        std::stop_source stop;
        const BatchControl control{stop.get_token(), [&](std::size_t done, std::size_t) {
                                       progress.show(done);
                                       if (interrupt.is_interrupted()) stop.request_stop();
                                   }};
        std::future<void> writing;
        std::uint64_t done = range.first;
        while (!interrupt.is_interrupted() && (!range.end || done < *range.end)) {
            const std::uint64_t left = range.end ? *range.end - done : kBlock;
            auto played = std::make_shared<Played>();
            played->block = source->next(std::min<std::uint64_t>(kBlock, left));
            if (played->block.size() == 0) break;
            play(batch, *played, control);
            done += played->rows;
            progress.add(played->rows);
            // The next block is played while this one is written.
            if (writing.valid()) writing.get();
            writing = std::async(std::launch::async, [&sink, played] {
                sink->write(played->result, played->rows, played->block.first,
                            played->block.errors);
            });
            if (invalid_.has_ended()) break;
        }
        if (writing.valid()) writing.get();
        sink->finish();
        return report(done - range.first, interrupt.is_interrupted());
    }

    void play(Batch& batch, Played& played, const BatchControl& control) {
        const ShotBlock& block = played.block;
        if (block.are_starts) {
            batch.run(Starts{block.states, block.present}, played.result, control);
        } else {
            batch.run(block.strikes, played.result, control);
        }
        // Shots after the first one that was not run are not in order.
        const auto& status = played.result.status;
        const auto end = std::find(status.begin(), status.end(), ShotStatus::not_run);
        played.rows = static_cast<std::size_t>(end - status.begin());
        played.rows = invalid_.report(scene_, played.block, played.result, played.rows);
    }

    [[nodiscard]] ExitCode report(std::uint64_t done, bool is_interrupted) const {
        if (is_interrupted) {
            const bool is_file = arguments_.output != kStandardStream;
            fmt::print(stderr, "osculo: interrupted after {} shots{}\n", done,
                       is_file ? "; the same command with --resume goes on" : "");
            return kInterrupted;
        }
        if (invalid_.count() > 0 && !arguments_.quiet) {
            fmt::print(stderr, "osculo: {} of {} shots are invalid\n", invalid_.count(), done);
        }
        return invalid_.count() > 0 ? kInvalidScene : kFinished;
    }

    const BatchArguments& arguments_;
    Scene scene_;
    BatchOptions options_;
    InvalidShots invalid_;
};

/// Puts the outcomes of shards together.
void merge(const std::vector<std::string>& parts, const std::string& output) {
    if (parts.front().ends_with(".npz")) {
        save_text(output, npz_from_arrays(joined(parts)));
        return;
    }
    std::string text;
    for (const std::string& part : parts) text += read_file(part);
    save_text(output, text);
}

void add_merge(CLI::App& app) {
    auto* const command = app.add_subcommand("merge", "Put the outcomes of shards together");
    struct Arguments {
        std::vector<std::string> parts;
        std::string output = "-";
    };
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("parts", arguments->parts, "outcomes of shards 1/n to n/n, in this order")
        ->required()
        ->option_text("PART...");
    command->add_option("-o,--output", arguments->output, "where to write")
        ->option_text("FILE [-]");
    command->footer(
        "Example:\n"
        "  osculo merge 1.npz 2.npz 3.npz -o all.npz\n"
        "Lines of JSON or CSV are put together as by cat.");
    command->callback([arguments] { merge(arguments->parts, arguments->output); });
}

}  // namespace

void add_batch(CLI::App& app, ExitCode& exit_code) {
    auto* const command = app.add_subcommand("batch", "Play many shots on one table");
    const auto arguments = std::make_shared<BatchArguments>();
    command->add_option("scene", arguments->scene, kSceneHelp)->required()->option_text("SCENE");
    command
        ->add_option("shots", arguments->shots, "shots (.csv, .npz, or lines of JSON), - for stdin")
        ->required()
        ->option_text("SHOTS");
    command
        ->add_option("-o,--output", arguments->output,
                     "outcomes (.csv, .npz, or lines of JSON), - for stdout")
        ->option_text("FILE [-]");
    command->add_option("--threads", arguments->threads, "number of threads")
        ->option_text("N [one per core]");
    command->add_option("--shard", arguments->shard, "play the i-th of n parts of the shots only")
        ->option_text("i/n");
    command->add_flag("--resume", arguments->resumes, "go on with FILE where it ends");
    command->add_flag("--strict", arguments->is_strict, "end at the first shot that is invalid");
    command->add_option("--precision", arguments->precision, "scalar type of the computation")
        ->option_text("double|extended|quad|50|100 [double]")
        ->check(CLI::IsMember({"double", "extended", "quad", "50", "100"}));
    command->add_option("--time", arguments->time, "simulated time to end each shot at [s]")
        ->option_text("T [as in the scene]");
    command->add_option("--events", arguments->events, "number of events to end each shot at")
        ->option_text("N [as in the scene]")
        ->check(CLI::NonNegativeNumber);
    command->add_flag("-q,--quiet", arguments->quiet, "no progress and no summary");
    command->footer(
        "Examples:\n"
        "  osculo batch table.json shots.jsonl -o out.jsonl\n"
        "  osculo batch table.json shots.csv --shard 2/4 -o 2.npz\n"
        "  cat 1.jsonl 2.jsonl > all.jsonl     (shards 1/2 and 2/2; or osculo merge, for .npz)\n"
        "A shot is {\"speed\": 4, \"azimuth\": 1.2, \"elevation\": 0.1, \"offset\": [a, b]}, the "
        "last\n"
        "two optional, or the columns speed, azimuth, elevation, a, b; or the balls on the table,\n"
        "{\"balls\": [{\"id\": \"cue\", \"position\": [x, y], \"velocity\": .., \"spin\": ..}, "
        "..]}.\n"
        "Exit code: 0 finished, 3 some shots are invalid (each is reported), 130 interrupted.");
    command->callback([arguments, &exit_code] { exit_code = BatchCommand(*arguments).run(); });
    add_merge(app);
}

}  // namespace osculo::cli

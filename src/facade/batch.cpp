#include "osculo/batch.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <stdexcept>
#include <thread>
#include <utility>

#include "batch_columns.hpp"
#include "batch_shots.hpp"
#include "ready_engine.hpp"
#include "worker_pool.hpp"

namespace osculo {
namespace {

using facade::ShotTable;

/// What one thread plays with.
struct Worker {
    Worker(const Scene& scene, const facade::ReadyEngine& engine)
        : table(scene), player(engine.make_player(table.scene())) {}

    ShotTable table;
    std::unique_ptr<facade::ShotPlayer> player;
    facade::PlayedShot played;
    std::exception_ptr error;
};

unsigned thread_count(unsigned wanted) {
    return std::max(1U, wanted != 0 ? wanted : std::thread::hardware_concurrency());
}

std::size_t chunk_size(std::size_t wanted, std::size_t shots, unsigned threads) {
    if (wanted != 0) return wanted;
    // Small enough that all threads end at about the same time, and not more than a second's work.
    return std::clamp<std::size_t>(shots / (16 * static_cast<std::size_t>(threads)), 1, 1024);
}

/// Tells how far a batch is, but not too often.
class Announcer {
public:
    Announcer(const BatchControl& control, std::size_t all) : control_(control), all_(all) {}

    void announce(std::size_t done) {
        if (!control_.progress) return;
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        control_.progress(done, all_);
    }
    void announce_end(std::size_t done) const {
        if (control_.progress) control_.progress(done, all_);
    }

private:
    const BatchControl& control_;
    std::size_t all_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

struct Batch::Implementation {
    Implementation(const Scene& scene, const BatchOptions& batch_options)
        : given(scene),
          base(facade::batch_base(scene, batch_options.limits)),
          cue(scene.cue.value_or(Cue{})),
          options(batch_options),
          engine(facade::narrowest_engine(base, {options.precision, options.record}, true)),
          pool(thread_count(options.threads)) {
        for (unsigned n = 0; n < pool.threads(); ++n) {
            workers.push_back(std::make_unique<Worker>(base, engine));
            workers.back()->played.record = options.record;
        }
    }

    /// set_up(table, shot) lays out a shot, false if it is invalid.
    template <class SetUp>
    void run(std::size_t shots, const SetUp& set_up, BatchResult& result,
             const BatchControl& control);

    Scene given;
    Scene base;  ///< valid, without a cue
    Cue cue;     ///< without a strike
    bool has_valid_cue = false;
    BatchOptions options;
    const facade::ReadyEngine& engine;
    std::vector<std::unique_ptr<Worker>> workers;
    facade::WorkerPool pool;
};

template <class SetUp>
void Batch::Implementation::run(std::size_t shots, const SetUp& set_up, BatchResult& result,
                                const BatchControl& control) {
    const std::size_t chunk = chunk_size(options.chunk, shots, pool.threads());
    const std::size_t chunks = shots / chunk + (shots % chunk != 0);
    facade::BatchColumns columns(result, shots, base.balls.size(), chunks, options);
    result.points = workers.front()->player->points();

    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::atomic<bool> stopping{false};
    Announcer announcer(control, shots);
    const auto play = [&](Worker& worker, std::size_t shot) {
        if (!set_up(worker.table, shot)) {
            columns.set_invalid(shot);
            return;
        }
        const std::size_t events = worker.played.events.size();
        const std::size_t pieces = worker.played.pieces.size();
        worker.player->play(worker.table.present(), base.limits, worker.played);
        columns.set(shot, worker.played, worker.table.present());
        columns.set_records(shot, worker.played.events.size() - events,
                            worker.played.pieces.size() - pieces);
    };
    const auto work = [&](Worker& worker, bool calling) {
        for (std::size_t c = next++; c < chunks && !stopping; c = next++) {
            const std::size_t end = std::min(shots, (c + 1) * chunk);
            for (std::size_t shot = c * chunk; shot < end && !stopping; ++shot) {
                if (control.stop.stop_requested()) {
                    stopping = true;
                    break;
                }
                play(worker, shot);
                ++done;
                if (calling) announcer.announce(done);
            }
            columns.keep_records(c, worker.played);
        }
    };
    const std::function<void(unsigned)> task = [&](unsigned n) {
        Worker& worker = *workers[n];
        worker.played.events.clear();
        worker.played.pieces.clear();
        try {
            work(worker, n == 0);
        } catch (...) {
            worker.error = std::current_exception();
            stopping = true;
        }
    };
    pool.run(task);
    for (const auto& worker : workers) {
        if (worker->error) std::rethrow_exception(std::exchange(worker->error, nullptr));
    }
    columns.join_records();
    announcer.announce_end(done);
}

Batch::Batch(const Scene& scene, const BatchOptions& options)
    : implementation_(std::make_unique<Implementation>(scene, options)) {}
Batch::~Batch() = default;
Batch::Batch(Batch&&) noexcept = default;
Batch& Batch::operator=(Batch&&) noexcept = default;

void Batch::run(std::span<const Strike> strikes, BatchResult& result, const BatchControl& control) {
    Implementation& batch = *implementation_;
    if (!batch.has_valid_cue) facade::validate_cue_of(batch.base, batch.cue);
    batch.has_valid_cue = true;
    const auto set_up = [&](ShotTable& table, std::size_t shot) {
        return table.set_up(batch.cue, strikes[shot]);
    };
    batch.run(strikes.size(), set_up, result, control);
}

void Batch::run(const Starts& starts, BatchResult& result, const BatchControl& control) {
    const std::size_t shots = facade::count_shots(implementation_->base, starts);
    const auto set_up = [&](ShotTable& table, std::size_t shot) {
        return table.set_up(starts, shot);
    };
    implementation_->run(shots, set_up, result, control);
}

const Scene& Batch::scene() const {
    return implementation_->given;
}

std::string Batch::engine_name() const {
    return implementation_->engine.name();
}

unsigned Batch::threads() const {
    return implementation_->pool.threads();
}

BatchResult simulate_batch(const Scene& scene, std::span<const Strike> strikes,
                           const BatchOptions& options, const BatchControl& control) {
    BatchResult result;
    Batch(scene, options).run(strikes, result, control);
    return result;
}

BatchResult simulate_batch(const Scene& scene, const Starts& starts, const BatchOptions& options,
                           const BatchControl& control) {
    BatchResult result;
    Batch(scene, options).run(starts, result, control);
    return result;
}

}  // namespace osculo

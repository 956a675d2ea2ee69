#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "osculo/batch.hpp"
#include "osculo/noise.hpp"
#include "python/batch_columns.hpp"
#include "python/bindings.hpp"
#include "python/noise.hpp"
#include "python/options.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

// Rows of doubles side by side. What already is that is taken as it is, without a copy.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Flags = py::array_t<bool, py::array::c_style | py::array::forcecast>;
using Progress = std::function<void(std::size_t, std::size_t)>;

static_assert(sizeof(Strike) == 5 * sizeof(double));
static_assert(sizeof(BallState) == 7 * sizeof(double));
static_assert(sizeof(bool) == sizeof(std::uint8_t));

std::span<const Strike> strikes_in(const Rows& shots) {
    if (shots.ndim() != 2 || shots.shape(1) != 5) {
        throw std::invalid_argument("shots must be of the shape (N, 5)");
    }
    return {reinterpret_cast<const Strike*>(shots.data()),
            static_cast<std::size_t>(shots.shape(0))};
}

Starts starts_in(const Rows& starts, const std::optional<Flags>& present, std::size_t balls) {
    const auto count = static_cast<py::ssize_t>(balls);
    if (starts.ndim() != 3 || starts.shape(1) != count || starts.shape(2) != 7) {
        throw std::invalid_argument("starts must be of the shape (N, " + std::to_string(balls) +
                                    ", 7)");
    }
    const auto places = static_cast<std::size_t>(starts.shape(0)) * balls;
    Starts result{{reinterpret_cast<const BallState*>(starts.data()), places}};
    if (present) {
        if (present->ndim() != 2 || present->shape(0) != starts.shape(0) ||
            present->shape(1) != count) {
            throw std::invalid_argument("present must be of the shape (N, " +
                                        std::to_string(balls) + ")");
        }
        result.present = {reinterpret_cast<const std::uint8_t*>(present->data()), places};
    }
    return result;
}

// Lets Python speak up now and then: Ctrl-C ends the batch, and so does what `progress` raises.
BatchControl control_of(const Progress& progress) {
    BatchControl control;
    control.progress = [&progress](std::size_t done, std::size_t all) {
        const py::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (progress) progress(done, all);
    };
    return control;
}

// A batch, which one thread at a time may play.
class Table {
public:
    Table(const Scene& scene, const std::string& precision, const std::string& record, bool states,
          std::optional<double> time, std::optional<std::uint64_t> events, unsigned threads,
          std::size_t chunk)
        : batch_(scene,
                 batch_options(scene, precision, record, states, time, events, threads, chunk)) {}

    py::dict strike(const Rows& shots, const Progress& progress) {
        return play(strikes_in(shots), progress);
    }
    py::dict release(const Rows& starts, const std::optional<Flags>& present,
                     const Progress& progress) {
        return play(starts_in(starts, present, scene().balls.size()), progress);
    }

    py::dict success(const std::array<double, 5>& shot, const std::vector<std::string>& pots,
                     const std::optional<std::string>& first_hit, bool no_scratch,
                     const py::object& noise, std::uint64_t draws, std::uint64_t seed, double width,
                     double confidence) {
        const Goal goal = goal_of(pots, first_hit, no_scratch);
        SuccessOptions options;
        options.noise = noise_from(noise);
        options.draws = draws;
        options.seed = seed;
        options.width = width;
        options.confidence = confidence;
        const Strike strike{shot[0], shot[1], shot[2], shot[3], shot[4]};
        const Progress nobody;
        const BatchControl control = control_of(nobody);
        return dict_of(exclusively(
            [&] { return success_probability(batch_, strike, goal, options, control); }));
    }

    [[nodiscard]] const Scene& scene() const { return batch_.scene(); }
    [[nodiscard]] const Batch& batch() const { return batch_; }

private:
    static BatchOptions batch_options(const Scene& scene, const std::string& precision,
                                      const std::string& record, bool states,
                                      std::optional<double> time,
                                      std::optional<std::uint64_t> events, unsigned threads,
                                      std::size_t chunk) {
        BatchOptions options;
        options.precision = precision_from(precision);
        options.record = record_from(record);
        options.states = states;
        options.threads = threads;
        options.chunk = chunk;
        if (time || events) {
            options.limits =
                Limits{time.value_or(scene.limits.time), events.value_or(scene.limits.events)};
        }
        return options;
    }

    // Works without Python's lock, which other threads may have meanwhile, but not on this batch.
    template <class Work>
    std::invoke_result_t<Work> exclusively(Work work) {
        const py::gil_scoped_release release;
        const std::unique_lock lock(playing_, std::try_to_lock);
        if (!lock) throw std::runtime_error("the batch is being played already");
        return work();
    }

    template <class Shots>
    py::dict play(const Shots& shots, const Progress& progress) {
        auto result = std::make_unique<BatchResult>();
        const BatchControl control = control_of(progress);
        exclusively([&] { batch_.run(shots, *result, control); });
        return columns_of(std::move(result));
    }

    [[nodiscard]] std::uint32_t ball_named(const std::string& id) const {
        for (std::uint32_t i = 0; i < scene().balls.size(); ++i) {
            if (scene().balls[i].id == id) return i;
        }
        throw py::key_error("the scene has no ball '" + id + "'");
    }

    [[nodiscard]] Goal goal_of(const std::vector<std::string>& pots,
                               const std::optional<std::string>& first_hit, bool no_scratch) const {
        Goal goal;
        for (const std::string& ball : pots) goal.pots.push_back({.ball = ball_named(ball)});
        if (first_hit) goal.first_hit = ball_named(*first_hit);
        goal.no_scratch = no_scratch;
        return goal;
    }

    static py::dict dict_of(const Success& success) {
        py::dict result;
        result["probability"] = success.probability;
        result["low"] = success.low;
        result["high"] = success.high;
        result["draws"] = success.draws;
        result["successes"] = success.successes;
        result["impossible"] = success.impossible;
        result["unfinished"] = success.unfinished;
        return result;
    }

    Batch batch_;
    std::mutex playing_;
};

constexpr const char* kColumns = R"(
The arrays belong to the result: nothing is copied.

Of each shot, shape (N,): status (code, see SHOT_STATUSES), time [s], event_count, cue_ball and
first_hit (index into scene.ids, or -1), cushions_before_hit, cushions_after_hit (of the cue ball),
driven_to_cushion (number of other balls), kisses, settled_count (as of a Run).
Of each shot and ball, shape (N, balls): fate (code, see SHOT_FATES), position [m] (with a third axis of
2), rim (index into scene.rim_ids, or -1), capture_time [s] (NaN: not captured), ball_contacts,
cushion_contacts; with `states` also state, with position, velocity [m/s] and spin [rad/s].
With record "events" events and event_offsets, with "pieces" also pieces and piece_offsets: those of
shot i stand from offsets[i] up to offsets[i + 1], as in Run.)";

constexpr const char* kStrikes = R"(Plays every strike of the scene's cue: a dict of arrays.

shots: shape (N, 5), a row for each: speed of the cue [m/s], azimuth [rad], elevation [rad] (NaN: the
least that passes over what is behind the ball), offset of the tip to the left and upwards [ball
radii]. An array of contiguous doubles is read in place.
progress: called with the number of shots done and of all, some ten times per second.)";

constexpr const char* kStarts = R"(Plays from every start, without a cue: a dict of arrays.

starts: shape (N, balls, 7), of each ball position [m], velocity [m/s], spin [rad/s]. An array of
contiguous doubles is read in place.
present: shape (N, balls), False for balls that are not on the table; all are if left out.)";

constexpr const char* kOptions = R"(
precision: as in simulate(). record: "none", "events" or "pieces", besides the outcomes. states: keep
the final velocities and spins, too. time [s], events: limits of each shot, if not those of the scene.
threads: 0 is one per core. chunk: shots that a thread takes at a time, 0: a good number.)";

}  // namespace

void bind_batch(py::module_& module) {
    const std::string doc = std::string(R"(A table made ready for many shots: threads that wait.

Every shot gives the same bits as simulate() would. Other Python threads run meanwhile, but cannot
play the same batch; Ctrl-C ends it. Raises SceneError.)") +
                            kOptions;
    py::class_<Table> type(module, "Batch", doc.c_str());
    type.def(py::init<const Scene&, const std::string&, const std::string&, bool,
                      std::optional<double>, std::optional<std::uint64_t>, unsigned, std::size_t>(),
             "scene"_a, py::kw_only(), "precision"_a = "double", "record"_a = "none",
             "states"_a = false, "time"_a = py::none(), "events"_a = py::none(), "threads"_a = 0U,
             "chunk"_a = std::size_t{0});
    const std::string strikes = std::string(kStrikes) + kColumns;
    type.def("strike", &Table::strike, "shots"_a, "progress"_a = Progress(), strikes.c_str());
    const std::string starts = std::string(kStarts) + kColumns;
    type.def("release", &Table::release, "starts"_a, "present"_a = py::none(),
             "progress"_a = Progress(), starts.c_str());
    type.def("success", &Table::success, "shot"_a, py::kw_only(), "pots"_a,
             "first_hit"_a = py::none(), "no_scratch"_a = true, "noise"_a = 1.0,
             "draws"_a = std::uint64_t{10000}, "seed"_a = std::uint64_t{0}, "width"_a = 0.0,
             "confidence"_a = 0.95,
             R"(How often a strike succeeds that nobody executes exactly.

shot: speed, azimuth, elevation, offset of the tip, as a row of strike(). pots: ids of balls that all
have to fall. first_hit: id of the ball that the cue ball has to hit first. no_scratch: the cue ball
must not fall. noise: as in perturb(). draws: at most; width: stop when the interval is not wider.
Gives probability, its interval from low to high, draws, successes, impossible, unfinished.)");
    type.def_property_readonly("scene", &Table::scene, "The table that is played.");
    type.def_property_readonly(
        "engine", [](const Table& table) { return table.batch().engine_name(); },
        "Name of the engine that plays.");
    type.def_property_readonly(
        "threads", [](const Table& table) { return table.batch().threads(); },
        "Number of threads, the calling one among them.");

    const std::string all = std::string(kStrikes) + kOptions + "\n" + kColumns;
    module.def(
        "simulate_batch",
        [](const Scene& scene, const Rows& shots, const std::string& precision,
           const std::string& record, bool states, std::optional<double> time,
           std::optional<std::uint64_t> events, unsigned threads, std::size_t chunk,
           const Progress& progress) {
            return Table(scene, precision, record, states, time, events, threads, chunk)
                .strike(shots, progress);
        },
        "scene"_a, "shots"_a, py::kw_only(), "precision"_a = "double", "record"_a = "none",
        "states"_a = false, "time"_a = py::none(), "events"_a = py::none(), "threads"_a = 0U,
        "chunk"_a = std::size_t{0}, "progress"_a = Progress(), all.c_str());
}

}  // namespace osculo::python

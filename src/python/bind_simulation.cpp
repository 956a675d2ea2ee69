#include <memory>
#include <mutex>
#include <optional>

#include <pybind11/stl.h>

#include "osculo/io.hpp"
#include "osculo/simulation.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/run.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// A simulation that several threads may get hold of: one after the other, none of them with the
/// interpreter's lock.
class SharedSimulation {
public:
    explicit SharedSimulation(Simulation simulation) : simulation_(std::move(simulation)) {}

    template <class Function>
    auto with(Function function) {
        const py::gil_scoped_release release;
        const std::lock_guard lock(mutex_);
        return function(simulation_);
    }

private:
    Simulation simulation_;
    std::mutex mutex_;
};

std::unique_ptr<SharedSimulation> shared(Simulation simulation) {
    return std::make_unique<SharedSimulation>(std::move(simulation));
}

std::unique_ptr<SharedSimulation> copy(SharedSimulation& self) {
    return shared(self.with([](const Simulation& simulation) { return simulation; }));
}

py::bytes snapshot(SharedSimulation& self) {
    return self.with(io::simulation_to_snapshot);
}

std::unique_ptr<SharedSimulation> from_snapshot(const py::bytes& bytes) {
    const std::string content(bytes);
    const py::gil_scoped_release release;
    return shared(io::simulation_from_snapshot(content));
}

}  // namespace

void bind_simulation(py::module_& module) {
    using Self = SharedSimulation;
    py::class_<Self> type(module, "Simulation", R"(A run in parts: played on, copied, kept.

Stopping disturbs nothing: what comes out is, bit for bit, what simulate() computes. Can be copied and
pickled wherever it is, and each copy played on.)");
    type.def(
        py::init([](const Scene& scene, const std::string& precision, const std::string& record) {
            return shared(Simulation(scene, options_from(precision, record)));
        }),
        "scene"_a, py::kw_only(), "precision"_a = "double", "record"_a = "pieces",
        "At the start of the scene's run. Options as for simulate(). Raises SceneError.");
    type.def(
        "play",
        [](Self& self, std::optional<double> time, std::optional<std::uint64_t> events) {
            return to_string(self.with([&](Simulation& simulation) {
                const Limits& most = simulation.limits();
                return simulation.play({time.value_or(most.time), events.value_or(most.events)});
            }));
        },
        py::kw_only(), "time"_a = py::none(), "events"_a = py::none(),
        R"(Plays on until that time [s] or number of events, both counted from the start of the run, or to
the scene's limits. Returns how it ended, as Run.status. Other threads run meanwhile.)");
    type.def_property_readonly(
        "time", [](Self& self) { return self.with([](const Simulation& s) { return s.time(); }); },
        "The instant of the last event [s].");
    type.def_property_readonly(
        "event_count",
        [](Self& self) { return self.with([](const Simulation& s) { return s.event_count(); }); },
        "Number of events so far.");
    type.def_property_readonly(
        "status",
        [](Self& self) {
            return to_string(self.with([](const Simulation& s) { return s.status(); }));
        },
        "How play() ended last; \"event_limit\" before the first time.");
    type.def(
        "result",
        [](Self& self) {
            return RecordedRun(self.with([](const Simulation& s) { return s.result(); }));
        },
        "The Run that simulate() returns with the limits of the last play().");
    type.def("snapshot", snapshot, R"(All of it as bytes (osculo/snapshot-1), for a file.)");
    type.def_static("from_snapshot", from_snapshot, "snapshot"_a,
                    "Where it was when snapshot() gave the bytes. Raises FormatError, SceneError.");
    type.def("__copy__", copy);
    type.def(
        "__deepcopy__", [](Self& self, const py::dict&) { return copy(self); }, "memo"_a);
    type.def(py::pickle([](Self& self) { return snapshot(self); },
                        [](const py::bytes& bytes) { return from_snapshot(bytes); }));
}

}  // namespace osculo::python

#include <algorithm>
#include <variant>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "osculo/io.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/final_ball.hpp"
#include "python/run.hpp"
#include "python/scene.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

using Times = py::array_t<double, py::array::c_style | py::array::forcecast>;

template <class Row>
py::array rows(const std::vector<Row>& rows, const py::dtype& dtype, const py::object& owner) {
    return view(dtype, {static_cast<py::ssize_t>(rows.size())}, rows.data(), owner);
}

py::array final_balls(const Run& run) {
    py::array array(final_ball_dtype(), static_cast<py::ssize_t>(run.balls.size()));
    auto* const rows = static_cast<FinalBallRow*>(array.mutable_data());
    std::ranges::transform(run.balls, rows, row_of);
    return array;
}

py::array states_at(const RecordedRun& recorded, const Times& times) {
    const auto balls = static_cast<std::uint32_t>(recorded.run().balls.size());
    std::vector<py::ssize_t> shape(times.shape(), times.shape() + times.ndim());
    shape.push_back(balls);
    py::array array(state_dtype(), shape);
    auto* state = static_cast<BallState*>(array.mutable_data());
    for (const double* time = times.data(); time != times.data() + times.size(); ++time) {
        for (std::uint32_t ball = 0; ball < balls; ++ball) *state++ = recorded.at(ball, *time);
    }
    return array;
}

// A part of the run that a file has under that name: everything else is left out first.
py::object part(const Run& run, const char* name, bool keeps_events) {
    Run light = run;
    light.pieces.clear();
    if (!keeps_events) light.events.clear();
    const py::dict document = parsed(io::run_to_json(light));
    return document.contains(name) ? py::object(document[name]) : py::none();
}

std::string shown(const Run& run) {
    return "<osculo.Run: " + std::string(to_string(run.status)) + " at " +
           py::repr(py::float_(run.time)).cast<std::string>() + " s, " +
           std::to_string(run.event_count) + " events>";
}

using Type = py::class_<RecordedRun>;

void bind_scalars(Type& type) {
    type.def_property_readonly(
        "scene", [](const RecordedRun& self) { return self.run().scene; }, "What was simulated.");
    type.def_property_readonly(
        "status", [](const RecordedRun& self) { return to_string(self.run().status); },
        "How it ended: \"at_rest\", \"time_limit\", \"event_limit\", \"zeno\" or \"numeric\".");
    type.def_property_readonly(
        "time", [](const RecordedRun& self) { return self.run().time; },
        "Simulated time at the end [s].");
    type.def_property_readonly(
        "event_count", [](const RecordedRun& self) { return self.run().event_count; },
        "Number of events, whether recorded or not.");
    type.def_property_readonly(
        "settled_count", [](const RecordedRun& self) { return self.run().settled_count; },
        "Number of impacts that did not bounce because they were too slow.");
    type.def_property_readonly(
        "engine", [](const RecordedRun& self) { return self.run().engine.name; },
        "Name of the engine that ran the scene.");
    type.def_property_readonly(
        "points", [](const RecordedRun& self) { return py::tuple(py::cast(self.run().points)); },
        "Names of the end points of segments and arcs, e.g. \"rail-3.from\".");
}

void bind_arrays(Type& type) {
    type.def_property_readonly(
        "events",
        [](const py::object& self) {
            return rows(self.cast<const RecordedRun&>().run().events, event_dtype(), self);
        },
        R"(The events in order of time: a structured array, a view.

time + time_low [s]: the instant. kind: code, see EVENT_KINDS. ball: index into scene.ids. other:
index into scene.ids, the scene's segments, arcs or rims, or `points`, by kind. point: where the
boundaries touch (capture: the centre) [m]. normal: unit, from ball to other. before, after: states
(position [m], velocity [m/s], spin [rad/s]) of the ball and, for ball_ball, the other one. cluster:
the same number, from 1 on, for contacts that were resolved together, else 0; well_posed: whether
every law has the same outcome for them. from, to: codes of the phases of a transition, see PHASES.)");
    type.def_property_readonly(
        "pieces",
        [](const py::object& self) {
            return rows(self.cast<const RecordedRun&>().run().pieces, piece_dtype(), self);
        },
        R"(Every trajectory, in analytic pieces: a structured array, a view.

ball: index into scene.ids. from + from_low, to + to_low [s]. position + position_low [m], velocity
[m/s] and spin [rad/s] at `from`; acceleration [m/s^2], spin_rate [rad/s^2], resistance (of drag).
rim: index into scene.rim_ids, in the phases "rim", "tipping" and "flying"; height [m], climb [m/s],
inertia: in the last two. phase: code, see PHASES. Run.at() evaluates them.)");
    type.def_property_readonly(
        "balls", [](const RecordedRun& self) { return final_balls(self.run()); },
        R"(The balls at the end (captured ones as they were then): a structured array.

fate: code, see FATES. rim: index into scene.rim_ids, or -1. state: position [m], velocity [m/s], spin
[rad/s].)");
    type.def("at", states_at, "time"_a,
             R"(The states of all balls at a time, or at each of an array of times [s].

A structured array with position [m], velocity [m/s] and spin [rad/s], of the shape of `time` and the
number of balls behind it. NaN before the start, after the end, after a ball's capture, and if no
pieces were recorded. Exact to a few units in the last place.)");
    type.def(
        "ids",
        [](const RecordedRun& self, std::int64_t index) {
            const Run& run = self.run();
            const auto count = static_cast<std::int64_t>(run.events.size());
            if (index < -count || index >= count) throw py::index_error("no such event");
            const auto [ball, other] =
                run.ids(run.events[static_cast<std::size_t>(index < 0 ? index + count : index)]);
            return py::make_tuple(ball, other);
        },
        "event"_a, "The ids of the two things that take part in the event of that index.");
}

void bind_documents(Type& type) {
    type.def_property_readonly(
        "outcome", [](const RecordedRun& self) { return part(self.run(), "outcome", true); },
        "The shot in the terms of those who play: hits, falls, cushions, kisses, as in run files. "
        "None if no events were recorded. Made anew at every use.");
    type.def_property_readonly(
        "audit", [](const RecordedRun& self) { return part(self.run(), "audit", false); },
        "What an independent check of the pieces found, as in run files, or None.");
    type.def_property_readonly(
        "certificate",
        [](const RecordedRun& self) { return part(self.run(), "certificate", true); },
        "Which events are certain and to how many digits, as in run files, or None.");
    type.def(
        "to_json", [](const RecordedRun& self) { return io::run_to_json(self.run()); },
        "The run as a file (osculo/run-1). Numbers read back as the same doubles.");
    type.def(
        "to_dict", [](const RecordedRun& self) { return parsed(io::run_to_json(self.run())); },
        "The same as a dict.");
    type.def(
        "to_svg",
        [](const RecordedRun& self, double width, bool numbers) {
            return io::to_svg(self.run(), {.width = width, .numbers = numbers});
        },
        py::kw_only(), "width"_a = 1200.0, "numbers"_a = true,
        "A picture: table, paths, contacts, with their `numbers` in order of time; `width` in px.");
    type.def("_repr_svg_", [](const RecordedRun& self) { return io::to_svg(self.run()); });
    type.def("__repr__", [](const RecordedRun& self) { return shown(self.run()); });
    type.def(
        py::pickle([](const RecordedRun& self) { return io::run_to_json(self.run()); },
                   [](const std::string& json) { return RecordedRun(io::run_from_json(json)); }));
}

}  // namespace

void bind_run(py::module_& module) {
    Type type(module, "Run", R"(The result of simulate().

Nothing in it changes. Arrays that are views keep it alive.)");
    bind_scalars(type);
    bind_arrays(type);
    bind_documents(type);
    module.def(
        "parse",
        [](const std::string& text) -> py::object {
            auto parsed = io::scene_or_run_from_json(text);
            if (auto* const scene = std::get_if<Scene>(&parsed)) return py::cast(std::move(*scene));
            return py::cast(RecordedRun(std::get<Run>(std::move(parsed))));
        },
        "text"_a, "The scene or the run that a JSON text is. Raises SceneError, FormatError.");
    module.def(
        "parse_msgpack",
        [](const py::bytes& bytes) -> py::object {
            auto parsed = io::scene_or_run_from_msgpack(std::string(bytes));
            if (auto* const scene = std::get_if<Scene>(&parsed)) return py::cast(std::move(*scene));
            return py::cast(RecordedRun(std::get<Run>(std::move(parsed))));
        },
        "bytes"_a, "The same from MessagePack.");
}

}  // namespace osculo::python

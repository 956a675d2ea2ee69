#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include "osculo/io.hpp"
#include "osculo/simulate.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/scene.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

Scene scene_from(const py::object& source, const py::dict& members) {
    const py::object as_json = py::module_::import("osculo._documents").attr("as_json");
    return io::scene_from_json(as_json(source, members).cast<std::string>());
}

py::object parsed(const std::string& json) {
    return py::module_::import("json").attr("loads")(json);
}

namespace {

Scene make_scene(const py::object& source, const py::kwargs& members) {
    if (!py::isinstance<Scene>(source)) return scene_from(source, members);
    const auto& scene = source.cast<const Scene&>();
    if (members.empty()) return scene;
    return scene_from(parsed(io::scene_to_json(scene)), members);
}

std::string shown(const Scene& scene) {
    std::string text = "<osculo.Scene:";
    const auto count = [&](std::size_t number, const char* singular) {
        text += " " + std::to_string(number) + " " + singular + (number == 1 ? "," : "s,");
    };
    count(scene.balls.size(), "ball");
    count(scene.segments.size(), "segment");
    count(scene.arcs.size(), "arc");
    count(scene.rims.size(), "rim");
    if (scene.cue) text += " a cue,";
    text.back() = '>';
    return text;
}

template <class Thing>
py::tuple ids_of(const std::vector<Thing>& things) {
    py::tuple ids(things.size());
    for (std::size_t i = 0; i < things.size(); ++i) ids[i] = py::str(things[i].id);
    return ids;
}

// One property: a member of each ball, in place.
template <class Member>
void bind_column(py::class_<Scene>& type, const char* name, Member member, py::ssize_t columns,
                 const char* doc) {
    type.def_property_readonly(
        name,
        [member, columns](const py::object& self) {
            const auto& balls = self.cast<const Scene&>().balls;
            return column_of(balls, balls.empty() ? nullptr : member(balls[0]), columns, self);
        },
        doc);
}

void bind_columns(py::class_<Scene>& type) {
    bind_column(
        type, "positions", [](const Ball& ball) { return &ball.position.x; }, 2,
        "Of the centres of the balls [m], in the order of `ids`: shape (N, 2). A view.");
    bind_column(
        type, "velocities", [](const Ball& ball) { return &ball.velocity.x; }, 2,
        "Of the balls [m/s]: shape (N, 2). A view. Before the cue's strike, if there is one.");
    bind_column(
        type, "spins", [](const Ball& ball) { return ball.spin.data(); }, 3,
        "Angular velocities of the balls [rad/s], z up: shape (N, 3). A view.");
    bind_column(
        type, "radii", [](const Ball& ball) { return &ball.radius; }, 1,
        "Of the balls [m]: shape (N,). A view.");
    bind_column(
        type, "masses", [](const Ball& ball) { return &ball.mass; }, 1,
        "Of the balls [kg]: shape (N,). A view.");
}

}  // namespace

void bind_scene(py::module_& module) {
    py::class_<Scene> type(module, "Scene", R"(Everything that exists: balls, cushions, laws.

SI units and radians. Made from a mapping, a JSON text or another scene, in the form of scene files
(schema osculo/scene-1), and from members by name, which replace those of the source; None leaves a
member out. What was made is valid and does not change.

    Scene(table="pool-9ft", rack="eight-ball", cue={"speed": 8, "azimuth": 1.5707963267948966})

Raises SceneError, with the path of the member, for what breaks a rule.)");
    type.def(py::init(&make_scene), "source"_a = py::none());
    type.def(
        "replace", &make_scene,
        "The scene with these members replaced. A cue without an elevation takes the least that "
        "passes over what is behind the ball.");
    type.def_property_readonly(
        "ids", [](const Scene& scene) { return ids_of(scene.balls); }, "Of the balls, in order.");
    type.def_property_readonly(
        "rim_ids", [](const Scene& scene) { return ids_of(scene.rims); }, "Of the rims, in order.");
    bind_columns(type);
    type.def("__len__", [](const Scene& scene) { return scene.balls.size(); });
    type.def(
        "to_json", [](const Scene& scene) { return io::scene_to_json(scene); },
        "The scene as a file (osculo/scene-1), with table, rack and defaults spelled out. Numbers "
        "read back as the same doubles.");
    type.def(
        "to_dict", [](const Scene& scene) { return parsed(io::scene_to_json(scene)); },
        "The same as a dict.");
    type.def(
        "to_svg",
        [](const Scene& scene, double width) { return io::to_svg(scene, {.width = width}); },
        "width"_a = 1200.0, "A picture of the table and its balls; `width` in px.");
    type.def("_repr_svg_", [](const Scene& scene) { return io::to_svg(scene); });
    type.def(
        "explain",
        [](const Scene& scene, const std::string& precision, const std::string& record) {
            const EngineInfo engine = choose_engine(scene, options_from(precision, record));
            return py::make_tuple(engine.name, engine.left_out);
        },
        py::kw_only(), "precision"_a = "double", "record"_a = "pieces",
        "The name of the engine that simulate() takes for the scene, and what that leaves out.");
    type.def("__repr__", shown);
    type.def(py::self == py::self);
    type.def("__hash__",
             [](const Scene& scene) { return std::hash<std::string>()(io::scene_to_json(scene)); });
    type.def(py::pickle([](const Scene& scene) { return io::scene_to_json(scene); },
                        [](const std::string& json) { return io::scene_from_json(json); }));
    py::implicitly_convertible<py::dict, Scene>();
}

}  // namespace osculo::python

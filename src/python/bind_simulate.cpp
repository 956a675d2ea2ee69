#include <stdexcept>

#include "osculo/simulate.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/run.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

Precision precision_from(const std::string& name) {
    if (const auto precision = precision_from_string(name)) return *precision;
    throw std::invalid_argument(
        "precision must be 'double', 'extended', 'quad', '50' or '100', but it is '" + name + "'");
}

Record record_from(const std::string& name) {
    if (name == "none") return Record::none;
    if (name == "events") return Record::events;
    if (name == "pieces") return Record::pieces;
    throw std::invalid_argument("record must be 'none', 'events' or 'pieces', but it is '" + name +
                                "'");
}

void bind_simulate(py::module_& module) {
    module.def(
        "simulate",
        [](const Scene& scene, const std::string& precision, const std::string& record, bool audit,
           bool certify) {
            Options options = options_from(precision, record);
            options.audit = audit;
            options.certify = certify;
            const py::gil_scoped_release release;
            return RecordedRun(simulate(scene, options));
        },
        "scene"_a, py::kw_only(), "precision"_a = "double", "record"_a = "pieces",
        "audit"_a = false, "certify"_a = false,
        R"(Runs the scene to rest or to its limits.

precision: "double", "extended", "quad", "50" or "100" (digits) of the computation; results are
    rounded to double.
record: "pieces" (every trajectory, and events), "events", or "none" (final states only).
audit: checks the run from its pieces alone; see Run.audit.
certify: runs the scene in higher precisions, too, and says how far the run can be trusted; see
    Run.certificate. Takes 10 to 1000 times as long.

Same scene and options: same bits. Other threads run meanwhile. Raises SceneError.)");
}

}  // namespace osculo::python

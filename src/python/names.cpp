#include "python/names.hpp"

#include "osculo/batch.hpp"
#include "osculo/run.hpp"
#include "python/bindings.hpp"

namespace osculo::python {
namespace {

template <class Enumeration>
pybind11::dict codes() {
    pybind11::dict codes;
    int code = 0;
    for (const std::string_view name : names_of<Enumeration>()) {
        codes[pybind11::str(name.data(), name.size())] = code++;
    }
    return codes;
}

}  // namespace

void bind_names(pybind11::module_& module) {
    module.attr("EVENT_KINDS") = codes<EventKind>();
    module.attr("PHASES") = codes<Phase>();
    module.attr("FATES") = codes<BallFate>();
    module.attr("SHOT_FATES") = codes<ShotFate>();
    module.attr("SHOT_STATUSES") = codes<ShotStatus>();
}

}  // namespace osculo::python

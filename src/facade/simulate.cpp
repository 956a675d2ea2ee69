#include "osculo/simulate.hpp"

#include <array>
#include <utility>

#include "certify.hpp"
#include "ready_engine.hpp"

namespace osculo {
namespace {

constexpr std::array<std::pair<Precision, std::string_view>, 5> kPrecisions{
    {{Precision::double_precision, "double"},
     {Precision::extended, "extended"},
     {Precision::quad, "quad"},
     {Precision::digits50, "50"},
     {Precision::digits100, "100"}}};

}  // namespace

std::string_view to_string(Precision precision) {
    for (const auto& [value, name] : kPrecisions) {
        if (value == precision) return name;
    }
    return "double";
}

std::optional<Precision> precision_from_string(std::string_view name) {
    for (const auto& [value, known] : kPrecisions) {
        if (known == name) return value;
    }
    return std::nullopt;
}

Run simulate(const Scene& scene, const Options& options) {
    validate(scene);
    if (options.audit) {
        for (std::size_t k = 0; k < scene.rims.size(); ++k) {
            if (scene.rims[k].law == RimLaw::capture) continue;
            throw SceneError("rims[" + std::to_string(k) + "].law",
                             "must be capture for an audit, which cannot follow other laws yet",
                             std::string(to_string(scene.rims[k].law)));
        }
    }
    Options kept = options;
    if (options.certify && options.record == Record::none) kept.record = Record::events;
    Run run = facade::narrowest_engine(scene, kept).run(scene, options.audit);
    run.scene = scene;
    run.engine = choose_engine(scene, kept);
    if (options.certify) run.certificate = facade::certify(run, options.precision);
    // An audit needs the pieces, whether they are wanted or not.
    if (kept.record == Record::none) run.events.clear();
    if (options.record != Record::pieces) run.pieces.clear();
    return run;
}

}  // namespace osculo

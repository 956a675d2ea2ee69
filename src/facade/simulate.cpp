#include "osculo/simulate.hpp"

#include <array>
#include <utility>

#include "certify.hpp"
#include "ready_engine.hpp"

namespace osculo {
namespace facade {
namespace {

/// With what it takes besides what is asked for.
Options kept_options(const Options& options) {
    Options kept = options;
    if (options.certify && options.record == Record::none) kept.record = Record::events;
    return kept;
}

}  // namespace

std::unique_ptr<StoppableRun> begin_run(const Scene& scene, const Options& options) {
    return narrowest_engine(scene, kept_options(options)).begin(scene);
}

Run finish_run(StoppableRun& playing, Status status, const Scene& scene, const Options& options) {
    const Options kept = kept_options(options);
    Run run = playing.finish(status, scene.limits, options.audit);
    run.scene = scene;
    run.engine = choose_engine(scene, kept);
    if (options.certify) run.certificate = certify(run, options.precision);
    // An audit needs the pieces, whether they are wanted or not.
    if (kept.record == Record::none) run.events.clear();
    if (options.record != Record::pieces) run.pieces.clear();
    return run;
}

}  // namespace facade

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
    const auto playing = facade::begin_run(scene, options);
    const Status status = playing->play(scene.limits);
    return facade::finish_run(*playing, status, scene, options);
}

}  // namespace osculo

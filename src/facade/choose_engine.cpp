#include <array>

#include "ready_engine.hpp"

namespace osculo {
namespace facade {
namespace {

/// From about this many balls on the cell grid is faster than looking at all pairs
/// (bench/README.md).
constexpr std::size_t kFewBalls = 64;

bool covers(const ReadyEngine& engine, const Scene& scene, const Options& options) {
    const bool table = !scene.arcs.empty() || !scene.rims.empty();
    const Record record = options.audit ? Record::pieces : options.record;
    return engine.precision == options.precision && engine.record == record &&
           (engine.arcs_and_rims || !table) && (engine.segments || scene.segments.empty()) &&
           (engine.cell_grid || scene.balls.size() <= kFewBalls);
}

}  // namespace

const ReadyEngine& narrowest_engine(const Scene& scene, const Options& options) {
    const std::array groups{double_open_engines(), double_walls_engines(), double_table_engines(),
                            extended_engines(),    quad_engines(),         digits50_engines(),
                            digits100_engines()};
    for (const auto& group : groups) {
        for (const ReadyEngine& engine : group) {
            if (covers(engine, scene, options)) return engine;
        }
    }
    // Each precision has an engine with every obstacle, every recorder and the cell grid.
    return double_table_engines().back();
}

}  // namespace facade

EngineInfo choose_engine(const Scene& scene, const Options& options) {
    const facade::ReadyEngine& engine = facade::narrowest_engine(scene, options);
    EngineInfo info{engine.name(), {}};
    const auto leave_out = [&](const char* what) { info.left_out.emplace_back(what); };
    leave_out("acceleration: the motion law is uniform");
    leave_out("spin and friction: no impact law of the scene uses them");
    if (!engine.segments) leave_out("segments and end points: the scene has none");
    if (!engine.arcs_and_rims) leave_out("arcs and rims: the scene has none");
    if (!engine.cell_grid) leave_out("cell grid: with few balls, all pairs are faster");
    if (engine.record == Record::none) leave_out("events: not asked for");
    if (engine.record != Record::pieces) leave_out("pieces: not asked for");
    return info;
}

}  // namespace osculo

#include <algorithm>
#include <array>

#include "ready_engine.hpp"

namespace osculo {
namespace facade {
namespace {

/// From about this many balls on the cell grid is faster than looking at all pairs
/// (bench/README.md).
constexpr std::size_t kFewBalls = 12;

bool covers(const ReadyEngine& engine, const Scene& scene, const Options& options) {
    const bool table = !scene.arcs.empty() || !scene.rims.empty();
    const bool pulls =
        std::ranges::any_of(scene.rims, [](const Rim& rim) { return rim.law == RimLaw::paper; });
    const auto motion = static_cast<MotionKind>(scene.motion.index());
    const bool moves =
        engine.motion == motion || (pulls && motion == MotionKind::uniform &&
                                    engine.motion == MotionKind::rolling);  // without friction
    const Record record = options.audit ? Record::pieces : options.record;
    return engine.precision == options.precision && moves && engine.pulling_rims == pulls &&
           engine.cushion == scene.impacts.ball_cushion.law && engine.record >= record &&
           (engine.arcs_and_rims || !table) && (engine.segments || scene.segments.empty()) &&
           (engine.cell_grid || engine.motion != MotionKind::uniform ||
            scene.balls.size() <= kFewBalls);
}

}  // namespace

const ReadyEngine& narrowest_engine(const Scene& scene, const Options& options) {
    const std::array groups{double_open_engines(),
                            double_walls_engines(),
                            double_table_engines(),
                            double_rolling_engines(),
                            double_rims_engines(),
                            double_cloth_engines(),
                            double_cloth_han_engines(),
                            double_cloth_mathavan_engines(),
                            double_cloth_stronge_engines(),
                            extended_engines(),
                            quad_engines(),
                            digits50_engines(),
                            digits100_engines()};
    for (const auto& group : groups) {
        for (const ReadyEngine& engine : group) {
            if (covers(engine, scene, options)) return engine;
        }
    }
    // Every precision has engines with every obstacle, every recorder and every motion law.
    throw SceneError("impacts.ball_cushion.law",
                     "must be restitution or han_2005 for a precision other than double",
                     std::string(to_string(scene.impacts.ball_cushion.law)) + " with " +
                         std::string(to_string(options.precision)));
}

}  // namespace facade

EngineInfo choose_engine(const Scene& scene, const Options& options) {
    const facade::ReadyEngine& engine = facade::narrowest_engine(scene, options);
    EngineInfo info{engine.name(), {}};
    const auto leave_out = [&](const char* what) { info.left_out.emplace_back(what); };
    using facade::MotionKind;
    if (engine.motion == MotionKind::uniform) leave_out("acceleration: the motion law is uniform");
    if (engine.motion != MotionKind::cloth) leave_out("spin and friction: there is no cloth");
    if (!engine.segments) leave_out("segments and end points: the scene has none");
    if (!engine.arcs_and_rims) leave_out("arcs and rims: the scene has none");
    if (!engine.cell_grid) {
        leave_out(engine.motion == MotionKind::uniform
                      ? "cell grid: with few balls, all pairs are faster"
                      : "cell grid: only free flight has one");
    }
    if (engine.record == Record::none) leave_out("events: not asked for");
    if (engine.record != Record::pieces) leave_out("pieces: not asked for");
    return info;
}

}  // namespace osculo

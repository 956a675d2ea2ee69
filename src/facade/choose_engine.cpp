#include <algorithm>
#include <array>

#include "ready_engine.hpp"
#include "text.hpp"

namespace osculo {
namespace facade {
namespace {

/// From about this many balls on the cell grid is faster than looking at all pairs
/// (bench/README.md).
constexpr std::size_t kFewBalls = 12;

/// Whether friction is asked for without a cloth, of balls that turn about the vertical then.
bool has_discs(const Scene& scene) {
    return !std::holds_alternative<ClothMotion>(scene.motion) &&
           (scene.impacts.ball_ball.law == BallBallLaw::frictional ||
            scene.impacts.ball_cushion.law == CushionLaw::frictional);
}

bool has_rims(const Scene& scene, RimLaw law) {
    return std::ranges::any_of(scene.rims, [law](const Rim& rim) { return rim.law == law; });
}

/// Discs have one engine for every motion law and cushion of theirs; rims that pull have one for
/// free flight too, which is rolling without friction.
bool covers_laws(const ReadyEngine& engine, const Scene& scene) {
    if (has_discs(scene)) return engine.discs;
    const auto motion = static_cast<MotionKind>(scene.motion.index());
    const bool pulls = has_rims(scene, RimLaw::paper);
    const bool tips = has_rims(scene, RimLaw::tipping);
    const bool moves =
        engine.motion == motion ||
        ((pulls || tips) && motion == MotionKind::uniform && engine.motion == MotionKind::rolling);
    return !engine.discs && moves && engine.pulling_rims == pulls && engine.tipping_rims == tips &&
           engine.cushion == scene.impacts.ball_cushion.law;
}

bool covers(const ReadyEngine& engine, const Scene& scene, const Options& options) {
    const bool table = !scene.arcs.empty() || !scene.rims.empty();
    const Record record = options.audit ? Record::pieces : options.record;
    return engine.precision == options.precision && covers_laws(engine, scene) &&
           engine.simultaneous == scene.impacts.simultaneous && engine.record >= record &&
           (engine.arcs_and_rims || !table) && (engine.segments || scene.segments.empty()) &&
           (engine.cell_grid || engine.motion != MotionKind::uniform ||
            scene.balls.size() <= kFewBalls);
}

}  // namespace

const ReadyEngine& narrowest_engine(const Scene& scene, const Options& options, bool batch) {
    const std::array groups{double_open_engines(),
                            double_walls_engines(),
                            double_table_engines(),
                            double_rolling_engines(),
                            double_resisted_engines(),
                            double_disc_engines(),
                            double_rims_engines(),
                            double_tipping_rims_engines(),
                            double_cloth_engines(),
                            double_cloth_han_engines(),
                            double_cloth_mathavan_engines(),
                            double_cloth_stronge_engines(),
                            extended_engines(),
                            quad_engines(),
                            digits50_engines(),
                            digits100_engines(),
                            double_table_symmetric_engines(),
                            double_rolling_symmetric_engines(),
                            double_resisted_symmetric_engines(),
                            double_disc_symmetric_engines(),
                            double_rims_symmetric_engines(),
                            double_tipping_rims_symmetric_engines(),
                            double_cloth_symmetric_engines(),
                            double_cloth_han_symmetric_engines(),
                            double_cloth_mathavan_symmetric_engines(),
                            double_cloth_stronge_symmetric_engines(),
                            extended_symmetric_engines(),
                            quad_symmetric_engines(),
                            digits50_symmetric_engines(),
                            digits100_symmetric_engines()};
    for (const auto& group : groups) {
        for (const ReadyEngine& engine : group) {
            const bool suits = batch ? engine.make_player != nullptr : engine.begin != nullptr;
            if (suits && covers(engine, scene, options)) return engine;
        }
    }
    if (has_discs(scene)) {
        throw SceneError("impacts", "must be without friction for a precision other than double",
                         concatenated("friction with ", to_string(options.precision)));
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
    if (engine.motion != MotionKind::resisted) leave_out("drag: the motion law is not resisted");
    if (engine.discs) {
        leave_out("spin about horizontal axes: there is no cloth");
    } else if (engine.motion != MotionKind::cloth) {
        leave_out("spin and friction: there is no cloth");
    }
    if (engine.simultaneous == Simultaneous::sequential) {
        leave_out("clusters: impacts at one instant are resolved pair by pair");
    }
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

#pragma once

#include <memory>
#include <span>
#include <string>

#include "osculo/simulate.hpp"
#include "shot_player.hpp"
#include "stoppable_run.hpp"

namespace osculo::facade {

/// The alternatives of MotionLaw, in its order.
enum class MotionKind { uniform, rolling, cloth, resisted };

/// One of the engines that the library contains, and what it covers.
struct ReadyEngine {
    Precision precision;
    MotionKind motion;
    bool discs;  ///< balls turn about the vertical, and rub: for every motion law but cloth
    CushionLaw cushion;
    Simultaneous simultaneous;
    bool segments;  ///< and end points
    bool arcs_and_rims;
    bool pulling_rims;  ///< with the law paper; of free flight too
    bool tipping_rims;  ///< with the law tipping; likewise
    Record record;      ///< at most this
    bool cell_grid;     ///< for many balls; gives the same results as all pairs
    std::string (*name)();
    /// Begins the run of a valid scene, to which it keeps a reference. Null if the engine is for
    /// batches only.
    std::unique_ptr<StoppableRun> (*begin)(const Scene& scene);
    /// Makes a player for batches. Null if it does not see the contacts that they count.
    std::unique_ptr<ShotPlayer> (*make_player)(const Scene& scene);
};

/// The engines of one translation unit each, narrowest first.
[[nodiscard]] std::span<const ReadyEngine> double_open_engines();
[[nodiscard]] std::span<const ReadyEngine> double_walls_engines();
[[nodiscard]] std::span<const ReadyEngine> double_table_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rolling_engines();
[[nodiscard]] std::span<const ReadyEngine> double_resisted_engines();
[[nodiscard]] std::span<const ReadyEngine> double_disc_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rims_engines();
[[nodiscard]] std::span<const ReadyEngine> double_tipping_rims_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_han_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_mathavan_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_stronge_engines();
[[nodiscard]] std::span<const ReadyEngine> extended_engines();
[[nodiscard]] std::span<const ReadyEngine> quad_engines();
[[nodiscard]] std::span<const ReadyEngine> digits50_engines();
[[nodiscard]] std::span<const ReadyEngine> digits100_engines();
[[nodiscard]] std::span<const ReadyEngine> double_table_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rolling_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_resisted_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_disc_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rims_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_tipping_rims_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_han_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_mathavan_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_stronge_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> extended_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> quad_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> digits50_symmetric_engines();
[[nodiscard]] std::span<const ReadyEngine> digits100_symmetric_engines();

/// The narrowest engine that covers the scene.
[[nodiscard]] const ReadyEngine& narrowest_engine(const Scene& scene, const Options& options,
                                                  bool batch = false);

/// Begins the run of a valid scene, to which it keeps a reference, with what its options need.
[[nodiscard]] std::unique_ptr<StoppableRun> begin_run(const Scene& scene, const Options& options);
/// Ends a run that has been played to the scene's limits, and adds what its options ask for.
[[nodiscard]] Run finish_run(StoppableRun& playing, Status status, const Scene& scene,
                             const Options& options);

}  // namespace osculo::facade

#pragma once

#include <span>
#include <string>

#include "osculo/simulate.hpp"

namespace osculo::facade {

/// The alternatives of MotionLaw, in its order.
enum class MotionKind { uniform, rolling, cloth };

/// One of the engines that the library contains, and what it covers.
struct ReadyEngine {
    Precision precision;
    MotionKind motion;
    CushionLaw cushion;
    bool segments;  ///< and end points
    bool arcs_and_rims;
    bool pulling_rims;  ///< with the law paper; of free flight too
    Record record;      ///< at most this
    bool cell_grid;     ///< for many balls; gives the same results as all pairs
    std::string (*name)();
    /// Runs a valid scene. With `audit`, requires record == pieces.
    Run (*run)(const Scene& scene, bool audit);
};

/// The engines of one translation unit each, narrowest first.
[[nodiscard]] std::span<const ReadyEngine> double_open_engines();
[[nodiscard]] std::span<const ReadyEngine> double_walls_engines();
[[nodiscard]] std::span<const ReadyEngine> double_table_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rolling_engines();
[[nodiscard]] std::span<const ReadyEngine> double_rims_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_han_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_mathavan_engines();
[[nodiscard]] std::span<const ReadyEngine> double_cloth_stronge_engines();
[[nodiscard]] std::span<const ReadyEngine> extended_engines();
[[nodiscard]] std::span<const ReadyEngine> quad_engines();
[[nodiscard]] std::span<const ReadyEngine> digits50_engines();
[[nodiscard]] std::span<const ReadyEngine> digits100_engines();

/// The narrowest engine that covers the scene.
[[nodiscard]] const ReadyEngine& narrowest_engine(const Scene& scene, const Options& options);

}  // namespace osculo::facade

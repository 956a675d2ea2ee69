#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "osculo/batch.hpp"
#include "outline.hpp"

namespace osculo::facade {

/// The scene without its cue, with other limits if there are any. Throws SceneError if it is not
/// valid, or would not be with any strike of its cue.
[[nodiscard]] Scene batch_base(const Scene& scene, const std::optional<Limits>& limits);

/// Throws SceneError unless the cue can strike a ball of the scene, given a possible strike.
void validate_cue_of(const Scene& base, const Cue& cue);

/// Number of shots. Throws std::invalid_argument if the sizes do not fit to the scene.
[[nodiscard]] std::size_t count_shots(const Scene& scene, const Starts& starts);

/// The table of one thread, on which it lays out one shot after another. Allocates nothing after
/// the first of a kind.
class ShotTable {
public:
    /// Keeps a reference to a valid scene without a cue.
    explicit ShotTable(const Scene& base) : base_(base), scene_(base) {}

    /// Both return false if the shot's scene is not valid.
    [[nodiscard]] bool set_up(const Cue& cue, const Strike& strike);
    [[nodiscard]] bool set_up(const Starts& starts, std::size_t shot);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// 0 for balls that are not there; empty if all are.
    [[nodiscard]] std::span<const std::uint8_t> present() const { return present_; }

private:
    [[nodiscard]] bool is_closed();

    const Scene& base_;
    Scene scene_;
    std::span<const std::uint8_t> present_;
    bool is_moved_ = false;
    std::vector<std::pair<double, Outline>> outlines_;  ///< by the smallest radius
};

}  // namespace osculo::facade

#pragma once

#include <optional>
#include <random>
#include <string>

#include "presets/tables.hpp"

// The racks, one file each.
namespace osculo::presets {

/// Puts balls of one kind on a table.
class Racker {
public:
    Racker(Scene& scene, const Bed& bed, double mass, double radius, const RackOptions& options);

    [[nodiscard]] const Bed& bed() const { return bed_; }

    /// Between the centres of neighbours [m].
    [[nodiscard]] double spacing() const { return 2 * radius_ + gap_; }

    /// Between rows of a triangle of neighbours [m].
    [[nodiscard]] double row_height() const;

    /// A ball on its spot.
    void add(const std::string& id, Point place);

    /// A ball among neighbours: displaced at random, if that was asked for, by less than half the
    /// gap.
    void add_shaken(const std::string& id, Point place);

    /// The ball "cue", unless the scene has one.
    void add_cue(Point place);

private:
    Scene& scene_;
    Bed bed_;
    double mass_;
    double radius_;
    double gap_;
    std::optional<std::mt19937_64> random_;
};

/// Fifteen balls in a triangle, the apex on the foot spot (three quarters of the length), the cue
/// ball on the head spot (a quarter).
void add_eight_ball(Scene& scene, const Bed& bed, const RackOptions& options);

/// Nine balls in a diamond, the 1 on the foot spot, the 9 in the middle, the cue ball on the head
/// spot.
void add_nine_ball(Scene& scene, const Bed& bed, const RackOptions& options);

/// Fifteen reds, six colours on their spots, the cue ball on the edge of the D.
void add_snooker(Scene& scene, const Bed& bed, const RackOptions& options);

/// The three balls at the start: red, yellow and the cue ball.
void add_three_cushion(Scene& scene, const Bed& bed, const RackOptions& options);

}  // namespace osculo::presets

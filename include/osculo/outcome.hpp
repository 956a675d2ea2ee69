#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "osculo/run.hpp"

namespace osculo {

/// What came of a shot, in the terms of those who play.
///
/// Events of the same two things, each within kSameContact of the last, are one contact: balls that
/// are pressed together or against a cushion meet many times. Contacts with cushions are those with
/// segments, arcs and their end points. Each of these counts for itself, so that a ball that
/// rattles in the jaws of a pocket has several.
struct Outcome {
    /// [s]. Far longer than balls that are pressed together take to meet again, far shorter than a
    /// ball takes to come back from anywhere else.
    static constexpr double kSameContact = 0.01;

    /// A ball that was captured.
    struct Fall {
        std::uint32_t ball = 0;  ///< index into scene.balls
        std::uint32_t rim = 0;   ///< index into scene.rims
        double time = 0;         ///< [s]
        friend bool operator==(const Fall&, const Fall&) = default;
    };

    /// The cue ball's first contact with another ball.
    struct Hit {
        std::uint32_t ball = 0;      ///< index into scene.balls
        double time = 0;             ///< [s]
        std::uint64_t cushions = 0;  ///< the cue ball's contacts with cushions until then
        friend bool operator==(const Hit&, const Hit&) = default;
    };

    /// What one ball met, and where it ended.
    struct Tally {
        std::uint64_t balls = 0;     ///< contacts with other balls
        std::uint64_t cushions = 0;  ///< contacts with cushions
        Point position;              ///< at the end, or where it was captured [m]
        friend bool operator==(const Tally&, const Tally&) = default;
    };

    /// Index into scene.balls: the ball that the cue strikes, or else the only one that moves at
    /// the start. Without one there are no hits, and every contact between balls is a kiss.
    std::optional<std::uint32_t> cue_ball;
    std::vector<Hit> hits;                  ///< in order of time: at most one for each ball
    std::vector<Fall> falls;                ///< in order of time
    std::uint64_t cushions_before_hit = 0;  ///< of the cue ball, until its first hit or the end
    std::uint64_t cushions_after_hit = 0;   ///< of the cue ball, after its first hit
    /// Contacts between balls other than hits: of two object balls, or of the cue ball with a ball
    /// that it has hit before.
    std::uint64_t kisses = 0;
    std::uint64_t driven_to_cushion = 0;  ///< balls other than the cue ball that met a cushion
    std::optional<double> rest_time;      ///< when the last ball came to rest [s], if all did
    std::vector<Tally> balls;             ///< in the scene's order
    friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// The outcome of a run; nothing if its events were not recorded. O(events).
[[nodiscard]] std::optional<Outcome> outcome_of(const Run& run);

}  // namespace osculo

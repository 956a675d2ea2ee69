#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "osculo/simulate.hpp"
#include "outcome_counter.hpp"

namespace osculo::facade {

/// What came of one shot of a batch; used again for the next one.
struct PlayedShot {
    Status status = Status::at_rest;
    double time = 0;
    std::uint64_t event_count = 0;
    std::uint64_t settled_count = 0;
    OutcomeCounter counter;
    std::vector<FinalBall> balls;  ///< in the scene's order; of absent ones: anything
    Record record = Record::none;  ///< what is wanted of these, to which the shot's are added:
    std::vector<Event> events;
    std::vector<Piece> pieces;
};

/// Plays one shot after another on the table of one scene, with one engine. Not to be shared by
/// threads.
class ShotPlayer {
public:
    ShotPlayer() = default;
    ShotPlayer(const ShotPlayer&) = delete;
    ShotPlayer& operator=(const ShotPlayer&) = delete;
    virtual ~ShotPlayer() = default;

    /// Plays the scene as it is now: cue and states of the balls may have changed, nothing else.
    /// Requires a valid scene. Balls whose entry in [present] is 0 are left out; none of them if it
    /// is empty.
    virtual void play(std::span<const std::uint8_t> present, const Limits& limits,
                      PlayedShot& played) = 0;

    /// Names of the end points, as in a Run.
    [[nodiscard]] virtual const std::vector<std::string>& points() const = 0;
};

}  // namespace osculo::facade

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace osculo {

/// How far a run can be trusted: what a run of the same scene in a higher precision says about it,
/// which a third run in yet another precision confirms.
///
/// An event is confirmed if each ball that takes part in it has the same history up to it in every
/// one of the three: the same kinds of events with the same things. Digits are decimal and
/// relative: of an instant to the instant, of a position to its distance from the origin or the
/// ball's radius, whichever is more, of a velocity to the ball's largest speed in the run (where no
/// event shows one, at the end). They are the fewest that two of the runs have in common, and at
/// most kMostDigits: results are rounded to double.
struct Certificate {
    static constexpr double kMostDigits = 16;

    /// Of one event.
    struct EventDigits {
        bool confirmed = false;
        double time = 0;      ///< digits; 0 unless confirmed
        double position = 0;  ///< of all its balls
        double velocity = 0;  ///< of all its balls, before and after
        friend bool operator==(const EventDigits&, const EventDigits&) = default;
    };

    /// Of one ball at the end of the run.
    struct BallDigits {
        bool confirmed = false;  ///< its whole history and its fate
        double position = 0;     ///< digits; 0 unless confirmed
        double velocity = 0;
        friend bool operator==(const BallDigits&, const BallDigits&) = default;
    };

    std::string reference;  ///< the precision whose run is compared with, "quad", "50", ...
    std::string witness;    ///< the one that confirms it; empty if there is none
    /// True if the witness agrees with the reference on every event on which the run does.
    bool conclusive = false;
    /// Index of the first event that is not confirmed.
    std::optional<std::uint64_t> first_uncertain;
    /// Index of the first event that is another one in the reference's order of time: the first
    /// uncertain one, or earlier, one of two events so close that only their order is uncertain,
    /// which no ball feels.
    std::optional<std::uint64_t> first_out_of_order;
    std::vector<EventDigits> events;  ///< in the run's order
    std::vector<BallDigits> balls;    ///< in the scene's order

    /// Every event and every ball is confirmed.
    [[nodiscard]] bool certain() const;
    friend bool operator==(const Certificate&, const Certificate&) = default;
};

}  // namespace osculo

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "osculo/outcome.hpp"

namespace osculo::facade {

/// When pairs of things last met. No allocation once it has seen as many pairs.
class ContactTimes {
public:
    void clear();

    /// Notes a contact at that time; true if it is not the same contact as the last one of the
    /// pair, kSameContact or less before.
    [[nodiscard]] bool begins(std::uint64_t pair, double time);

private:
    // Open addressing; what is not of the present generation is empty.
    struct Slot {
        std::uint64_t pair = 0;
        double time = 0;
        std::uint64_t generation = 0;
    };
    [[nodiscard]] Slot& find(std::uint64_t pair);
    void grow();

    std::vector<Slot> slots_ = std::vector<Slot>(64);  ///< a power of two
    std::size_t used_ = 0;
    std::uint64_t generation_ = 1;
};

/// Counts the events of one shot after another.
class OutcomeCounter {
public:
    void begin(std::optional<std::uint32_t> cue_ball, std::size_t balls);

    /// The next event of the shot, by the indices in the scene.
    void add(EventKind kind, std::uint32_t ball, std::uint32_t other, double time);

    /// What came of it so far; rest_time and the positions are left to the caller.
    [[nodiscard]] Outcome& outcome() { return outcome_; }

private:
    void add_balls(std::uint32_t ball, std::uint32_t other, double time);
    void add_cushion(std::uint32_t ball);

    Outcome outcome_;
    std::vector<std::uint8_t> is_hit_;
    ContactTimes contacts_;
};

/// The ball that the scene's cue strikes, or else the only one that moves.
[[nodiscard]] std::optional<std::uint32_t> cue_ball_of(const Scene& scene);

}  // namespace osculo::facade

#pragma once

#include <cstdint>
#include <memory>

#include "osculo/run.hpp"

namespace osculo::facade {

class StateArchive;

/// A run of some engine that is played in parts.
class StoppableRun {
public:
    virtual ~StoppableRun() = default;

    [[nodiscard]] virtual std::unique_ptr<StoppableRun> clone() const = 0;
    virtual Status play(const Limits& limits) = 0;
    /// Takes its state down, or puts in that of a run of the same scene with the same engine.
    virtual void archive(StateArchive& archive) = 0;
    [[nodiscard]] virtual double time() const = 0;
    [[nodiscard]] virtual std::uint64_t event_count() const = 0;
    /// The run if it ended with that status at those limits. With `audit`, requires an engine that
    /// records pieces. This one cannot be played on afterwards.
    [[nodiscard]] virtual Run finish(Status status, const Limits& limits, bool audit) = 0;

protected:
    StoppableRun() = default;
    StoppableRun(const StoppableRun&) = default;
    StoppableRun& operator=(const StoppableRun&) = default;
};

}  // namespace osculo::facade

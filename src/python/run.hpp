#pragma once

#include <cstdint>
#include <vector>

#include "osculo/run.hpp"

namespace osculo::python {

/// A run with its pieces by ball, so that a state at any time is found at once.
class RecordedRun {
public:
    explicit RecordedRun(Run run);

    [[nodiscard]] const Run& run() const { return run_; }

    /// As Run::at, in O(log pieces); a state of NaN where there is none.
    [[nodiscard]] BallState at(std::uint32_t ball, double time) const;

private:
    Run run_;
    std::vector<std::vector<std::uint32_t>> pieces_of_;  // of each ball, in order of time
};

}  // namespace osculo::python

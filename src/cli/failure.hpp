#pragma once

#include <stdexcept>
#include <string>

namespace osculo::cli {

enum ExitCode {
    kFinished = 0,
    kEndedEarly = 1,  // by the event limit, accumulating impacts, or the range of numbers
    kUsage = 2,
    kInvalidScene = 3,
    kInputOutput = 4,
    kUncertain = 5,  // --certify: not every event is certain
    kInterrupted = 130,
};

/// Ends the program with that code and one line on stderr.
class Failure : public std::runtime_error {
public:
    Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    ExitCode code_;
};

}  // namespace osculo::cli

#pragma once

namespace osculo::cli {

/// While it exists, the first Ctrl-C (or SIGTERM) is only noted; a second one ends the program.
class InterruptNote {
public:
    InterruptNote();
    InterruptNote(const InterruptNote&) = delete;
    InterruptNote& operator=(const InterruptNote&) = delete;
    ~InterruptNote();

    [[nodiscard]] bool is_interrupted() const;
};

}  // namespace osculo::cli

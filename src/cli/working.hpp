#pragma once

#include <thread>

namespace osculo::cli {

/// While it exists, says on stderr that and how long the program works, if that takes more than a
/// second and stderr is a terminal.
class Working {
public:
    explicit Working(bool quiet);

private:
    std::jthread thread_;
};

}  // namespace osculo::cli

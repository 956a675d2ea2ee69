#pragma once

#include <cstdint>

namespace osculo::support {

/// Number of allocations of the program so far; links the operators new that count them.
[[nodiscard]] std::uint64_t allocations();

}  // namespace osculo::support

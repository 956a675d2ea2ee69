#pragma once

#include <string_view>

namespace osculo {

/// How a run ended. Running never throws: everything computed up to the end is in the run.
enum class Status {
    at_rest,      ///< every ball is at rest or captured, and nothing further can happen
    time_limit,   ///< the limit on simulated time was reached
    event_limit,  ///< the limit on the number of events was reached
    zeno,         ///< impacts accumulate: too many without time advancing
    numeric,      ///< a quantity left the range or resolution of the scalar type
};

/// The status as it is written in files: "at_rest", "time_limit", ...
[[nodiscard]] constexpr std::string_view to_string(Status status) {
    switch (status) {
        case Status::at_rest: return "at_rest";
        case Status::time_limit: return "time_limit";
        case Status::event_limit: return "event_limit";
        case Status::zeno: return "zeno";
        case Status::numeric: return "numeric";
    }
    return "numeric";
}

}  // namespace osculo

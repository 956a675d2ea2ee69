#pragma once

#include <string>
#include <string_view>

#include "case.hpp"

/// Plays cases of the catalogue and judges what comes out.
namespace osculo::bench::stability {

inline constexpr Precision kPrecisions[] = {Precision::double_precision, Precision::extended,
                                            Precision::quad, Precision::digits50,
                                            Precision::digits100};

enum class Verdict {
    right,        ///< as many digits as the problem leaves of the precision's
    status_only,  ///< an admissible status, within the bound on events, audit clean: no more to ask
    wrong,
    too_long,  ///< not run: beyond the time for one row
};

[[nodiscard]] constexpr std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::right: return "right";
        case Verdict::status_only: return "status";
        case Verdict::wrong: return "WRONG";
        case Verdict::too_long: return "not run";
    }
    return "";
}

/// What is expected of a case under one law.
struct Target {
    bool known = false;         ///< false: the reference would take too long
    bool is_reference = false;  ///< it is itself a run in 100 digits
    Values values;
    double may_lose = 0;  ///< decimal digits that the problem takes
};

/// One case under one law in one precision.
struct Row {
    Values got;
    double digits = 0;  ///< decimal, at most kMostDigits: results are rounded to double
    double needed = 0;
    std::uint64_t events = 0;
    Status status{};
    std::string audit = "-";
    double seconds = 0;
    Verdict verdict = Verdict::too_long;
    std::string why;  ///< what is wrong

    static constexpr double kMostDigits = 16;
};

/// Seconds that one row may take, by an estimate.
[[nodiscard]] Target target(const Case& c, std::size_t law, double budget);
[[nodiscard]] Row play(const Case& c, std::size_t law, Precision precision, const Target& target,
                       double budget);

}  // namespace osculo::bench::stability

#pragma once

#include <vector>

#include "contender.hpp"

/// How a trace compares with the reference.
namespace osculo::bench {

struct Difference {
    double rms = 0;     ///< of the positions of all balls, in radii of the first
    double worst = 0;   ///< of any ball
    double energy = 0;  ///< relative to that at the start
};

[[nodiscard]] Difference compare(const Snapshot& is, const Snapshot& should, double radius,
                                 const Exact& start_energy);

/// Whether, up to `time`, every ball met the same partners in the same order as in the reference.
/// Contacts may be dated two steps late or early, but not more than a tenth of the time; cushions
/// that a ball meets within less than that count once (engines cut corners and jaws into pieces
/// differently).
[[nodiscard]] bool same_contacts(const std::vector<Contact>& is, const std::vector<Contact>& should,
                                 std::size_t balls, double time, double step);

}  // namespace osculo::bench

#pragma once

#include <cstdint>
#include <limits>

#include "osculo/engine/event.hpp"

namespace osculo::engine {

/// A ball (kind = kBallBall) or an obstacle of a kind.
struct Thing {
    Kind kind = kNothing;
    std::uint32_t index = 0;
    friend bool operator==(const Thing&, const Thing&) = default;
};

/// What the audit of a run found.
struct RunAudit {
    double energy_initial = 0;  ///< [J]
    double energy_final = 0;    ///< [J], captured balls with their energy at capture
    /// Largest gain of energy at one impact, that of spin included, over the energy of its balls
    /// before (negative: every impact lost some), less what impact/pressing.hpp may add; 0 without
    /// impacts.
    double largest_energy_gain = 0;
    /// Largest change of momentum at one event of two balls, over the sum of |m v| before (where
    /// things can be pressed together: before or after, if that is more).
    double largest_momentum_error = 0;
    /// Smallest distance between the boundaries of two things, over the smaller radius, when it
    /// was reached [s] and by what. Infinite, and nothing named, if no two things can touch.
    double worst_gap = std::numeric_limits<double>::infinity();
    double worst_gap_time = 0;
    Thing worst_first, worst_second;
    /// Largest distance between the boundaries at an event, over the smaller radius: a contact of
    /// things that do not touch. Overlaps are worst_gap's.
    double largest_contact_error = 0;
    /// Largest distance between where a piece ends and the next state of its ball, over the radius.
    double largest_jump = 0;
    /// Faults of the record: changes of velocity or spin without an impact, events without pieces
    /// around them, pieces without events around them, stretches of time with no piece or with two,
    /// events out of order or of captured balls, contacts that were not closing or still are, final
    /// states that are not the last ones, and pieces that move or spin otherwise, or in one phase
    /// for longer, than their motion law says.
    std::uint64_t unexplained = 0;
    /// No fault, and every figure within what rounding explains (math/error_bounds.hpp).
    bool clean = true;

    /// Takes a figure of which the largest counts. NaN counts as the largest.
    void note(double& figure, double value, bool explained) {
        const bool is_number = figure == figure;
        if (is_number && !(value <= figure)) figure = value;
        clean = clean && explained;
    }
};

}  // namespace osculo::engine

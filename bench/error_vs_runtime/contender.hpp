#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "osculo/scene.hpp"

/// What everything that can play a scene here has in common. One contender, one small file.
namespace osculo::bench {

/// Wide enough to hold what any contender says without rounding it.
using Exact = boost::multiprecision::cpp_bin_float_50;

struct ExactPoint {
    Exact x = 0;
    Exact y = 0;
};

/// All balls at one of the instants that were asked for.
struct Snapshot {
    double cpu_seconds = 0;             ///< processor time from the start until here
    std::vector<ExactPoint> positions;  ///< of a captured ball: where it was captured
    Exact energy = 0;                   ///< of what is still on the table [J]
};

inline constexpr int kCushion = -1;  ///< any of them: engines cut tables into pieces differently
inline constexpr int kRim = -2;

/// A ball met something. Balls that meet are two of these.
struct Contact {
    double time;
    int ball;
    int other;  ///< a ball, kCushion or kRim
};

struct Trace {
    std::vector<Snapshot> snapshots;  ///< fewer than asked for: it took too long
    std::vector<Contact> contacts;    ///< in the order in which they were dealt with
    bool gave_up = false;             ///< the engine says itself that it cannot go on
};

/// What a contender is asked to do.
struct Task {
    const Scene& scene;
    std::span<const double> times;  ///< ascending
    double step = 0;                ///< longest time step [s], 0 for those that have none
    double record_until = 0;        ///< contacts are wanted up to here, at least
    double patience = 1e9;          ///< processor time after which to stop [s]
};

struct Contender {
    std::string name;
    bool stepped = true;
    bool cloth = false;  ///< knows sliding, rolling and spinning balls
    std::function<Trace(const Task&)> play;
};

[[nodiscard]] Contender ours_float();
[[nodiscard]] Contender ours_double();
[[nodiscard]] Contender ours_long_double();
[[nodiscard]] Contender ours_quad();
[[nodiscard]] Contender ours_50_digits();
[[nodiscard]] Contender ours_100_digits();
[[nodiscard]] Contender paper(bool repaired);
[[nodiscard]] Contender swept_steps();
[[nodiscard]] Contender box2d(bool tuned);
[[nodiscard]] Contender chipmunk(bool tuned);

}  // namespace osculo::bench

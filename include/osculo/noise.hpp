#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "osculo/batch.hpp"

/// What comes of a strike that nobody executes exactly.
namespace osculo {

/// Standard deviations of what is executed from what is intended: independent, normal, mean 0.
struct CueNoise {
    double side = 0;       ///< of the tip's offset to the left [m]
    double height = 0;     ///< of the tip's offset upwards [m]
    double speed = 0;      ///< [m/s]
    double azimuth = 0;    ///< [rad]
    double elevation = 0;  ///< [rad]
};

/// The noise of the computational pool tournaments: 0.5 mm, 0.5 mm, 0.075 m/s, 0.125 degrees and
/// 0.1 degrees, times the magnitude (their simulator FastFiz, Noise.h: a, b, v, phi, theta).
[[nodiscard]] CueNoise computational_pool_noise(double magnitude = 1);

/// Which random numbers: there is one set for each.
struct Draw {
    std::uint64_t seed = 0;
    std::uint64_t shot = 0;
    std::uint64_t number = 0;
};

/// Five independent standard normal numbers, a function of the draw alone: Philox4x64-10 (Salmon,
/// Moraes, Dror & Shaw 2011) of the counter (number, shot, block, 0) and the key (seed, 0), 53 bits
/// of each word through the quantile of the normal distribution. The same bits everywhere.
[[nodiscard]] std::array<double, 5> standard_normals(const Draw& draw);

/// The strike as it is executed on a ball of that radius [m]. The normals are, in their order, for
/// side, height, speed, azimuth and elevation. A cue is never lower than level, and what is
/// kLeastElevation remains it; nothing else keeps the strike possible.
[[nodiscard]] Strike perturbed(const Strike& strike, const CueNoise& noise, double radius,
                               const Draw& draw);

/// What a shot is meant to do, by indices into the scene's balls and rims.
struct Goal {
    struct Pot {
        std::uint32_t ball = 0;
        std::optional<std::uint32_t> rim{};  ///< any, if it is left out
    };
    std::vector<Pot> pots{};                   ///< all of which have to fall
    std::optional<std::uint32_t> first_hit{};  ///< the ball that the cue ball has to hit first
    bool no_scratch = true;                    ///< the cue ball must not fall

    [[nodiscard]] bool operator()(const BatchResult& result, std::size_t shot) const;
};

/// Whether a shot of a batch, which came to rest, is a success; a Goal is one.
using Predicate = std::function<bool(const BatchResult& result, std::size_t shot)>;

struct SuccessOptions {
    CueNoise noise = computational_pool_noise();
    std::uint64_t seed = 0;
    std::uint64_t shot = 0;       ///< number of the strike: others have independent draws
    std::uint64_t draws = 10000;  ///< at most
    double width = 0;             ///< stop when the interval is not wider than this; 0: never
    double confidence = 0.95;     ///< of the interval, above 0 and below 1
};

/// How often a strike succeeds.
struct Success {
    std::uint64_t draws = 0;
    std::uint64_t successes = 0;
    std::uint64_t impossible = 0;  ///< draws that are no strikes: a miscue, a speed of 0
    std::uint64_t unfinished = 0;  ///< draws that ended otherwise than at rest
    double probability = 0;        ///< successes / draws: all others are failures
    /// The score interval of Wilson (1927). It is meant for a number of draws that is not chosen by
    /// looking at it: stopping early, it holds the truth a little less often than it says.
    double low = 0;
    double high = 1;
};

/// Plays the strike with the noise of draws 0, 1, ... An intended kLeastElevation is the number
/// that it stands for; a stick that would be too low for what is in its way lies on that. Whether
/// to stop is looked at after numbers of draws that depend on nothing else. So the result is the
/// same for any number of threads. A batch that is stopped by [control] has the draws until then.
/// Throws as batch.run() does, and std::invalid_argument for options out of range.
[[nodiscard]] Success success_probability(Batch& batch, const Strike& strike,
                                          const Predicate& succeeds,
                                          const SuccessOptions& options = {},
                                          const BatchControl& control = {});

}  // namespace osculo

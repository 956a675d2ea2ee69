#include <numbers>

#include "presets/parameters.hpp"
#include "presets/scenes.hpp"

namespace osculo::presets {
namespace {

constexpr double kUpTheTable = std::numbers::pi / 2;

// Shaken within its gap: no real rack is perfect, and a perfect one struck straight on would have
// no unique answer, for its contacts come in simultaneous pairs.
RackOptions rack_of(const Parameters& parameters, std::uint64_t seed) {
    RackOptions options;
    options.gap = parameters.gap.value_or(options.gap);
    options.seed = parameters.seed.value_or(seed);
    return options;
}

Cue cue_of(const Parameters& parameters, double speed, double azimuth) {
    Cue cue;
    cue.speed = speed_of(parameters, speed);
    cue.azimuth = azimuth;
    return cue;
}

}  // namespace

// Straight at the first ball. The cue ball leaves a cue of 8 m/s at 12 m/s, as fast as in
// professional play.
Shot break_shot(const Parameters& parameters) {
    return {"pool-9ft", "eight-ball", rack_of(parameters, 31), cue_of(parameters, 8, kUpTheTable)};
}

Shot nine_ball_shot(const Parameters& parameters) {
    return {"pool-9ft", "nine-ball", rack_of(parameters, 10), cue_of(parameters, 8, kUpTheTable)};
}

// The usual safe break: thin on the last red to the right, with right-hand side, around the table
// and back to baulk.
Shot snooker_break_shot(const Parameters& parameters) {
    Shot shot{"snooker-12ft", "snooker", rack_of(parameters, 1), cue_of(parameters, 3, 1.576)};
    shot.cue.offset = {-0.3, 0};
    return shot;
}

// Red first, as the rules ask for, then three cushions and yellow: a point.
Shot three_cushion_shot(const Parameters& parameters) {
    Shot shot{"carom-10ft", "three-cushion", {}, cue_of(parameters, 3.5, 1.704)};
    shot.cue.offset = {-0.3, 0};
    return shot;
}

}  // namespace osculo::presets

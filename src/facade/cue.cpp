#include "cue.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compile_cue.hpp"
#include "stick.hpp"
#include "text.hpp"

namespace osculo::facade {
namespace {

constexpr double kFastestCue = 1e150;

/// Throws if the stick would have to pass through something.
void validate_stick(const Scene& scene) {
    const Cue& cue = *scene.cue;
    if (cue.allow_obstructed) return;
    const auto obstruction = find_obstruction(scene, cue.elevation);
    if (!obstruction) return;
    const auto least = least_elevation(scene);
    if (!least) {
        throw SceneError("cue.azimuth",
                         concatenated("must leave room for the stick, which meets ", *obstruction,
                                      " whatever its elevation (or set allow_obstructed)"),
                         number_text(cue.azimuth));
    }
    const double degrees = std::ceil(*least * (1800 / std::numbers::pi)) / 10;
    throw SceneError("cue.elevation",
                     concatenated("must be at least ", number_text(*least), " (",
                                  number_text(degrees), " degrees) for the stick to pass over ",
                                  *obstruction, " (or set allow_obstructed)"),
                     number_text(cue.elevation));
}

}  // namespace

void validate_cue(const Scene& scene) {
    if (!scene.cue) return;
    const Cue& cue = *scene.cue;
    const auto ball = std::find_if(scene.balls.begin(), scene.balls.end(),
                                   [&](const Ball& b) { return b.id == cue.ball; });
    if (ball == scene.balls.end()) {
        throw SceneError("cue.ball", "must be the id of a ball",
                         concatenated("\"", cue.ball, "\""));
    }
    if (ball->velocity != Point{} || ball->spin != Spin{}) {
        throw SceneError("cue.ball", "must be a ball at rest",
                         concatenated("\"", cue.ball, "\", which moves or spins"));
    }
    const auto require = [](bool holds, const char* path, const char* rule, double value) {
        if (!holds) throw SceneError(path, rule, number_text(value));
    };
    require(std::abs(cue.azimuth) <= kLargestAzimuth, "cue.azimuth",
            "must be from -1e12 to 1e12 rad", cue.azimuth);
    require(cue.speed <= kFastestCue, "cue.speed", "must be at most 1e150", cue.speed);
    require(cue.mass > 0 && cue.mass <= 1e100, "cue.mass", "must be > 0 and finite", cue.mass);
    require(cue.end_mass >= 0 && cue.end_mass <= 1e100, "cue.end_mass", "must be >= 0 and finite",
            cue.end_mass);
    require(cue.restitution >= 0 && cue.restitution <= 1, "cue.restitution", "must be from 0 to 1",
            cue.restitution);
    require(cue.miscue_limit > 0 && cue.miscue_limit <= 1, "cue.miscue_limit",
            "must be above 0 and at most 1", cue.miscue_limit);
    const double offset = std::hypot(cue.offset[0], cue.offset[1]);
    switch (compile_cue<double>(cue).fault()) {
        case impact::StrikeFault::none: break;
        case impact::StrikeFault::speed:
            require(false, "cue.speed", "must be > 0", cue.speed);
            break;
        case impact::StrikeFault::elevation:
            require(false, "cue.elevation", "must be from 0 to below pi/2", cue.elevation);
            break;
        case impact::StrikeFault::outside:
            require(false, "cue.offset", "must be inside the ball, below 1 radius", offset);
            break;
        case impact::StrikeFault::miscue:
            require(false, "cue.offset", "must be within miscue_limit, or the tip slips off",
                    offset);
            break;
    }
    validate_stick(scene);
}

bool is_possible_but_for_stick(const Scene& scene) {
    const Cue& cue = *scene.cue;
    return compile_cue<double>(cue).fault() == impact::StrikeFault::none &&
           cue.speed <= kFastestCue && std::abs(cue.azimuth) <= kLargestAzimuth;
}

bool is_possible_strike(const Scene& scene) {
    const Cue& cue = *scene.cue;
    return is_possible_but_for_stick(scene) &&
           (cue.allow_obstructed || !is_obstructed(scene, cue.elevation));
}

}  // namespace osculo::facade

#include "cue.hpp"

#include <algorithm>
#include <cmath>

#include "compile_cue.hpp"
#include "text.hpp"

namespace osculo::facade {

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
    require(std::isfinite(cue.azimuth), "cue.azimuth", "must be finite", cue.azimuth);
    require(cue.speed <= 1e150, "cue.speed", "must be at most 1e150", cue.speed);
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
}

}  // namespace osculo::facade

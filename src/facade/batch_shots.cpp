#include "batch_shots.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cue.hpp"
#include "start.hpp"

namespace osculo {
namespace facade {
namespace {

/// Gives the scene's cue the strike.
void set_strike(Scene& scene, const Strike& strike) {
    Cue& cue = *scene.cue;
    cue.speed = strike.speed;
    cue.azimuth = strike.azimuth;
    cue.offset = {strike.side, strike.height};
    cue.elevation = 0;
    if (!std::isnan(strike.elevation)) {
        cue.elevation = strike.elevation;
    } else if (!cue.allow_obstructed && is_possible_but_for_stick(scene)) {
        cue.elevation = least_elevation(scene).value_or(0);
    }
}

void set_state(Ball& ball, const BallState& state) {
    ball.position = state.position;
    ball.velocity = state.velocity;
    ball.spin = state.spin;
}

}  // namespace

Scene batch_base(const Scene& scene, const std::optional<Limits>& limits) {
    Scene base = scene;
    base.cue.reset();
    if (limits) base.limits = *limits;
    validate(base);
    if (scene.cue) validate_cue_of(base, *scene.cue);
    return base;
}

void validate_cue_of(const Scene& base, const Cue& cue) {
    Scene scene = base;
    scene.cue = cue;
    set_strike(scene, {.elevation = 0});
    scene.cue->allow_obstructed = true;
    validate(scene);
}

std::size_t count_shots(const Scene& scene, const Starts& starts) {
    const std::size_t balls = scene.balls.size();
    if (balls == 0 || starts.states.size() % balls != 0) {
        throw std::invalid_argument(
            "starts.states: must have a row of states of all balls per shot");
    }
    if (!starts.present.empty() && starts.present.size() != starts.states.size()) {
        throw std::invalid_argument("starts.present: must be as many as the states, or empty");
    }
    return starts.states.size() / balls;
}

bool ShotTable::set_up(const Cue& cue, const Strike& strike) {
    if (is_moved_) scene_.balls = base_.balls;
    is_moved_ = false;
    present_ = {};
    if (!scene_.cue) scene_.cue = cue;
    set_strike(scene_, strike);
    return is_possible_strike(scene_);
}

bool ShotTable::set_up(const Starts& starts, std::size_t shot) {
    const std::size_t balls = scene_.balls.size();
    is_moved_ = true;
    scene_.cue.reset();
    present_ =
        starts.present.empty() ? starts.present : starts.present.subspan(shot * balls, balls);
    for (std::size_t i = 0; i < balls; ++i) {
        // One that is not there stands somewhere, so that it counts for nothing.
        const bool is_there = present_.empty() || present_[i] != 0;
        set_state(scene_.balls[i], is_there ? starts.states[shot * balls + i]
                                            : BallState{base_.balls[i].position, {}, {}});
    }
    return is_valid_start(scene_, present_) && is_closed();
}

bool ShotTable::is_closed() {
    if (!scene_.closed) return true;
    const auto is_there = [&](std::size_t i) { return present_.empty() || present_[i] != 0; };
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
        if (is_there(i)) smallest = std::min(smallest, scene_.balls[i].radius);
    }
    if (std::isinf(smallest)) return true;
    auto outline = std::find_if(outlines_.begin(), outlines_.end(),
                                [&](const auto& known) { return known.first == smallest; });
    if (outline == outlines_.end()) {
        outline = outlines_.insert(outline, {smallest, Outline(scene_, smallest)});
    }
    for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
        if (is_there(i) && !outline->second.encloses(scene_.balls[i].position)) return false;
    }
    return true;
}

}  // namespace facade

Scene scene_of(const Scene& scene, const Strike& strike) {
    Scene result = scene;
    if (!result.cue) result.cue = Cue{};
    facade::set_strike(result, strike);
    return result;
}

Scene scene_of(const Scene& scene, const Starts& starts, std::size_t shot) {
    const std::size_t balls = scene.balls.size();
    if (shot >= facade::count_shots(scene, starts)) {
        throw std::invalid_argument("shot: must be below the number of shots");
    }
    Scene result = scene;
    result.cue.reset();
    result.balls.clear();
    for (std::size_t i = 0; i < balls; ++i) {
        const std::size_t place = shot * balls + i;
        if (!starts.present.empty() && starts.present[place] == 0) continue;
        result.balls.push_back(scene.balls[i]);
        facade::set_state(result.balls.back(), starts.states[place]);
    }
    return result;
}

}  // namespace osculo

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "batch_shots.hpp"
#include "normal_quantile.hpp"
#include "osculo/noise.hpp"
#include "stick.hpp"

namespace osculo {
namespace {

/// Draws between two looks at whether to stop: few at first, then as many as there are already, up
/// to what keeps all threads busy.
std::uint64_t next_round(std::uint64_t draws, std::uint64_t most) {
    return std::min(std::clamp<std::uint64_t>(draws, 64, 4096), most - draws);
}

void set_interval(Success& success, double confidence) {
    const auto n = static_cast<double>(success.draws);
    const double p = static_cast<double>(success.successes) / n;
    const double z = facade::normal_quantile(confidence / 2);
    const double square = z * z / n;
    const double middle = (p + square / 2) / (1 + square);
    const double half = z / (1 + square) * std::sqrt(p * (1 - p) / n + square / (4 * n));
    success.probability = p;
    // The ends that are known are said exactly.
    success.low = success.successes == 0 ? 0 : std::max(0.0, middle - half);
    success.high = success.successes == success.draws ? 1 : std::min(1.0, middle + half);
}

void check(const SuccessOptions& options) {
    if (options.draws == 0) throw std::invalid_argument("draws: must be > 0");
    if (!(options.width >= 0)) throw std::invalid_argument("width: must be >= 0");
    if (!(options.confidence > 0 && options.confidence <= 1 - 0x1p-50)) {
        throw std::invalid_argument("confidence: must be above 0 and below 1");
    }
}

/// Draws strikes for one intended strike on the table of one scene.
class Execution {
public:
    Execution(const Scene& scene, const Strike& strike, const SuccessOptions& options)
        : scene_(scene_of(scene, strike)), intended_(strike), options_(options) {
        intended_.elevation = scene_.cue->elevation;
        for (const Ball& ball : scene_.balls) {
            if (ball.id == scene_.cue->ball) radius_ = ball.radius;
        }
    }

    [[nodiscard]] Strike draw(std::uint64_t number) {
        Strike strike =
            perturbed(intended_, options_.noise, radius_, {options_.seed, options_.shot, number});
        Cue& cue = *scene_.cue;
        if (cue.allow_obstructed) return strike;
        cue.speed = strike.speed;
        cue.azimuth = strike.azimuth;
        cue.elevation = strike.elevation;
        cue.offset = {strike.side, strike.height};
        if (facade::is_obstructed(scene_, strike.elevation)) strike.elevation = kLeastElevation;
        return strike;
    }

private:
    Scene scene_;
    Strike intended_;
    const SuccessOptions& options_;
    double radius_ = 1;
};

}  // namespace

bool Goal::operator()(const BatchResult& result, std::size_t shot) const {
    const std::size_t row = shot * result.balls;
    for (const Pot& pot : pots) {
        const std::int32_t rim = result.rim[row + pot.ball];
        if (rim < 0 || (pot.rim && static_cast<std::int32_t>(*pot.rim) != rim)) return false;
    }
    if (first_hit && result.first_hit[shot] != static_cast<std::int32_t>(*first_hit)) return false;
    const std::int32_t cue_ball = result.cue_ball[shot];
    return !no_scratch || cue_ball < 0 || result.rim[row + static_cast<std::size_t>(cue_ball)] < 0;
}

Success success_probability(Batch& batch, const Strike& strike, const Predicate& succeeds,
                            const SuccessOptions& options, const BatchControl& control) {
    check(options);
    Execution execution(batch.scene(), strike, options);
    Success success;
    std::vector<Strike> strikes;
    BatchResult result;
    while (success.draws < options.draws && !control.stop.stop_requested()) {
        strikes.resize(next_round(success.draws, options.draws));
        for (std::size_t i = 0; i < strikes.size(); ++i) {
            strikes[i] = execution.draw(success.draws + i);
        }
        batch.run(strikes, result, {.stop = control.stop});
        for (std::size_t i = 0; i < result.shots; ++i) {
            const ShotStatus status = result.status[i];
            if (status == ShotStatus::not_run) continue;
            ++success.draws;
            if (status == ShotStatus::invalid) {
                ++success.impossible;
            } else if (status != ShotStatus::at_rest) {
                ++success.unfinished;
            } else if (succeeds(result, i)) {
                ++success.successes;
            }
        }
        if (success.draws == 0) break;
        set_interval(success, options.confidence);
        if (control.progress) control.progress(success.draws, options.draws);
        if (success.high - success.low <= options.width) break;
    }
    return success;
}

}  // namespace osculo

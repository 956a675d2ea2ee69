#include "osculo/outcome.hpp"

#include <algorithm>
#include <unordered_map>

namespace osculo {
namespace {

bool is_contact(EventKind kind) {
    return kind != EventKind::capture && kind != EventKind::transition &&
           kind != EventKind::rim_entry && kind != EventKind::rim_exit;
}

/// Tells the first event of each contact from those that belong to the same.
class Contacts {
public:
    [[nodiscard]] bool begins_with(const Event& event) {
        const auto [last, is_new] = last_.try_emplace(key(event), event.time);
        const bool begins = is_new || event.time - last->second > Outcome::kSameContact;
        last->second = event.time;
        return begins;
    }

private:
    // The two things in one number: three bits of kind, thirty of each index.
    static std::uint64_t key(const Event& event) {
        std::uint64_t one = event.ball;
        std::uint64_t other = event.other;
        if (event.kind == EventKind::ball_ball && other < one) std::swap(one, other);
        return static_cast<std::uint64_t>(event.kind) << 60U | one << 30U | other;
    }

    std::unordered_map<std::uint64_t, double> last_;
};

std::optional<std::uint32_t> cue_ball_of(const Scene& scene) {
    const auto index = [&](auto ball) {
        return static_cast<std::uint32_t>(ball - scene.balls.begin());
    };
    if (scene.cue) {
        return index(std::ranges::find(scene.balls, scene.cue->ball, &Ball::id));
    }
    const auto moves = [](const Ball& ball) { return ball.velocity != Point{}; };
    const auto first = std::ranges::find_if(scene.balls, moves);
    if (std::count_if(first, scene.balls.end(), moves) != 1) return std::nullopt;
    return index(first);
}

void count_balls(Outcome& outcome, const Event& event, std::vector<bool>& is_hit) {
    ++outcome.balls[event.ball].balls;
    ++outcome.balls[event.other].balls;
    const bool of_cue = outcome.cue_ball == event.ball || outcome.cue_ball == event.other;
    const std::uint32_t target = outcome.cue_ball == event.ball ? event.other : event.ball;
    if (!of_cue || is_hit[target]) {
        ++outcome.kisses;
        return;
    }
    is_hit[target] = true;
    outcome.hits.push_back(
        {target, event.time, outcome.cushions_before_hit + outcome.cushions_after_hit});
}

void count_cushion(Outcome& outcome, const Event& event) {
    Outcome::Tally& tally = outcome.balls[event.ball];
    ++tally.cushions;
    if (outcome.cue_ball == event.ball) {
        ++(outcome.hits.empty() ? outcome.cushions_before_hit : outcome.cushions_after_hit);
    } else if (tally.cushions == 1) {
        ++outcome.driven_to_cushion;
    }
}

}  // namespace

std::optional<Outcome> outcome_of(const Run& run) {
    if (run.events.empty() && run.event_count > 0) return std::nullopt;
    Outcome outcome;
    outcome.cue_ball = cue_ball_of(run.scene);
    outcome.balls.resize(run.balls.size());
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        outcome.balls[i].position = run.balls[i].state.position;
    }
    if (run.status == Status::at_rest) outcome.rest_time = run.time;

    Contacts contacts;
    std::vector<bool> is_hit(run.balls.size());
    for (const Event& event : run.events) {
        if (event.kind == EventKind::capture) {
            outcome.falls.push_back({event.ball, event.other, event.time});
        }
        if (!is_contact(event.kind) || !contacts.begins_with(event)) continue;
        if (event.kind == EventKind::ball_ball) {
            count_balls(outcome, event, is_hit);
        } else {
            count_cushion(outcome, event);
        }
    }
    return outcome;
}

}  // namespace osculo

#include "outcome_counter.hpp"

#include <algorithm>
#include <utility>

namespace osculo::facade {
namespace {

bool is_contact(EventKind kind) {
    return kind != EventKind::capture && kind != EventKind::transition &&
           kind != EventKind::rim_entry && kind != EventKind::rim_exit;
}

// The two things in one number: three bits of kind, thirty of each index.
std::uint64_t pair_of(EventKind kind, std::uint64_t one, std::uint64_t other) {
    if (kind == EventKind::ball_ball && other < one) std::swap(one, other);
    return static_cast<std::uint64_t>(kind) << 60U | one << 30U | other;
}

}  // namespace

void ContactTimes::clear() {
    ++generation_;
    used_ = 0;
}

bool ContactTimes::begins(std::uint64_t pair, double time) {
    if (2 * used_ >= slots_.size()) grow();
    Slot& slot = find(pair);
    const bool is_new = slot.generation != generation_;
    const bool begins = is_new || time - slot.time > Outcome::kSameContact;
    used_ += is_new;
    slot = {pair, time, generation_};
    return begins;
}

/// The pair's slot, or the empty one where it belongs.
ContactTimes::Slot& ContactTimes::find(std::uint64_t pair) {
    // Fibonacci hashing: the high bits of the product are mixed well.
    const std::uint64_t mixed = pair * 0x9e3779b97f4a7c15U;
    std::size_t place = static_cast<std::size_t>(mixed >> 32U) & (slots_.size() - 1);
    while (slots_[place].generation == generation_ && slots_[place].pair != pair) {
        place = (place + 1) & (slots_.size() - 1);
    }
    return slots_[place];
}

void ContactTimes::grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
        if (slot.generation == generation_) find(slot.pair) = slot;
    }
}

void OutcomeCounter::begin(std::optional<std::uint32_t> cue_ball, std::size_t balls) {
    outcome_.cue_ball = cue_ball;
    outcome_.hits.clear();
    outcome_.hits.reserve(balls);
    outcome_.falls.clear();
    outcome_.falls.reserve(balls);
    outcome_.cushions_before_hit = outcome_.cushions_after_hit = 0;
    outcome_.kisses = outcome_.driven_to_cushion = 0;
    outcome_.rest_time.reset();
    outcome_.balls.assign(balls, {});
    is_hit_.assign(balls, 0);
    contacts_.clear();
}

void OutcomeCounter::add(EventKind kind, std::uint32_t ball, std::uint32_t other, double time) {
    if (kind == EventKind::capture) outcome_.falls.push_back({ball, other, time});
    if (!is_contact(kind) || !contacts_.begins(pair_of(kind, ball, other), time)) return;
    if (kind == EventKind::ball_ball) {
        add_balls(ball, other, time);
    } else {
        add_cushion(ball);
    }
}

void OutcomeCounter::add_balls(std::uint32_t ball, std::uint32_t other, double time) {
    ++outcome_.balls[ball].balls;
    ++outcome_.balls[other].balls;
    const bool of_cue = outcome_.cue_ball == ball || outcome_.cue_ball == other;
    const std::uint32_t target = outcome_.cue_ball == ball ? other : ball;
    if (!of_cue || is_hit_[target] != 0) {
        ++outcome_.kisses;
        return;
    }
    is_hit_[target] = 1;
    outcome_.hits.push_back(
        {target, time, outcome_.cushions_before_hit + outcome_.cushions_after_hit});
}

void OutcomeCounter::add_cushion(std::uint32_t ball) {
    Outcome::Tally& tally = outcome_.balls[ball];
    ++tally.cushions;
    if (outcome_.cue_ball == ball) {
        ++(outcome_.hits.empty() ? outcome_.cushions_before_hit : outcome_.cushions_after_hit);
    } else if (tally.cushions == 1) {
        ++outcome_.driven_to_cushion;
    }
}

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

}  // namespace osculo::facade

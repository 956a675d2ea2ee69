#include "batch_columns.hpp"

#include <limits>
#include <numeric>

namespace osculo::facade {
namespace {

std::uint32_t small(std::uint64_t count) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(count, std::numeric_limits<std::uint32_t>::max()));
}

template <class Record>
void join(std::vector<std::vector<Record>>& chunks, std::vector<std::uint64_t>& offsets,
          std::vector<Record>& all) {
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    all.reserve(offsets.back());
    for (std::vector<Record>& chunk : chunks) {
        all.insert(all.end(), chunk.begin(), chunk.end());
        chunk = {};
    }
}

}  // namespace

BatchColumns::BatchColumns(BatchResult& result, std::size_t shots, std::size_t balls,
                           std::size_t chunks, const BatchOptions& options)
    : result_(result) {
    result.shots = shots;
    result.balls = balls;
    result.status.assign(shots, ShotStatus::not_run);
    result.time.assign(shots, 0.0);
    result.event_count.assign(shots, 0);
    result.cue_ball.assign(shots, -1);
    result.first_hit.assign(shots, -1);
    result.cushions_before_hit.assign(shots, 0);
    result.cushions_after_hit.assign(shots, 0);
    result.driven_to_cushion.assign(shots, 0);
    result.kisses.assign(shots, 0);
    result.settled_count.assign(shots, 0);
    const std::size_t places = shots * balls;
    result.fate.assign(places, ShotFate::absent);
    result.position.assign(places, Point{});
    result.rim.assign(places, -1);
    result.capture_time.assign(places, std::numeric_limits<double>::quiet_NaN());
    result.ball_contacts.assign(places, 0);
    result.cushion_contacts.assign(places, 0);
    result.state.assign(options.states ? places : 0, BallState{});
    const bool events = options.record != Record::none;
    const bool pieces = options.record == Record::pieces;
    result.event_offsets.assign(events ? shots + 1 : 0, 0);
    result.piece_offsets.assign(pieces ? shots + 1 : 0, 0);
    result.events.clear();
    result.pieces.clear();
    events_.resize(events ? chunks : 0);
    pieces_.resize(pieces ? chunks : 0);
}

void BatchColumns::set(std::size_t shot, PlayedShot& played,
                       std::span<const std::uint8_t> present) {
    const Outcome& outcome = played.counter.outcome();
    result_.status[shot] = static_cast<ShotStatus>(played.status);
    result_.time[shot] = played.time;
    result_.event_count[shot] = played.event_count;
    if (outcome.cue_ball) {
        result_.cue_ball[shot] = static_cast<std::int32_t>(*outcome.cue_ball);
    }
    if (!outcome.hits.empty()) {
        result_.first_hit[shot] = static_cast<std::int32_t>(outcome.hits.front().ball);
    }
    result_.cushions_before_hit[shot] = small(outcome.cushions_before_hit);
    result_.cushions_after_hit[shot] = small(outcome.cushions_after_hit);
    result_.driven_to_cushion[shot] = small(outcome.driven_to_cushion);
    result_.kisses[shot] = small(outcome.kisses);
    result_.settled_count[shot] = played.settled_count;
    const std::size_t row = shot * result_.balls;
    for (std::size_t i = 0; i < result_.balls; ++i) {
        if (present.empty() || present[i] != 0) {
            set_ball(row + i, played.balls[i], outcome.balls[i]);
        }
    }
    for (const Outcome::Fall& fall : outcome.falls) {
        result_.capture_time[row + fall.ball] = fall.time;
    }
}

void BatchColumns::set_ball(std::size_t place, const FinalBall& ball, const Outcome::Tally& tally) {
    result_.fate[place] = static_cast<ShotFate>(ball.fate);
    result_.position[place] = ball.state.position;
    if (ball.rim) result_.rim[place] = static_cast<std::int32_t>(*ball.rim);
    result_.ball_contacts[place] = small(tally.balls);
    result_.cushion_contacts[place] = small(tally.cushions);
    if (!result_.state.empty()) result_.state[place] = ball.state;
}

void BatchColumns::set_records(std::size_t shot, std::size_t events, std::size_t pieces) {
    if (!result_.event_offsets.empty()) result_.event_offsets[shot + 1] = events;
    if (!result_.piece_offsets.empty()) result_.piece_offsets[shot + 1] = pieces;
}

void BatchColumns::keep_records(std::size_t chunk, PlayedShot& played) {
    if (!events_.empty()) events_[chunk].assign(played.events.begin(), played.events.end());
    if (!pieces_.empty()) pieces_[chunk].assign(played.pieces.begin(), played.pieces.end());
    played.events.clear();
    played.pieces.clear();
}

void BatchColumns::join_records() {
    if (!result_.event_offsets.empty()) join(events_, result_.event_offsets, result_.events);
    if (!result_.piece_offsets.empty()) join(pieces_, result_.piece_offsets, result_.pieces);
}

}  // namespace osculo::facade

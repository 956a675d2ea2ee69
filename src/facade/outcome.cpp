#include "osculo/outcome.hpp"

#include "outcome_counter.hpp"

namespace osculo {

std::optional<Outcome> outcome_of(const Run& run) {
    if (run.events.empty() && run.event_count > 0) return std::nullopt;
    facade::OutcomeCounter counter;
    counter.begin(facade::cue_ball_of(run.scene), run.balls.size());
    for (const Event& event : run.events) {
        counter.add(event.kind, event.ball, event.other, event.time);
    }
    Outcome& outcome = counter.outcome();
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        outcome.balls[i].position = run.balls[i].state.position;
    }
    if (run.status == Status::at_rest) outcome.rest_time = run.time;
    return std::move(outcome);
}

}  // namespace osculo

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "osculo/motion/cloth.hpp"
#include "support/pool_shots.hpp"

// Every recorded stretch between two events of a ball, followed with our law of the cloth.
namespace osculo {
namespace {

using motion::Cloth;
using State = Cloth::State<double>;
namespace pool_shots = support::pool_shots;

State start(const Cloth::Parameters<double>& law, const pool_shots::Balls& balls,
            const pool_shots::State& recorded) {
    State state;
    state.position =
        math::WidePoint<double>(math::Vec<double>(recorded.position[0], recorded.position[1]));
    state.velocity = {recorded.velocity[0], recorded.velocity[1]};
    state.spin = {recorded.spin[0], recorded.spin[1], recorded.spin[2]};
    state.radius = balls.radius;
    if (recorded.phase == pool_shots::Phase::rolling) {
        // Exactly so: the recorded spin is rounded.
        state.spin.x() = -state.velocity.y() / state.radius;
        state.spin.y() = state.velocity.x() / state.radius;
    }
    Cloth::begin(law, state);
    return state;
}

struct Since {
    double time = 0;
    pool_shots::State state;
};

struct Errors {
    long stretches = 0;
    long transitions = 0;
    double position = 0, velocity = 0, spin = 0, time = 0;
};

void follow(const pool_shots::Shot& shot, const pool_shots::Balls& balls, Errors& errors) {
    const Cloth::Parameters<double> law{balls.sliding * balls.gravity,
                                        balls.rolling * balls.gravity,
                                        balls.spinning * balls.gravity};
    std::map<std::string, Since> last;
    for (const auto& state : shot.initial) last[state.ball] = {0, state};
    for (const auto& event : shot.events) {
        for (std::size_t k = 0; k < event.before.size(); ++k) {
            const pool_shots::State& expected = event.before[k];
            const auto since = last.find(expected.ball);
            if (since != last.end()) {
                State state = start(law, balls, since->second.state);
                const double wait = event.time - since->second.time;
                const bool transition = event.ids.size() == 1;
                if (transition) {
                    ++errors.transitions;
                    errors.time = std::max(errors.time, std::abs(state.remaining - wait));
                }
                // Recorded times are rounded sums: do not run past the end of the phase.
                Cloth::advance(state, std::min(wait, state.remaining));
                const auto p = state.position.rounded();
                errors.position = std::max({errors.position, std::abs(p.x() - expected.position[0]),
                                            std::abs(p.y() - expected.position[1])});
                errors.velocity =
                    std::max({errors.velocity, std::abs(state.velocity.x() - expected.velocity[0]),
                              std::abs(state.velocity.y() - expected.velocity[1])});
                for (int c = 0; c < 3; ++c) {
                    errors.spin = std::max(
                        errors.spin,
                        std::abs(state.spin(c) - expected.spin[static_cast<std::size_t>(c)]));
                }
                ++errors.stretches;
            }
            last[expected.ball] = {event.time, event.after[k]};
        }
    }
}

TEST(ClothReplay, FollowsEveryRecordedStretch) {
    const pool_shots::Record record = pool_shots::read(OSCULO_POOL_SHOTS);
    Errors errors;
    for (const auto& shot : record.shots) follow(shot, record.balls.at(shot.balls), errors);
    RecordProperty("stretches", std::to_string(errors.stretches));
    std::printf(
        "%ld stretches, %ld of them to a transition; largest error of position %.2g m, "
        "velocity %.2g m/s, spin %.2g rad/s, transition time %.2g s\n",
        errors.stretches, errors.transitions, errors.position, errors.velocity, errors.spin,
        errors.time);
    EXPECT_GT(errors.stretches, 6'000);
    EXPECT_GT(errors.transitions, 2'700);
    EXPECT_LT(errors.position, 1e-11);
    EXPECT_LT(errors.velocity, 1e-11);
    EXPECT_LT(errors.spin, 1e-11);
    EXPECT_LT(errors.time, 1e-11);
}

}  // namespace
}  // namespace osculo

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/cloth_scenes.hpp"
#include "support/random.hpp"

// Random shots on every table: whatever the layout and the strike, the balls stay on the table or
// fall into a pocket, nothing overlaps, energy falls, all ends at rest, and the order of the file
// does not matter. OSCULO_SHOTS sets how many shots per table (default 200).
namespace osculo::support {
namespace {

struct Bed {
    const char* table;
    double width, length;
    double mass, radius;
};

constexpr Bed kBeds[] = {
    {"pool-7ft", 0.9906, 1.9812, 0.170097, 0.028575},
    {"pool-8ft", 1.1684, 2.3368, 0.170097, 0.028575},
    {"pool-9ft", 1.27, 2.54, 0.170097, 0.028575},
    {"snooker-12ft", 1.778, 3.569, 0.14, 0.02619375},
    {"carom-10ft", 1.42, 2.84, 0.21, 0.03075},
};

int shots() {
    const char* text = std::getenv("OSCULO_SHOTS");
    return text != nullptr ? std::atoi(text) : 200;
}

Scene random_shot(const Bed& bed, Random& random) {
    Scene scene;
    presets::add_table(scene, bed.table);
    presets::set_table_laws(scene, bed.table);
    scene.limits.time = 600;
    const int balls = random.between(1, 16);
    for (int k = 0; k < balls;) {
        Ball ball = pool_ball(
            std::string("b").append(std::to_string(k)),
            {random.uniform<double>(1.001 * bed.radius, bed.width - 1.001 * bed.radius),
             random.uniform<double>(1.001 * bed.radius, bed.length - 1.001 * bed.radius)});
        ball.mass = bed.mass;
        ball.radius = bed.radius;
        // One in eight is frozen to another one.
        if (k > 0 && random.below(8) == 0) {
            const Point to = scene.balls[static_cast<std::size_t>(random.below(k))].position;
            const math::Vec<double> n = random.direction<double>();
            ball.position = {to.x + 2 * bed.radius * n.x(), to.y + 2 * bed.radius * n.y()};
        }
        const Point p = ball.position;
        const bool clear =
            p.x > bed.radius && p.x < bed.width - bed.radius && p.y > bed.radius &&
            p.y < bed.length - bed.radius &&
            std::none_of(scene.balls.begin(), scene.balls.end(), [&](const Ball& other) {
                return std::hypot(p.x - other.position.x, p.y - other.position.y) <
                       2 * bed.radius * (1 - 1e-9);
            });
        // Away from the pockets' mouths, which reach a little into the bed.
        const bool in_mouth =
            std::any_of(scene.rims.begin(), scene.rims.end(), [&](const Rim& rim) {
                return std::hypot(p.x - rim.center.x, p.y - rim.center.y) < rim.radius + bed.radius;
            });
        if (!clear || in_mouth) continue;
        scene.balls.push_back(ball);
        ++k;
    }
    Cue cue;
    cue.ball = "b0";
    cue.speed = std::pow(10, random.uniform<double>(-1, 1.1));
    cue.azimuth = random.uniform<double>(-3.2, 3.2);
    cue.elevation = random.coin() ? 0 : random.uniform<double>(0, 1.2);
    const math::Vec<double> n = random.direction<double>();
    const double offset = random.coin() ? 0 : random.uniform<double>(0, 0.5);
    cue.offset = {offset * n.x(), offset * n.y()};
    cue.allow_obstructed = true;
    scene.cue = cue;
    return scene;
}

class Shots : public testing::TestWithParam<Bed> {};

TEST_P(Shots, AreSound) {
    const Bed& bed = GetParam();
    double worst_gap = 1;
    std::uint64_t most_events = 0;
    for (int shot = 0; shot < shots(); ++shot) {
        Random random(static_cast<std::uint64_t>(shot) + 1);
        const Scene scene = random_shot(bed, random);
        const auto run = settled(scene);
        SCOPED_TRACE(testing::Message() << bed.table << " seed " << shot + 1);
        OSCULO_EXPECT_SOUND(run);
        worst_gap = std::min(worst_gap, run.audit->worst_gap);
        most_events = std::max(most_events, run.event_count);
        for (const FinalBall& ball : run.balls) {
            if (ball.fate == BallFate::captured) continue;
            // On the bed, or stuck between the jaws of a pocket.
            const Point p = ball.state.position;
            const bool in_jaws =
                std::any_of(scene.rims.begin(), scene.rims.end(), [&p, &bed](const Rim& rim) {
                    return std::hypot(p.x - rim.center.x, p.y - rim.center.y) <
                           rim.radius + 2 * bed.radius;
                });
            EXPECT_TRUE(in_jaws || (p.x > 0 && p.x < bed.width && p.y > 0 && p.y < bed.length));
        }

        Scene reversed = scene;
        std::reverse(reversed.balls.begin(), reversed.balls.end());
        std::reverse(reversed.segments.begin(), reversed.segments.end());
        std::reverse(reversed.arcs.begin(), reversed.arcs.end());
        std::reverse(reversed.rims.begin(), reversed.rims.end());
        auto other = simulate(reversed, {.record = Record::none});
        std::reverse(other.balls.begin(), other.balls.end());
        EXPECT_EQ(other.event_count, run.event_count);
        for (std::size_t i = 0; i < run.balls.size(); ++i) {
            EXPECT_EQ(other.balls[i].state, run.balls[i].state);
        }
        if (HasFailure()) return;
    }
    RecordProperty("worst_gap", std::to_string(worst_gap));
    std::printf("%s: %d shots, worst gap %.3g radii, at most %llu events\n", bed.table, shots(),
                worst_gap, static_cast<unsigned long long>(most_events));
}

INSTANTIATE_TEST_SUITE_P(Tables, Shots, testing::ValuesIn(kBeds), [](const auto& bed) {
    std::string name = bed.param.table;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace osculo::support

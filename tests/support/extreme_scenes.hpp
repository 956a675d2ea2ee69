#pragma once

#include <string>
#include <utility>

#include "osculo/simulate.hpp"

/// Scenes of a few balls in every precision, through the public interface.
namespace osculo::support {

inline constexpr Precision kEveryPrecision[] = {Precision::double_precision, Precision::extended,
                                                Precision::quad, Precision::digits50,
                                                Precision::digits100};

[[nodiscard]] inline Ball disk(std::string id, Point position, Point velocity = {}, double mass = 1,
                               double radius = 1) {
    Ball ball;
    ball.id = std::move(id);
    ball.mass = mass;
    ball.radius = radius;
    ball.position = position;
    ball.velocity = velocity;
    return ball;
}

/// A wall across the x axis.
[[nodiscard]] inline Segment wall_at(double x, std::string id = "wall") {
    return {std::move(id), {x, -9}, {x, 9}, Side::both};
}

/// Audited; contacts at one instant one after the other.
[[nodiscard]] inline Run played(Scene scene, Precision precision = Precision::double_precision) {
    scene.impacts.simultaneous = Simultaneous::sequential;
    return simulate(scene, {.precision = precision, .audit = true});
}

}  // namespace osculo::support

/// In that status, with a clean audit. [run]: from played().
#define OSCULO_EXPECT_ENDED(run, expected)                   \
    do {                                                     \
        EXPECT_EQ((run).status, ::osculo::Status::expected); \
        EXPECT_TRUE((run).audit->clean);                     \
    } while (false)

#pragma once

#include <string>
#include <utility>
#include <vector>

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

/// For contacts at one instant.
inline constexpr Simultaneous kEveryLaw[] = {Simultaneous::sequential, Simultaneous::symmetric};

[[nodiscard]] inline std::string name_of(Simultaneous law) {
    return law == Simultaneous::sequential ? "sequential" : "symmetric";
}

/// A precision, and a law for contacts at one instant.
struct Way {
    Precision precision = Precision::double_precision;
    Simultaneous law = Simultaneous::sequential;
};

[[nodiscard]] inline std::vector<Way> every_way() {
    std::vector<Way> ways;
    for (const Precision precision : kEveryPrecision) {
        for (const Simultaneous law : kEveryLaw) ways.push_back({precision, law});
    }
    return ways;
}

[[nodiscard]] inline std::string to_string(const Way& way) {
    return std::string(osculo::to_string(way.precision)) + ", " + name_of(way.law);
}

/// Audited.
[[nodiscard]] inline Run played(Scene scene, const Way& way) {
    scene.impacts.simultaneous = way.law;
    return simulate(scene, {.precision = way.precision, .audit = true});
}
/// Contacts at one instant one after the other.
[[nodiscard]] inline Run played(Scene scene, Precision precision = Precision::double_precision) {
    return played(std::move(scene), Way{precision});
}

}  // namespace osculo::support

/// In that status, with a clean audit. [run]: from played().
#define OSCULO_EXPECT_ENDED(run, expected)                   \
    do {                                                     \
        EXPECT_EQ((run).status, ::osculo::Status::expected); \
        EXPECT_TRUE((run).audit->clean);                     \
    } while (false)

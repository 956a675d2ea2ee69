#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace osculo {

/// A point or a vector in the plane [m] or [m/s].
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// Angular velocity [rad/s]; z points up, out of the plane.
using Spin = std::array<double, 3>;

/// A circular body.
struct Ball {
    std::string id;
    double mass = 1;    ///< [kg], > 0
    double radius = 1;  ///< [m], > 0
    Point position;     ///< of the centre [m]
    Point velocity;     ///< [m/s]
    Spin spin{};        ///< [rad/s]; carried along unchanged by laws that do not use it
    friend bool operator==(const Ball&, const Ball&) = default;
};

/// Which faces of a segment stop a ball: the one to the left of from -> to, or both.
enum class Side { left, both };

/// A straight cushion. Its end points stop balls from every direction.
struct Segment {
    std::string id;
    Point from;
    Point to;
    Side side = Side::both;
    friend bool operator==(const Segment&, const Segment&) = default;
};

/// A circular cushion, counter-clockwise from from_angle to to_angle [rad]; it stops balls inside
/// and outside of its circle, and so do its end points. to_angle - from_angle in (0, 2 pi], where
/// a difference within 4 ulp of 2 pi is the full circle, without end points.
struct Arc {
    std::string id;
    Point center;
    double radius = 1;  ///< [m], > 0
    double from_angle = 0;
    double to_angle = 6.283185307179586;
    friend bool operator==(const Arc&, const Arc&) = default;
};

/// What happens to a ball whose centre crosses a rim.
enum class RimLaw {
    capture,  ///< it is gone
};

/// The edge of a hole.
struct Rim {
    std::string id;
    Point center;
    double radius = 1;  ///< [m], > 0
    RimLaw law = RimLaw::capture;
    friend bool operator==(const Rim&, const Rim&) = default;
};

/// Free flight: x + v t.
struct UniformMotion {
    friend bool operator==(const UniformMotion&, const UniformMotion&) = default;
};

/// How balls move while nothing touches them.
using MotionLaw = std::variant<UniformMotion>;

/// Frictionless impact: the normal relative velocity is reversed and multiplied by restitution.
struct Restitution {
    double restitution = 1;  ///< in [0, 1]
    friend bool operator==(const Restitution&, const Restitution&) = default;
};

/// How contacts at one instant that share a ball are resolved.
enum class Simultaneous {
    sequential,  ///< pair by pair, in the total order of events, until no touching pair approaches
};

struct Impacts {
    Restitution ball_ball;
    Restitution ball_cushion;
    Simultaneous simultaneous = Simultaneous::sequential;
    friend bool operator==(const Impacts&, const Impacts&) = default;
};

/// What ends a run at the latest.
struct Limits {
    double time = 60;                  ///< simulated time [s], > 0 and finite
    std::uint64_t events = 1'000'000;  ///< number of events, > 0
    friend bool operator==(const Limits&, const Limits&) = default;
};

/// Everything that exists. SI units, radians.
struct Scene {
    MotionLaw motion;
    double gravity = 9.81;  ///< [m/s^2]; used by no law of free flight
    std::vector<Ball> balls;
    std::vector<Segment> segments;
    std::vector<Arc> arcs;
    std::vector<Rim> rims;
    Impacts impacts;
    /// True: every ball must start enclosed by segments, arcs and rims with no gap it fits through.
    bool closed = false;
    Limits limits;
    friend bool operator==(const Scene&, const Scene&) = default;
};

/// A scene that breaks a rule. what() is one line: "path: rule, but it is value".
class SceneError : public std::invalid_argument {
public:
    SceneError(std::string path, std::string rule, std::string value);

    [[nodiscard]] const std::string& path() const noexcept {
        return path_;
    }  ///< e.g. balls[3].mass
    [[nodiscard]] const std::string& rule() const noexcept { return rule_; }  ///< e.g. must be > 0
    [[nodiscard]] const std::string& value() const noexcept { return value_; }  ///< e.g. -1

private:
    std::string path_;
    std::string rule_;
    std::string value_;
};

/// Checks every rule of the scene; throws SceneError for the first one broken. O(n log n) in balls.
void validate(const Scene& scene);

}  // namespace osculo

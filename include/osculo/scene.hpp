#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
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
    double mass = 1;       ///< [kg], > 0
    double radius = 1;     ///< [m], > 0
    Point position;        ///< of the centre [m]
    Point velocity;        ///< [m/s]
    Spin spin{};           ///< [rad/s]; carried along unchanged by laws that do not use it
    double inertia = 0.4;  ///< k = I / (m r^2), in [1e-12, 1]: 2/5 for a sphere; with friction
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
    paper,    ///< it is pulled towards the centre, and falls or leaves; not on a cloth
    tipping,  ///< a rigid ball tips over the edge, flies, hits the edge, falls or crosses: likewise
};

/// The law as it is written in files: "capture", "paper", "tipping".
[[nodiscard]] constexpr std::string_view to_string(RimLaw law) {
    switch (law) {
        case RimLaw::capture: return "capture";
        case RimLaw::paper: return "paper";
        case RimLaw::tipping: return "tipping";
    }
    return "capture";
}

/// The edge of a hole.
struct Rim {
    std::string id;
    Point center;
    double radius = 1;             ///< [m], > 0
    RimLaw law = RimLaw::capture;  ///< rims with other laws do not overlap, and have all the same
    /// Of the edge, in [0, 1]; with the law tipping. Left out: that of cushions.
    std::optional<double> restitution{};
    friend bool operator==(const Rim&, const Rim&) = default;
};

/// Free flight: x + v t.
struct UniformMotion {
    friend bool operator==(const UniformMotion&, const UniformMotion&) = default;
};

/// Rolling to rest: constant deceleration friction * gravity along the path, without regard to
/// spin.
struct RollingMotion {
    double friction = 0.01;  ///< >= 0
    friend bool operator==(const RollingMotion&, const RollingMotion&) = default;
};

/// What balls move through: it slows each of them by its own mass and radius.
struct Medium {
    double density = 0;           ///< [kg/m^3], >= 0; air: 1.2
    double viscosity = 0;         ///< [Pa s], >= 0; air: 1.8e-5
    double drag_coefficient = 0;  ///< >= 0; a sphere in the turbulent range: 0.47
    /// Balls roll: what slows them has to slow their rotation too, so that of the force 1 / (1 + k)
    /// is left, 5/7 for a solid sphere.
    bool rolling = false;
    friend bool operator==(const Medium&, const Medium&) = default;
};

/// Slowing down along a straight line at constant + linear v + quadratic v^2, each >= 0, without
/// regard to spin. A medium adds to linear 6 pi viscosity radius / mass (Stokes) and to quadratic
/// density drag_coefficient pi radius^2 / (2 mass).
struct ResistedMotion {
    double constant = 0;   ///< [m/s^2]
    double linear = 0;     ///< [1/s]
    double quadratic = 0;  ///< [1/m]
    std::optional<Medium> medium;
    friend bool operator==(const ResistedMotion&, const ResistedMotion&) = default;
};

/// A ball on a cloth: sliding, rolling, spinning, rest. Frictions >= 0, each may be 0.
struct ClothMotion {
    double sliding_friction = 0.2;
    double rolling_friction = 0.01;
    double spinning_friction = 0.0127;  ///< spin about the vertical decays at this * g / (k r)
    friend bool operator==(const ClothMotion&, const ClothMotion&) = default;
};

/// How balls move while nothing touches them.
using MotionLaw = std::variant<UniformMotion, RollingMotion, ClothMotion, ResistedMotion>;

enum class BallBallLaw {
    restitution,  ///< frictionless: the normal relative velocity is reversed, times restitution
    /// The same with Coulomb friction between the balls: in space on cloth; without, of discs, for
    /// which only spins about the vertical count.
    frictional,
};

/// What happens when two balls meet.
struct BallBallImpact {
    BallBallLaw law = BallBallLaw::restitution;
    double restitution = 1;  ///< in [0, 1]
    /// mu(u) = f0 + f1 exp(-f2 u) at the slip speed u [m/s]; each >= 0.
    std::array<double, 3> friction{};
    friend bool operator==(const BallBallImpact&, const BallBallImpact&) = default;
};

enum class CushionLaw {
    restitution,    ///< frictionless
    frictional,     ///< restitution and friction on an upright face, of discs; not with cloth
    han_2005,       ///< restitution and friction at a nose above the ball's middle; needs cloth
    mathavan_2010,  ///< a nose that presses the ball into the cloth, which rubs too; needs cloth
    stronge,        ///< compliant along the cushion, so that spin can be reversed; needs cloth
};

/// The law as it is written in files: "restitution", "han_2005", ...
[[nodiscard]] constexpr std::string_view to_string(CushionLaw law) {
    switch (law) {
        case CushionLaw::restitution: return "restitution";
        case CushionLaw::frictional: return "frictional";
        case CushionLaw::han_2005: return "han_2005";
        case CushionLaw::mathavan_2010: return "mathavan_2010";
        case CushionLaw::stronge: return "stronge";
    }
    return "restitution";
}

/// What happens when a ball meets a cushion.
struct CushionImpact {
    CushionLaw law = CushionLaw::restitution;
    double restitution = 1;  ///< in [0, 1]
    double friction = 0;     ///< >= 0; not for `restitution`
    double height = 0;       ///< of the nose above the table [m], > 0; for the laws that need cloth
    /// Of ball and cloth during the impact, >= 0; for `mathavan_2010`. Left out: the cloth's own
    /// sliding friction.
    std::optional<double> cloth_friction{};
    /// Of the tangential to the normal oscillation, above 1 and below 2; for `stronge`.
    double frequency_ratio = 1.8;
    friend bool operator==(const CushionImpact&, const CushionImpact&) = default;
};

/// How contacts at one instant that share a ball are resolved.
enum class Simultaneous {
    symmetric,   ///< all at once, whatever their order (osculo/impact/symmetric.hpp)
    sequential,  ///< pair by pair, in the total order of events, until no touching pair approaches
};

struct Impacts {
    BallBallImpact ball_ball;
    CushionImpact ball_cushion;
    /// Two things that are pressed together meet at most once in this time [s], >= 0, those in a
    /// row a few times; not for uniform motion (osculo/impact/pressing.hpp says why).
    double contact_time = 1e-4;
    Simultaneous simultaneous = Simultaneous::symmetric;
    /// Contacts that close more slowly than this do not bounce unless they are elastic [m/s], >= 0;
    /// under the symmetric law only. If left out, kRestShare of the fastest ball's speed at the
    /// start, after the strike.
    std::optional<double> rest_speed;
    static constexpr double kRestShare = 1e-6;
    friend bool operator==(const Impacts&, const Impacts&) = default;
};

/// What ends a run at the latest.
struct Limits {
    double time = 60;                  ///< simulated time [s], > 0 and finite
    std::uint64_t events = 1'000'000;  ///< number of events, > 0
    friend bool operator==(const Limits&, const Limits&) = default;
};

/// A cue strikes a ball at rest before the run begins; needs cloth.
struct Cue {
    std::string ball = "cue";        ///< id of the ball
    double speed = 1;                ///< of the cue [m/s], > 0
    double azimuth = 0;              ///< direction of the shot, from x towards y [rad]
    double elevation = 0;            ///< of the butt [rad], in [0, pi/2); see least_elevation()
    std::array<double, 2> offset{};  ///< of the tip: to the left and up [ball radii]
    double mass = 0.54;              ///< of the cue [kg], > 0
    double end_mass = 0.006;         ///< of the part of the cue that is pushed aside [kg], >= 0
    double restitution = 1;          ///< of the tip, in [0, 1]
    double miscue_limit = 0.55;      ///< largest offset [ball radii], in (0, 1]
    bool allow_obstructed = false;   ///< the stick may pass through balls and cushions
    friend bool operator==(const Cue&, const Cue&) = default;
};

/// Everything that exists. SI units, radians.
struct Scene {
    MotionLaw motion;
    double gravity = 9.81;  ///< [m/s^2], >= 0; for friction and rims
    std::vector<Ball> balls;
    std::vector<Segment> segments;
    std::vector<Arc> arcs;
    std::vector<Rim> rims;
    Impacts impacts;
    std::optional<Cue> cue;
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

/// The least elevation of the scene's cue [rad], in whole milliradians, at which its stick passes
/// over every other ball and every cushion that is in its way (README.md: The stick); 0 if nothing
/// is. Nothing if there is no such elevation.
[[nodiscard]] std::optional<double> least_elevation(const Scene& scene);

}  // namespace osculo

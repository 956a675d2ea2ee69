#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "osculo/certificate.hpp"
#include "osculo/scene.hpp"
#include "osculo/status.hpp"

namespace osculo {

/// What an event is.
enum class EventKind {
    capture,       ///< a ball falls into a rim: it is gone
    ball_ball,     ///< two balls
    ball_segment,  ///< a ball and the straight part of a segment
    ball_arc,      ///< a ball and the circular part of an arc
    ball_point,    ///< a ball and an end point of a segment or arc
    transition,    ///< a ball's motion enters its next phase
    rim_entry,     ///< a ball's centre comes into a rim that pulls it,
    rim_exit,      ///< or leaves it
};

/// The kind as it is written in files: "capture", "ball_ball", ...
[[nodiscard]] constexpr std::string_view to_string(EventKind kind) {
    switch (kind) {
        case EventKind::capture: return "capture";
        case EventKind::ball_ball: return "ball_ball";
        case EventKind::ball_segment: return "ball_segment";
        case EventKind::ball_arc: return "ball_arc";
        case EventKind::ball_point: return "ball_point";
        case EventKind::transition: return "transition";
        case EventKind::rim_entry: return "rim_entry";
        case EventKind::rim_exit: return "rim_exit";
    }
    return "ball_ball";
}

/// What a ball does between its events.
enum class Phase {
    uniform,   ///< free flight
    rest,      ///< on cloth, and after rolling to rest
    spinning,  ///< on the spot, about the vertical
    rolling,
    sliding,
    resisted,  ///< slowing down by drag
    rim,       ///< pulled by a rim
    tipping,   ///< on the edge of a rim
    flying,    ///< off the edge of a rim; from there to itself or tipping, it has hit the edge
};

/// The phase as it is written in files: "uniform", "rest", ...
[[nodiscard]] constexpr std::string_view to_string(Phase phase) {
    switch (phase) {
        case Phase::uniform: return "uniform";
        case Phase::rest: return "rest";
        case Phase::spinning: return "spinning";
        case Phase::rolling: return "rolling";
        case Phase::sliding: return "sliding";
        case Phase::resisted: return "resisted";
        case Phase::rim: return "rim";
        case Phase::tipping: return "tipping";
        case Phase::flying: return "flying";
    }
    return "uniform";
}

/// A ball's place and motion at one instant.
struct BallState {
    Point position;
    Point velocity;
    Spin spin{};
    friend bool operator==(const BallState&, const BallState&) = default;
};

/// One event. Its instant is time + time_low, an unevaluated sum.
struct Event {
    double time = 0;      ///< [s]
    double time_low = 0;  ///< [s], what rounding to double took from the instant
    EventKind kind = EventKind::ball_ball;
    std::uint32_t ball = 0;  ///< index into scene.balls
    std::uint32_t other =
        0;         ///< index into scene.balls, .segments, .arcs, .rims or run.points, by kind
    Point point;   ///< where the boundaries touch (rims: the ball's centre) [m]
    Point normal;  ///< unit, from `ball` towards `other`
    std::array<BallState, 2> before;  ///< of `ball` and, for ball_ball, `other`
    std::array<BallState, 2> after;
    /// Contacts that were resolved together have the same number, from 1 on; 0: by itself. They
    /// follow each other, and only what all of them do together has a meaning.
    std::uint32_t cluster = 0;
    bool well_posed = true;  ///< of a cluster: false if another law or order has another outcome
    Phase from = Phase::uniform;  ///< of a transition
    Phase to = Phase::uniform;
    friend bool operator==(const Event&, const Event&) = default;
};

/// One analytic stretch of one ball's motion. With T = t - from, from <= t <= to:
///
///   centre    position + velocity T + acceleration T^2 / 2
///   velocity  velocity + acceleration T
///   spin x, y of a rolling ball (-vy, vx) / radius, else spin + spin_rate T
///   spin z    towards 0 by spin_rate[2] T, and 0 from there on
///
/// In the phase `resisted` the centre is at position + velocity sigma(T) and the velocity q(T)
/// times what it was, with q' = -(m + k q + c q^2), q(0) = 1, sigma the integral of q, and m, k, c
/// = resistance[0] / v, resistance[1], resistance[2] v for v = |velocity|; the acceleration is that
/// at `from`. In closed form, with l = sqrt(k^2 / 4 - m c) and A = e^(-k T / 2) sinh(l T) / l,
/// A' = e^(-k T / 2) (cosh(l T) - k / (2 l) sinh(l T)), B = (1 - k A - A') / (m c), g = A - m B:
/// sigma = log(1 + c g) / c, q = (A' - m A) / (1 + c g). motion/slowing.hpp has the forms in which
/// coefficients may be 0.
///
/// A position is the sum of its two parts, like an instant.
///
/// In a rim with the law paper, position and velocity at `from` are the start of a motion with the
/// energy and the angular momentum that it has there (osculo/motion/rim_paper.hpp); Run::along()
/// follows it. Its spin stays. In one with the law tipping, the ball moves in space: in the phase
/// flying as above, its centre at height + climb T - gravity T^2 / 2 over the table's plane; in the
/// phase tipping it stays on the edge, which is without friction but that what moves it has to turn
/// inertia m r^2 too (osculo/motion/rim_tipping_stay.hpp).
struct Piece {
    std::uint32_t ball = 0;  ///< index into scene.balls
    double from = 0;         ///< [s]
    double from_low = 0;
    double to = 0;  ///< [s]
    double to_low = 0;
    Point position;  ///< at `from` [m]
    Point position_low;
    Point velocity;      ///< at `from` [m/s]
    Point acceleration;  ///< [m/s^2]
    Spin spin{};         ///< at `from` [rad/s]
    Spin spin_rate{};    ///< [rad/s^2]; the third is >= 0
    /// constant [m/s^2], linear [1/s] and quadratic [1/m] deceleration, in the phase `resisted`
    std::array<double, 3> resistance{};
    Phase phase = Phase::uniform;
    std::uint32_t rim = 0;  ///< of the phases rim, tipping and flying: index into scene.rims
    double height = 0;      ///< of the phases tipping and flying: of the centre, at `from` [m],
    double climb = 0;       ///< and how fast that changes [m/s]
    double inertia = 0;     ///< of the phase tipping
    friend bool operator==(const Piece&, const Piece&) = default;
};

/// Where a ball of that radius [m] is in the piece, and how it moves, [wait] s after its beginning.
[[nodiscard]] BallState state_in(const Piece& piece, double radius, double wait);

enum class BallFate { rest, moving, captured };

[[nodiscard]] constexpr std::string_view to_string(BallFate fate) {
    switch (fate) {
        case BallFate::rest: return "rest";
        case BallFate::moving: return "moving";
        case BallFate::captured: return "captured";
    }
    return "moving";
}

/// A ball at the end of the run; a captured one as it was at its capture.
struct FinalBall {
    BallFate fate = BallFate::moving;
    BallState state;
    std::optional<std::uint32_t> rim;  ///< index into scene.rims, for a captured ball
    friend bool operator==(const FinalBall&, const FinalBall&) = default;
};

/// An independent check of a run, from its pieces alone. Relative figures unless a unit is given.
struct Audit {
    double energy_initial = 0;  ///< [J], in a rim that pulls with that of its field, 0 on the rim
    double energy_final = 0;    ///< [J], captured balls included with their energy at capture
    /// Largest gain of energy at one impact, that of spin included, over the energy of its balls
    /// before (<= 0: none gained), beyond what parting of balls pressed together may take.
    double largest_energy_gain = 0;
    /// Largest change of momentum at one ball_ball event, over the sum of its balls' |momentum|
    /// before.
    double largest_momentum_error = 0;
    /// Smallest distance between the boundaries of any two things at any time, over the smaller
    /// radius (ball-cushion: the ball's). Negative: they overlapped.
    double worst_gap = 0;
    double worst_gap_time = 0;               ///< [s]
    std::vector<std::string> worst_gap_ids;  ///< the two things, empty if no two can touch
    /// Largest distance between a piece's end and the next one's start, over the ball's radius.
    double largest_jump = 0;
    /// Changes of velocity or spin that no event explains, events that no pieces show, and pieces
    /// that the motion law does not explain.
    std::uint64_t unexplained = 0;
    /// Everything within the bounds that rounding explains (math/error_bounds.hpp).
    bool clean = false;
    friend bool operator==(const Audit&, const Audit&) = default;
};

/// Which ready-made engine ran the scene.
struct EngineInfo {
    std::string
        name;  ///< e.g.
               ///< "uniform/restitution/symmetric/rims+segments+arcs+points/double/pieces/all-pairs"
    std::vector<std::string>
        left_out;  ///< features of osculo that this engine does not contain, with why
    friend bool operator==(const EngineInfo&, const EngineInfo&) = default;
};

/// The result of simulating a scene.
struct Run {
    Scene scene;  ///< what was simulated
    Status status = Status::at_rest;
    double time = 0;                ///< simulated time at the end [s]
    std::uint64_t event_count = 0;  ///< events, whether recorded or not
    /// Impacts among them that did not bounce because they were slower than Impacts::rest_speed.
    std::uint64_t settled_count = 0;
    EngineInfo engine;
    std::vector<std::string> points;         ///< names of the end points, e.g. "rail-3.from"
    std::vector<Event> events;               ///< in order of time; empty unless recorded
    std::vector<Piece> pieces;               ///< in order of their end; empty unless recorded
    std::vector<FinalBall> balls;            ///< in the scene's order
    std::optional<Audit> audit;              ///< if asked for
    std::optional<Certificate> certificate;  ///< if asked for

    /// The ids of what takes part in the event: two of them.
    [[nodiscard]] std::array<std::string, 2> ids(const Event& event) const;

    /// The state of ball [index] at time t [s], from the pieces; nothing outside of what was
    /// recorded or after the ball's capture. Error of the position: a few ulp of its coordinates.
    [[nodiscard]] std::optional<BallState> at(std::uint32_t index, double t) const;

    /// The state on one of the run's pieces at time t [s], in it.
    [[nodiscard]] BallState at(const Piece& piece, double t) const;
    /// The states on one of the pieces at times since its beginning [s], within its duration.
    [[nodiscard]] std::vector<BallState> along(const Piece& piece,
                                               const std::vector<double>& times) const;
};

}  // namespace osculo

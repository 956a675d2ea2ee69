#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"
#include "osculo/simulate.hpp"

/// Many shots on one table, on all cores.
///
/// Every scene that simulate() takes can be played in batches, whatever its motion law and in every
/// precision. A shot is either a strike of the scene's cue (motion law cloth) or a state of every
/// ball to start from. The result of a shot is that of simulate(scene_of(scene, shot)) bit for bit,
/// and does not depend on the other shots, the number of threads or the size of chunks.
namespace osculo {

/// Says of a strike: the least elevation that passes over what is behind the ball, as a scene gets
/// it whose file gives none (see least_elevation()); 0 if the cue may be obstructed.
inline constexpr double kLeastElevation = std::numeric_limits<double>::quiet_NaN();

/// What a shot changes of the scene's cue; a row of five numbers.
struct Strike {
    double speed = 1;                    ///< of the cue [m/s], > 0
    double azimuth = 0;                  ///< direction of the shot, from x towards y [rad]
    double elevation = kLeastElevation;  ///< of the butt [rad], in [0, pi/2), or kLeastElevation
    double side = 0;                     ///< offset of the tip to the left [ball radii]
    double height = 0;                   ///< offset of the tip upwards [ball radii]
};

/// Starts without a cue, [shot][ball] with the balls in the scene's order.
struct Starts {
    std::span<const BallState> states;  ///< shots x balls of them; rows of seven numbers per ball
    /// Of the same size, 0 for balls that are not on the table; empty: all are there. The state of
    /// a ball that is not there is ignored.
    std::span<const std::uint8_t> present{};
};

/// How a shot of a batch ended: a Status, or why there is none.
enum class ShotStatus : std::uint8_t {
    at_rest,
    time_limit,
    event_limit,
    zeno,
    numeric,
    invalid,  ///< its scene breaks a rule: validate(scene_of(scene, shot)) says which
    not_run,  ///< the batch was stopped before
};

/// The status as it is written in files: "at_rest", ..., "invalid", "not_run".
[[nodiscard]] constexpr std::string_view to_string(ShotStatus status) {
    switch (status) {
        case ShotStatus::invalid: return "invalid";
        case ShotStatus::not_run: return "not_run";
        default: return to_string(static_cast<Status>(status));
    }
}

/// A ball at the end of a shot of a batch: a BallFate, or it was not there.
enum class ShotFate : std::uint8_t { rest, moving, captured, absent };

/// The fate as it is written in files: "rest", "moving", "captured", "absent".
[[nodiscard]] constexpr std::string_view to_string(ShotFate fate) {
    return fate == ShotFate::absent ? "absent" : to_string(static_cast<BallFate>(fate));
}

/// What came of the shots, in columns: one entry per shot, or [shot][ball] with the balls in the
/// scene's order. The words are those of Outcome. Shots that are invalid or not run have what is
/// given here as first values. A result that is used again keeps its memory.
struct BatchResult {
    std::size_t shots = 0;
    std::size_t balls = 0;

    // One entry per shot.
    std::vector<ShotStatus> status;
    std::vector<double> time;                        ///< simulated, until rest or a limit [s]; 0
    std::vector<std::uint64_t> event_count;          ///< transitions and captures included; 0
    std::vector<std::int32_t> cue_ball;              ///< index into scene.balls; -1: none
    std::vector<std::int32_t> first_hit;             ///< index into scene.balls; -1: none
    std::vector<std::uint32_t> cushions_before_hit;  ///< of the cue ball; 0
    std::vector<std::uint32_t> cushions_after_hit;   ///< of the cue ball; 0
    std::vector<std::uint32_t> driven_to_cushion;    ///< number of other balls; 0
    std::vector<std::uint32_t> kisses;               ///< contacts of balls other than hits; 0
    std::vector<std::uint64_t> settled_count;        ///< as in a Run; 0

    // [shot][ball]
    std::vector<ShotFate> fate;                   ///< absent
    std::vector<Point> position;                  ///< at the end or where it was captured [m]; 0
    std::vector<std::int32_t> rim;                ///< index into scene.rims; -1: not captured
    std::vector<double> capture_time;             ///< [s]; NaN: not captured
    std::vector<std::uint32_t> ball_contacts;     ///< 0
    std::vector<std::uint32_t> cushion_contacts;  ///< 0
    std::vector<BallState> state;  ///< at the end or the capture, if asked for; else empty

    // If asked for: those of shot i are [offsets[i], offsets[i + 1]).
    std::vector<std::uint64_t> event_offsets;
    std::vector<Event> events;
    std::vector<std::uint64_t> piece_offsets;
    std::vector<Piece> pieces;
    std::vector<std::string> points;  ///< names of the end points, as in a Run
};

struct BatchOptions {
    Precision precision = Precision::double_precision;
    Record record = Record::none;    ///< what is kept besides the outcomes
    bool states = false;             ///< keep the final states with velocity and spin
    std::optional<Limits> limits{};  ///< of each shot, if not those of the scene
    unsigned threads = 0;            ///< the calling one among them; 0: one per core
    std::size_t chunk = 0;           ///< shots that a thread takes at a time; 0: a good number
};

/// What happens while a batch runs.
struct BatchControl {
    /// Ends it: shots that have not begun are not_run.
    std::stop_token stop{};
    /// Called on the calling thread with the number of shots done and of all, some ten times per
    /// second, and at the end. What it throws stops the batch and leaves run().
    std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// A table made ready for batches: threads that wait, each with an engine of its own. A shot
/// allocates nothing (but a longer shot than any before may need more room for its contacts, a cell
/// grid is made anew for each, and events and pieces have to be kept somewhere).
class Batch {
public:
    /// Throws SceneError as simulate() does. The cue's speed, azimuth, elevation and offset do not
    /// matter.
    explicit Batch(const Scene& scene, const BatchOptions& options = {});
    ~Batch();
    Batch(Batch&&) noexcept;
    Batch& operator=(Batch&&) noexcept;

    /// Plays every strike of the scene's cue, or of a cue as it is by default if the scene has
    /// none. Throws SceneError if the scene has no cloth, or no ball for the cue; std::bad_alloc;
    /// what control.progress throws.
    void run(std::span<const Strike> strikes, BatchResult& result,
             const BatchControl& control = {});

    /// Plays from every start, without a cue. Throws std::invalid_argument if the sizes do not
    /// fit; std::bad_alloc; what control.progress throws.
    void run(const Starts& starts, BatchResult& result, const BatchControl& control = {});

    /// The scene that it was made for.
    [[nodiscard]] const Scene& scene() const;
    /// The engine that plays, as in EngineInfo::name.
    [[nodiscard]] std::string engine_name() const;
    [[nodiscard]] unsigned threads() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// One batch.
[[nodiscard]] BatchResult simulate_batch(const Scene& scene, std::span<const Strike> strikes,
                                         const BatchOptions& options = {},
                                         const BatchControl& control = {});
[[nodiscard]] BatchResult simulate_batch(const Scene& scene, const Starts& starts,
                                         const BatchOptions& options = {},
                                         const BatchControl& control = {});

/// The scene of a shot: with the strike's cue, or with only those balls that are there, in their
/// states, and without a cue. Limits are those of the scene.
[[nodiscard]] Scene scene_of(const Scene& scene, const Strike& strike);
[[nodiscard]] Scene scene_of(const Scene& scene, const Starts& starts, std::size_t shot);

}  // namespace osculo

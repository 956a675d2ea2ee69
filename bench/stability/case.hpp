#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "osculo/simulate.hpp"

/// The catalogue of stiff and extreme scenes: what each is, what must come out, and how to tell.
namespace osculo::bench::stability {

using Values = std::vector<double>;

/// The laws for simultaneous contacts that scenes are run with, in the order of Case::expected.
struct Law {
    const char* name;
    Simultaneous law;
};
inline constexpr Law kLaws[] = {
    {"sequential", Simultaneous::sequential},
    {"symmetric", Simultaneous::symmetric},
};

struct Case {
    std::string name;
    std::string family;
    std::string stiff;  ///< what is stiff or extreme about it
    Scene scene;

    /// What comes out, read off the run.
    std::function<Values(const Run&)> read;
    /// What should come out, by law (kLaws); a law without an entry shares the last one. Empty:
    /// what comes out in 100 digits (of `reference`, if there is one).
    std::vector<Values> expected;
    std::string source = "closed form";  ///< of what is expected
    std::optional<Scene> reference;

    double scale = 1;     ///< what errors are relative to; 0: every value to itself
    double may_lose = 1;  ///< decimal digits that the problem takes; with 100 digits it is measured
    double enough = 16;   ///< digits that are enough, where a law of impact is only a model
    std::vector<Status> statuses{Status::time_limit};  ///< how it may end
    bool status_only = false;                          ///< the status is all that can be expected
    std::uint64_t most_events = 0;  ///< what "bounded" means here; 0: the scene's own limit
    double about = 100;             ///< events, roughly: what it costs
    bool audited = true;            ///< the audit must be clean; not for very many events
    bool full_only = false;         ///< takes long
    /// The law that it is for, if not both. What is apart by some ulp is at one instant, or jammed,
    /// under the symmetric law, more or less of it by the precision: nothing to compare with.
    std::optional<Simultaneous> only;
};

[[nodiscard]] inline Ball ball(std::string id, double mass, double radius, Point position,
                               Point velocity = {}) {
    Ball b;
    b.id = std::move(id);
    b.mass = mass;
    b.radius = radius;
    b.position = position;
    b.velocity = velocity;
    return b;
}

/// Four walls, seen from inside.
inline void add_box(Scene& scene, double low_x, double low_y, double high_x, double high_y) {
    scene.segments.push_back({"bottom", {low_x, low_y}, {high_x, low_y}, Side::left});
    scene.segments.push_back({"right", {high_x, low_y}, {high_x, high_y}, Side::left});
    scene.segments.push_back({"top", {high_x, high_y}, {low_x, high_y}, Side::left});
    scene.segments.push_back({"left", {low_x, high_y}, {low_x, low_y}, Side::left});
}

[[nodiscard]] inline Values read_count(const Run& run) {
    return {static_cast<double>(run.event_count)};
}
/// vx of every ball.
[[nodiscard]] inline Values read_speeds(const Run& run) {
    Values all;
    for (const FinalBall& b : run.balls) all.push_back(b.state.velocity.x);
    return all;
}
[[nodiscard]] inline Values read_velocities(const Run& run) {
    Values all;
    for (const FinalBall& b : run.balls) {
        all.push_back(b.state.velocity.x);
        all.push_back(b.state.velocity.y);
    }
    return all;
}
[[nodiscard]] inline Values read_positions(const Run& run) {
    Values all;
    for (const FinalBall& b : run.balls) {
        all.push_back(b.state.position.x);
        all.push_back(b.state.position.y);
    }
    return all;
}

using Catalogue = std::vector<Case>;

// One file each.
void add_impacts(Catalogue& all);    ///< cradles, chains of masses, squeezes
void add_wedges(Catalogue& all);     ///< Galperin's billiard, wedges, corners
void add_instants(Catalogue& all);   ///< near-coincident and equal instants, ends of pieces
void add_scales(Catalogue& all);     ///< far, late, fast, slow, large, small
void add_curves(Catalogue& all);     ///< grazes, circles, corridors
void add_collapses(Catalogue& all);  ///< accumulating impacts
void add_resting(Catalogue& all);    ///< balls at rest or pressed, on cloth
void add_chaos(Catalogue& all);      ///< many balls
/// [count] cases at random, the same for the same seed everywhere.
void add_random(Catalogue& all, std::uint64_t seed, int count);

/// All but the random ones, each of a name of its own.
[[nodiscard]] Catalogue catalogue();

}  // namespace osculo::bench::stability

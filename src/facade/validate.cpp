#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>

#include "cue.hpp"
#include "forces.hpp"
#include "osculo/math/error_bounds.hpp"
#include "osculo/scene.hpp"
#include "outline.hpp"
#include "overlap.hpp"
#include "smallest_radius.hpp"
#include "start.hpp"
#include "text.hpp"

namespace osculo {
namespace {

using facade::concatenated;
using facade::number_text;
using facade::validate_cue;

/// Beyond these, squares and products of quantities of one scene leave the range of double.
constexpr double kLargest = 1e100;
constexpr double kFastest = 1e150;

std::string text(const Point& p) {
    return concatenated("[", number_text(p.x), ", ", number_text(p.y), "]");
}

std::string at(const char* list, std::size_t index, const char* field) {
    return concatenated(list, "[", std::to_string(index), "]", field);
}

void require(bool holds, const std::string& path, const char* rule, double value) {
    if (!holds) throw SceneError(path, rule, number_text(value));
}

void require_size(double value, const std::string& path) {
    require(value >= 1 / kLargest && value <= kLargest, path, "must be from 1e-100 to 1e100",
            value);
}

bool is_within(const Point& p, double largest) {
    return std::abs(p.x) <= largest && std::abs(p.y) <= largest;
}

void require_point(const Point& p, double largest, const std::string& path) {
    if (!is_within(p, largest)) {
        throw SceneError(
            path, concatenated("must have components of at most ", number_text(largest)), text(p));
    }
}

void validate_state(const Ball& ball, std::size_t i) {
    const auto slow = [](double w) { return std::abs(w) <= kFastest; };
    const bool holds = is_within(ball.position, kLargest) && is_within(ball.velocity, kFastest) &&
                       std::all_of(ball.spin.begin(), ball.spin.end(), slow);
    if (holds) return;  // before any text is made
    require_point(ball.position, kLargest, at("balls", i, ".position"));
    require_point(ball.velocity, kFastest, at("balls", i, ".velocity"));
    for (const double w : ball.spin) {
        require(slow(w), at("balls", i, ".spin"), "must be at most 1e150", w);
    }
}

/// Impacts of several balls add up energies, several times each.
void validate_energy(const Ball& ball, std::size_t i) {
    constexpr double kMost = 1e151;  // the root of it
    const double root = std::sqrt(ball.mass);
    const auto check = [&](double speed, const char* member) {
        require(root * speed <= kMost, at("balls", i, member),
                "must leave mass * speed^2, and the same of radius * spin, at most 1e302 J", speed);
    };
    check(std::hypot(ball.velocity.x, ball.velocity.y), ".velocity");
    for (const double w : ball.spin) check(ball.radius * std::abs(w), ".spin");
}

class Ids {
public:
    /// Throws if the id is empty or taken.
    void add(const std::string& id, const char* list, std::size_t index) {
        if (id.empty()) throw SceneError(at(list, index, ".id"), "must not be empty", "\"\"");
        const auto [it, fresh] = owners_.emplace(id, at(list, index, ""));
        if (!fresh) {
            throw SceneError(at(list, index, ".id"),
                             concatenated("must be unique, and ", it->second, " has it"),
                             concatenated("\"", id, "\""));
        }
    }

private:
    std::unordered_map<std::string, std::string> owners_;
};

void validate_balls(const Scene& scene, Ids& ids) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Ball& ball = scene.balls[i];
        ids.add(ball.id, "balls", i);
        require(ball.mass > 0, at("balls", i, ".mass"), "must be > 0", ball.mass);
        require_size(ball.mass, at("balls", i, ".mass"));
        require(ball.radius > 0, at("balls", i, ".radius"), "must be > 0", ball.radius);
        require_size(ball.radius, at("balls", i, ".radius"));
        validate_state(ball, i);
        validate_energy(ball, i);
        require(ball.inertia >= 1e-12 && ball.inertia <= 1, at("balls", i, ".inertia"),
                "must be from 1e-12 to 1", ball.inertia);
    }
}

/// A rim that pulls, and what it has to do with the rest of the scene.
void validate_pulling_rim(const Scene& scene, std::size_t k) {
    const Rim& rim = scene.rims[k];
    constexpr double kMost = 1e30;  // what pulls must not be lost beside it
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        require_point(scene.balls[i].velocity, kMost, at("balls", i, ".velocity"));
    }
    const auto name = [&](std::size_t i) {
        return concatenated(at("rims", i, ""), " (\"", scene.rims[i].id, "\")");
    };
    const bool rub = scene.impacts.ball_ball.law == BallBallLaw::frictional ||
                     scene.impacts.ball_cushion.law == CushionLaw::frictional;
    const bool glide = std::holds_alternative<UniformMotion>(scene.motion) ||
                       std::holds_alternative<RollingMotion>(scene.motion);
    if (rub || !glide) {
        throw SceneError(at("rims", k, ".law"),
                         "must be capture unless the motion is uniform or rolling, without "
                         "friction in impacts",
                         std::string(to_string(rim.law)));
    }
    require(scene.gravity > 0, "gravity",
            concatenated("must be > 0, for ", name(k), " pulls by it").c_str(), scene.gravity);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        require(scene.balls[i].radius < rim.radius, at("balls", i, ".radius"),
                concatenated("must be less than that of ", name(k), ", which pulls it in").c_str(),
                scene.balls[i].radius);
    }
    for (std::size_t i = 0; i < k; ++i) {
        const Rim& other = scene.rims[i];
        if (other.law == RimLaw::capture) continue;
        if (other.law != rim.law) {
            throw SceneError(at("rims", k, ".law"),
                             concatenated("must be that of ", name(i), " or capture"),
                             std::string(to_string(rim.law)));
        }
        const double apart =
            std::hypot(rim.center.x - other.center.x, rim.center.y - other.center.y);
        if (!(apart >= rim.radius + other.radius)) {
            throw SceneError(at("rims", k, ".center"),
                             concatenated("must not be so near to ", name(i),
                                          " that both could pull a ball at once"),
                             text(rim.center));
        }
    }
}

/// A segment ends where its length in double says, up to epsilon of that beside its end point: at
/// 1e12 radii 2e-4 of them, and what a ball there has too much or too little between them is half
/// the square of that. At 1e16 it would hit what is not there, or go through.
constexpr double kMostRadii = 1e12;

void validate_obstacles(const Scene& scene, Ids& ids) {
    const double smallest = facade::smallest_radius(scene);
    for (std::size_t k = 0; k < scene.segments.size(); ++k) {
        const Segment& s = scene.segments[k];
        ids.add(s.id, "segments", k);
        require_point(s.from, kLargest, at("segments", k, ".from"));
        require_point(s.to, kLargest, at("segments", k, ".to"));
        const double length = std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
        if (!(length >= 1 / kLargest)) {
            throw SceneError(at("segments", k, ".to"), "must differ from `from`", text(s.to));
        }
        if (!(length / smallest <= kMostRadii)) {
            throw SceneError(at("segments", k, ".to"),
                             "must be at most 1e12 times the smallest ball's radius from `from`",
                             text(s.to));
        }
    }
    for (std::size_t k = 0; k < scene.arcs.size(); ++k) {
        const Arc& arc = scene.arcs[k];
        ids.add(arc.id, "arcs", k);
        require_point(arc.center, kLargest, at("arcs", k, ".center"));
        require(arc.radius > 0, at("arcs", k, ".radius"), "must be > 0", arc.radius);
        require_size(arc.radius, at("arcs", k, ".radius"));
        require(std::abs(arc.from_angle) <= 100, at("arcs", k, ".from_angle"),
                "must be from -100 to 100 rad", arc.from_angle);
        require(arc.to_angle > arc.from_angle, at("arcs", k, ".to_angle"),
                "must be greater than from_angle", arc.to_angle);
        require(arc.to_angle - arc.from_angle <= 2 * std::numbers::pi * (1 + 4 * 0x1p-52),
                at("arcs", k, ".to_angle"), "must be at most a full turn after from_angle",
                arc.to_angle);
    }
    for (std::size_t k = 0; k < scene.rims.size(); ++k) {
        const Rim& rim = scene.rims[k];
        ids.add(rim.id, "rims", k);
        require_point(rim.center, kLargest, at("rims", k, ".center"));
        require(rim.radius > 0, at("rims", k, ".radius"), "must be > 0", rim.radius);
        require_size(rim.radius, at("rims", k, ".radius"));
        if (rim.law != RimLaw::capture) validate_pulling_rim(scene, k);
        if (!rim.restitution) continue;
        if (rim.law != RimLaw::tipping) {
            throw SceneError(at("rims", k, ".restitution"), "is for the law tipping only",
                             number_text(*rim.restitution));
        }
        require(*rim.restitution >= 0 && *rim.restitution <= 1, at("rims", k, ".restitution"),
                "must be from 0 to 1", *rim.restitution);
    }
}

void require_friction(double value, const char* path) {
    require(value >= 0 && value <= kLargest, path, "must be >= 0 and finite", value);
}

void validate_drag(const Scene& scene, const ResistedMotion& law) {
    // Squares of decelerations, and their products with squares of speeds, must stay in range.
    constexpr double kMost = 1e30;
    constexpr double kLeast = 1e-80;
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        require_point(scene.balls[i].velocity, kMost, at("balls", i, ".velocity"));
    }
    const auto check = [](double value, const std::string& path) {
        require(value >= 0 && value <= kMost, path, "must be from 0 to 1e30", value);
    };
    const auto check_drag = [&](double value, const std::string& path) {
        check(value, path);
        require(value == 0 || value >= kLeast, path, "must be 0 or at least 1e-80", value);
    };
    check_drag(law.constant, "motion.constant");
    check_drag(law.linear, "motion.linear");
    check_drag(law.quadratic, "motion.quadratic");
    if (!law.medium) return;
    const Medium& medium = *law.medium;
    check(medium.density, "motion.medium.density");
    check(medium.viscosity, "motion.medium.viscosity");
    check(medium.drag_coefficient, "motion.medium.drag_coefficient");
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Ball& ball = scene.balls[i];
        const double drag = std::max(
            20 * medium.viscosity * ball.radius / ball.mass,
            2 * medium.density * medium.drag_coefficient * ball.radius * (ball.radius / ball.mass));
        require(drag <= kMost, at("balls", i, ".mass"),
                "must be large enough for a drag of at most 1e30 in the medium", ball.mass);
    }
}

/// Friction without cloth is that of discs: nothing is said about their rolling or tumbling.
void validate_discs(const Scene& scene) {
    const bool rub = scene.impacts.ball_ball.law == BallBallLaw::frictional ||
                     scene.impacts.ball_cushion.law == CushionLaw::frictional;
    if (!rub || std::holds_alternative<ClothMotion>(scene.motion)) return;
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Spin& spin = scene.balls[i].spin;
        if (spin[0] == 0 && spin[1] == 0) continue;
        throw SceneError(at("balls", i, ".spin"),
                         "must be [0, 0, z] where there is friction but no cloth",
                         concatenated("[", number_text(spin[0]), ", ", number_text(spin[1]), ", ",
                                      number_text(spin[2]), "]"));
    }
}

/// Frictions, and that only scenes with cloth ask for spin.
void validate_friction(const Scene& scene) {
    const BallBallImpact& balls = scene.impacts.ball_ball;
    const CushionImpact& cushion = scene.impacts.ball_cushion;
    const auto* cloth = std::get_if<ClothMotion>(&scene.motion);
    if (const auto* rolling = std::get_if<RollingMotion>(&scene.motion)) {
        require_friction(rolling->friction, "motion.friction");
    }
    if (const auto* resisted = std::get_if<ResistedMotion>(&scene.motion)) {
        validate_drag(scene, *resisted);
    }
    if (cloth != nullptr) {
        require_friction(cloth->sliding_friction, "motion.sliding_friction");
        require_friction(cloth->rolling_friction, "motion.rolling_friction");
        require_friction(cloth->spinning_friction, "motion.spinning_friction");
    }
    const auto needs_cloth = [&](bool uses_spin, const char* path, const char* value) {
        if (uses_spin && cloth == nullptr) {
            throw SceneError(path, "needs balls with spin, that is, the motion law cloth", value);
        }
    };
    const bool upright = cushion.law == CushionLaw::frictional;
    needs_cloth(cushion.law != CushionLaw::restitution && !upright, "impacts.ball_cushion.law",
                "a law with the height of a nose");
    if (upright && cloth != nullptr) {
        throw SceneError("impacts.ball_cushion.law",
                         "must not be frictional with cloth, where cushions have noses: "
                         "han_2005, mathavan_2010 or stronge",
                         "frictional");
    }
    validate_discs(scene);
    needs_cloth(scene.cue.has_value(), "cue", "a cue");
    for (const double f : balls.friction) require_friction(f, "impacts.ball_ball.friction");
    require(scene.impacts.contact_time >= 0 && scene.impacts.contact_time <= 1,
            "impacts.contact_time", "must be from 0 to 1 s", scene.impacts.contact_time);
    if (const auto& speed = scene.impacts.rest_speed) {
        require(*speed >= 0 && std::isfinite(*speed), "impacts.rest_speed",
                "must be finite and not negative [m/s]", *speed);
        require(scene.impacts.simultaneous == Simultaneous::symmetric, "impacts.rest_speed",
                "needs the symmetric law for simultaneous impacts", *speed);
    }
    if (cushion.law == CushionLaw::restitution) return;
    require_friction(cushion.friction, "impacts.ball_cushion.friction");
    require_friction(cushion.cloth_friction.value_or(0), "impacts.ball_cushion.cloth_friction");
    require(cushion.frequency_ratio > 1 && cushion.frequency_ratio < 2,
            "impacts.ball_cushion.frequency_ratio", "must be above 1 and below 2",
            cushion.frequency_ratio);
    if (upright) return;
    for (const Ball& ball : scene.balls) {
        require(cushion.height > 0 && cushion.height < 2 * ball.radius,
                "impacts.ball_cushion.height", "must be above 0 and below every ball's top",
                cushion.height);
    }
}

void validate_laws(const Scene& scene) {
    const auto restitution = [](double e, const char* path) {
        require(e >= 0 && e <= 1, path, "must be from 0 to 1", e);
    };
    restitution(scene.impacts.ball_ball.restitution, "impacts.ball_ball.restitution");
    restitution(scene.impacts.ball_cushion.restitution, "impacts.ball_cushion.restitution");
    validate_friction(scene);
    require(scene.gravity >= 0 && std::isfinite(scene.gravity), "gravity",
            "must be >= 0 and finite", scene.gravity);
    require(scene.limits.time > 0 && std::isfinite(scene.limits.time), "limits.time",
            "must be > 0 and finite", scene.limits.time);
    require(scene.limits.events > 0, "limits.events", "must be > 0", 0);
}

[[noreturn]] void throw_overlap(std::size_t i, const std::string& other, double depth) {
    throw SceneError(
        at("balls", i, ".position"),
        concatenated("must not overlap ", other, " by more than 1e-7 of the smaller radius"),
        concatenated("an overlap of ", number_text(depth), " m"));
}

/// How deep the ball is in the straight part of a segment, as seen from the side that stops it [m].
double depth_in(const Ball& ball, const Segment& s) {
    const double length = std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
    const Point along{(s.to.x - s.from.x) / length, (s.to.y - s.from.y) / length};
    const Point d{ball.position.x - s.from.x, ball.position.y - s.from.y};
    const double foot = d.x * along.x + d.y * along.y;
    const double height = along.x * d.y - along.y * d.x;
    if (foot < 0 || foot > length || (s.side == Side::left && height < 0)) return 0;
    return ball.radius - std::abs(height);
}

double depth_in(const Ball& ball, const Point& p) {
    return ball.radius - std::hypot(ball.position.x - p.x, ball.position.y - p.y);
}

double depth_in(const Ball& ball, const Arc& arc) {
    const Point d{ball.position.x - arc.center.x, ball.position.y - arc.center.y};
    double angle = std::fmod(std::atan2(d.y, d.x) - arc.from_angle, 2 * std::numbers::pi);
    if (angle < 0) angle += 2 * std::numbers::pi;
    if (angle > arc.to_angle - arc.from_angle) return 0;
    return ball.radius - std::abs(std::hypot(d.x, d.y) - arc.radius);
}

/// Whether the ball is where it touches all of the arc at once, so that no direction is that of the
/// contact.
bool fills(const Ball& ball, const Arc& arc) {
    const double off = std::hypot(ball.position.x - arc.center.x, ball.position.y - arc.center.y);
    return ball.radius >= arc.radius && off <= math::kStartOverlap * arc.radius;
}

Point on_arc(const Arc& arc, double angle) {
    return {arc.center.x + arc.radius * std::cos(angle),
            arc.center.y + arc.radius * std::sin(angle)};
}

/// Whether the ball is so far from the box of two corners that it cannot reach into it.
bool is_far(const Ball& ball, const Point& a, const Point& b) {
    const double r = ball.radius;
    const Point& p = ball.position;
    return p.x + r < std::min(a.x, b.x) || p.x - r > std::max(a.x, b.x) ||
           p.y + r < std::min(a.y, b.y) || p.y - r > std::max(a.y, b.y);
}

/// Throws if the ball overlaps an obstacle or is inside a rim.
void validate_place(const Scene& scene, std::size_t i) {
    const Ball& ball = scene.balls[i];
    const auto check = [&](double depth, const char* list, std::size_t k, const char* part) {
        if (depth > math::kStartOverlap * ball.radius) throw_overlap(i, at(list, k, part), depth);
    };
    for (std::size_t k = 0; k < scene.segments.size(); ++k) {
        const Segment& segment = scene.segments[k];
        if (is_far(ball, segment.from, segment.to)) continue;
        check(depth_in(ball, segment), "segments", k, "");
        check(depth_in(ball, segment.from), "segments", k, ".from");
        check(depth_in(ball, segment.to), "segments", k, ".to");
    }
    for (std::size_t k = 0; k < scene.arcs.size(); ++k) {
        const Arc& arc = scene.arcs[k];
        if (is_far(ball, {arc.center.x - arc.radius, arc.center.y - arc.radius},
                   {arc.center.x + arc.radius, arc.center.y + arc.radius})) {
            continue;
        }
        check(depth_in(ball, arc), "arcs", k, "");
        if (fills(ball, arc)) {
            throw SceneError(at("balls", i, ".radius"),
                             concatenated("must be < that of ", at("arcs", k, ""),
                                          ", at whose centre it would touch all of it"),
                             number_text(ball.radius));
        }
        if (arc.to_angle - arc.from_angle < 2 * std::numbers::pi * (1 - 4 * 0x1p-52)) {
            check(depth_in(ball, on_arc(arc, arc.from_angle)), "arcs", k, " (its start)");
            check(depth_in(ball, on_arc(arc, arc.to_angle)), "arcs", k, " (its end)");
        }
    }
    for (std::size_t k = 0; k < scene.rims.size(); ++k) {
        const Rim& rim = scene.rims[k];
        // A rim that pulls takes balls that are as far inside as their radius.
        const bool pulls = rim.law != RimLaw::capture;
        const double open = pulls ? rim.radius - ball.radius : rim.radius;
        const double inside =
            open - std::hypot(ball.position.x - rim.center.x, ball.position.y - rim.center.y);
        if (inside > math::kStartOverlap * rim.radius) {
            throw SceneError(
                at("balls", i, ".position"),
                concatenated(pulls ? "must not have fallen into " : "must not be inside ",
                             at("rims", k, ""), " (\"", rim.id, "\")"),
                text(ball.position));
        }
    }
}

void validate_places(const Scene& scene) {
    if (const auto overlap = facade::find_overlap(scene.balls, math::kStartOverlap)) {
        throw_overlap(overlap->second,
                      concatenated(at("balls", overlap->first, ""), " (\"",
                                   scene.balls[overlap->first].id, "\")"),
                      overlap->depth);
    }
    for (std::size_t i = 0; i < scene.balls.size(); ++i) validate_place(scene, i);
}

void validate_closed(const Scene& scene) {
    if (!scene.closed || scene.balls.empty()) return;
    const double smallest = facade::smallest_radius(scene);
    facade::Outline outline(scene, smallest);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (!outline.encloses(scene.balls[i].position)) {
            throw SceneError(
                at("balls", i, ".position"),
                concatenated(
                    "must be inside a closed outline (the scene says \"closed\": true) with "
                    "no gap that a ball of radius ",
                    number_text(smallest), " m fits through"),
                text(scene.balls[i].position));
        }
    }
}

}  // namespace

bool facade::is_valid_start(const Scene& scene, std::span<const std::uint8_t> present) {
    const auto is_there = [&](std::size_t i) { return present.empty() || present[i] != 0; };
    try {
        for (std::size_t i = 0; i < scene.balls.size(); ++i) {
            if (!is_there(i)) continue;
            validate_state(scene.balls[i], i);
            validate_place(scene, i);
        }
    } catch (const SceneError&) {
        return false;
    }
    return !has_overlap(scene.balls, present, math::kStartOverlap);
}

void validate(const Scene& scene) {
    Ids ids;
    validate_balls(scene, ids);
    validate_obstacles(scene, ids);
    validate_laws(scene);
    validate_cue(scene);
    facade::validate_forces(scene);
    validate_places(scene);
    validate_closed(scene);
}

}  // namespace osculo

#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <variant>

#include "osculo/io.hpp"
#include "osculo/simulate.hpp"

namespace osculo::fuzz {
namespace {

constexpr std::uint64_t kMostEvents = 300;
constexpr std::uint64_t kFewEvents = 30;  // files and pictures of more show nothing new

bool same_end(const Run& one, const Run& other, bool reversed) {
    if (one.status != other.status || one.event_count != other.event_count) return false;
    if (one.time != other.time) return false;
    const std::size_t count = one.balls.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (one.balls[i] != other.balls[reversed ? count - 1 - i : i]) return false;
    }
    return true;
}

/// The contacts of one cluster are not parted: the last may go beyond the limit.
bool within_limit(const Run& run) {
    const std::uint64_t limit = run.scene.limits.events;
    if (run.event_count <= limit) return true;
    const std::uint32_t cluster = run.events.back().cluster;
    return cluster != 0 && std::all_of(run.events.begin() + static_cast<std::ptrdiff_t>(limit) - 1,
                                       run.events.end(), [cluster](const Event& event) {
                                           return event.cluster == cluster;
                                       });
}

/// Whether nothing in it may take energy: contacts that are elastic, and no cluster that may be
/// jammed between cushions, whose impact is not (README).
bool elastic(const Run& run) {
    const Scene& scene = run.scene;
    const Impacts& law = scene.impacts;
    if (!std::holds_alternative<UniformMotion>(scene.motion) || !scene.rims.empty()) return false;
    if (law.ball_ball.law != BallBallLaw::restitution || law.ball_ball.restitution != 1 ||
        law.ball_cushion.law != CushionLaw::restitution || law.ball_cushion.restitution != 1) {
        return false;
    }
    return (scene.segments.empty() && scene.arcs.empty()) ||
           std::ranges::all_of(run.events, &Event::well_posed);
}

/// To a billionth: 300 events of some hundred roundings each.
bool keeps_energy(const Run& run) {
    long double gain = 0;
    long double before = 0;
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        const Point& was = run.scene.balls[i].velocity;
        const Point& is = run.balls[i].state.velocity;
        for (const auto& [v, w] : {std::pair{was.x, is.x}, std::pair{was.y, is.y}}) {
            const long double a = v;
            const long double b = w;
            gain += run.scene.balls[i].mass * (b - a) * (b + a);
            before += run.scene.balls[i].mass * a * a;
        }
    }
    return std::abs(gain) <= 1e-9L * before;
}

}  // namespace

void require(bool condition, const char* what, const Scene& scene) {
    if (condition) return;
    std::fprintf(stderr, "broken: %s\n%s", what, io::scene_to_json(scene).c_str());
    std::abort();
}

void check_run(Scene scene) {
    scene.limits.events = std::min(scene.limits.events, kMostEvents);
    Options options;
    options.audit = true;
    const Run run = simulate(scene, options);
    require(within_limit(run), "more events than the limit", scene);
    require(run.time <= scene.limits.time, "later than the limit", scene);
    require(run.events.size() == run.event_count, "events are not all recorded", scene);
    if (run.status == Status::numeric) return;  // the numbers are said to mean nothing
    require(run.audit->clean, "the audit is not clean", scene);
    if (run.status != Status::zeno && elastic(run)) {
        require(keeps_energy(run), "energy is lost", scene);
    }

    const std::string text = io::run_to_json(run);
    require(io::run_to_json(io::run_from_json(text)) == text, "a file does not give it back",
            scene);
    require(!io::to_svg(run).empty(), "there is no picture", scene);

    const Run bare = simulate(scene, {.record = Record::none});
    require(same_end(run, bare, false), "recording changes it", scene);
    Scene reversed = scene;
    std::ranges::reverse(reversed.balls);
    require(same_end(run, simulate(reversed, options), true), "the order of the balls changes it",
            scene);
}

}  // namespace osculo::fuzz

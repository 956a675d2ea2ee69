#include "play.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace osculo::bench::stability {
namespace {

struct Cost {
    double digits;             ///< decimal digits of the type
    double seconds_per_event;  ///< roughly, of few balls on a busy machine
};

Cost cost_of(Precision precision) {
    switch (precision) {
        case Precision::double_precision: return {15.95, 3e-6};
        case Precision::extended: return {19.27, 1.2e-5};
        case Precision::quad: return {34.02, 5e-5};
        case Precision::digits50: return {50, 1.5e-4};
        case Precision::digits100: return {100, 2.5e-4};
    }
    return {};
}

bool affordable(const Case& c, Precision precision, double budget) {
    return c.about * cost_of(precision).seconds_per_event <= budget;
}

/// Largest error of any value, relative to the case's scale; infinite if they cannot be compared.
double error_of(const Case& c, const Values& got, const Values& expected) {
    if (got.size() != expected.size()) return INFINITY;
    double worst = 0;
    for (std::size_t k = 0; k < got.size(); ++k) {
        const double own = std::abs(expected[k]);
        const double scale = c.scale > 0 ? c.scale : own > 0 ? own : 1;
        const double error = std::abs(got[k] - expected[k]) / scale;
        if (!(error <= worst)) worst = error;  // what is no number is kept, and fails
    }
    return worst;
}

double digits_of(double error) {
    if (error == 0) return Row::kMostDigits;
    if (!std::isfinite(error)) return -99;
    return std::clamp(-std::log10(error), -99.0, Row::kMostDigits);
}

Scene under(const Scene& scene, std::size_t law) {
    Scene copy = scene;
    copy.impacts.simultaneous = kLaws[law].law;
    // Of the symmetric law only.
    if (kLaws[law].law == Simultaneous::sequential) copy.impacts.rest_speed.reset();
    return copy;
}

constexpr double kMove = 1e-13;

/// Whether any two balls are together from the start.
bool some_touch(const std::vector<Ball>& balls) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double reach = balls[i].radius + balls[j].radius;
            const double apart = std::hypot(balls[i].position.x - balls[j].position.x,
                                            balls[i].position.y - balls[j].position.y);
            if (apart < reach * (1 + 1e-6)) return true;
        }
    }
    return false;
}

/// The scene with every velocity, or what the cue does and where the balls are that it sends into
/// each other, moved by up to kMove, this way and that.
Scene moved(const Scene& scene, std::uint64_t seed) {
    Scene copy = scene;
    std::uint64_t state = seed;
    const auto sign = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return (state >> 63) != 0 ? kMove : -kMove;
    };
    for (Ball& b : copy.balls) {
        const double speed = std::hypot(b.velocity.x, b.velocity.y);
        b.velocity.x += speed * sign();
        b.velocity.y += speed * sign();
    }
    if (copy.cue) {
        copy.cue->speed *= 1 + sign();
        copy.cue->azimuth += sign();
        copy.cue->offset[0] += sign();
        if (some_touch(copy.balls)) return copy;
        for (Ball& b : copy.balls) {
            if (b.id == copy.cue->ball) continue;
            b.position.x += b.radius * sign();
            b.position.y += b.radius * sign();
        }
    }
    return copy;
}

std::string objection(const Case& c, const Run& run) {
    if (std::find(c.statuses.begin(), c.statuses.end(), run.status) == c.statuses.end()) {
        return "ended with " + std::string(to_string(run.status));
    }
    if (c.most_events > 0 && run.event_count > c.most_events) return "too many events";
    if (run.audit && !run.audit->clean) return "audit not clean";
    return {};
}

}  // namespace

Target target(const Case& c, std::size_t law, double budget) {
    Target t;
    t.may_lose = c.may_lose;
    if (c.status_only) {
        t.known = true;
        return t;
    }
    if (!c.expected.empty()) {
        t.known = true;
        t.values = c.expected[std::min(law, c.expected.size() - 1)];
        return t;
    }
    if (!affordable(c, Precision::digits100, budget)) return t;
    const Options options{.precision = Precision::digits100, .record = Record::events};
    const Scene scene = under(c.reference.value_or(c.scene), law);
    const Run run = simulate(scene, options);
    t.known = t.is_reference = true;
    t.values = c.read(run);
    // How far starts that are moved by 1e-13 end from it, and a random walk of the events'
    // rounding.
    double grown = 1;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Run other = simulate(moved(scene, seed), options);
        grown = std::max(grown, error_of(c, c.read(other), t.values) / kMove);
    }
    const double walk = 0.5 * std::log10(std::max(1.0, static_cast<double>(run.event_count)));
    t.may_lose = 2 + walk + std::log10(grown);
    return t;
}

Row play(const Case& c, std::size_t law, Precision precision, const Target& target, double budget) {
    Row row;
    if (!target.known || !affordable(c, precision, budget)) return row;
    const auto start = std::chrono::steady_clock::now();
    const Run run =
        simulate(under(c.scene, law), {.precision = precision,
                                       .record = c.audited ? Record::pieces : Record::none,
                                       .audit = c.audited});
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.events = run.event_count;
    row.status = run.status;
    if (run.audit) row.audit = run.audit->clean ? "clean" : "not clean";
    row.why = objection(c, run);
    if (c.status_only) {
        row.verdict = row.why.empty() ? Verdict::status_only : Verdict::wrong;
        return row;
    }
    row.got = c.read(run);
    row.digits = digits_of(error_of(c, row.got, target.values));
    // Closed forms take the scene's decimals as they are meant, runs as doubles have them.
    const double held = cost_of(precision).digits;
    row.needed = target.is_reference ? std::min(14.5, held - target.may_lose)
                                     : std::min(held, 15.95) - target.may_lose;
    row.needed = std::min(row.needed, c.enough);
    if (row.why.empty() && row.digits < row.needed) row.why = "too few digits";
    row.verdict = !row.why.empty()             ? Verdict::wrong
                  : run.status == Status::zeno ? Verdict::status_only
                                               : Verdict::right;
    return row;
}

}  // namespace osculo::bench::stability

#include "cli/summary.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "osculo/outcome.hpp"

namespace osculo::cli {
namespace {

std::string counted(std::uint64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string_view words(Status status) {
    switch (status) {
        case Status::at_rest: return "everything at rest";
        case Status::time_limit: return "time limit reached";
        case Status::event_limit: return "event limit reached";
        case Status::zeno: return "impacts accumulate without time advancing";
        case Status::numeric: return "numbers of this precision cannot tell what happens next";
    }
    return "";
}

/// Of its motion and spin [J].
double energy(const Ball& ball, Point velocity, const Spin& spin) {
    double turning = 0;  // squared speed of its surface
    for (const double w : spin) turning += ball.radius * w * (ball.radius * w);
    return ball.mass / 2 *
           (velocity.x * velocity.x + velocity.y * velocity.y + ball.inertia * turning);
}

class Report {
public:
    void line(std::string_view label, std::string_view text) {
        fmt::format_to(std::back_inserter(text_), "  {:<10}{}\n", label, text);
    }
    void title(std::string_view text) { fmt::format_to(std::back_inserter(text_), "{}\n", text); }
    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void report_energy(Report& report, const Run& run) {
    double initial = 0;
    double moving = 0;
    double captured = 0;
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        const Ball& ball = run.scene.balls[i];
        initial += energy(ball, ball.velocity, ball.spin);
        const bool is_captured = run.balls[i].fate == BallFate::captured;
        const BallState& end = run.balls[i].state;
        (is_captured ? captured : moving) += energy(ball, end.velocity, end.spin);
    }
    std::string text =
        fmt::format("{:.9g} J at the start, {:.9g} J at the end", initial, moving + captured);
    if (captured > 0) text += fmt::format(" ({:.9g} J of it captured)", captured);
    report.line("energy", text);
}

void report_balls(Report& report, const Run& run) {
    const auto count = [&run](BallFate fate) {
        return std::ranges::count(run.balls, fate, &FinalBall::fate);
    };
    report.line("balls", fmt::format("{} moving, {} at rest, {} captured", count(BallFate::moving),
                                     count(BallFate::rest), count(BallFate::captured)));
}

void report_events(Report& report, const Run& run) {
    if (run.events.empty()) {
        report.line("events", run.event_count == 0 ? "none" : "not recorded");
        return;
    }
    std::map<EventKind, std::uint64_t> counts;
    for (const Event& event : run.events) ++counts[event.kind];
    std::string text;
    for (const auto& [kind, count] : counts) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, to_string(kind));
    }
    report.line("events", text);
}

// In order of time if that is known.
void report_captures(Report& report, const Run& run) {
    constexpr std::size_t kMost = 40;
    std::vector<std::string> lines;
    for (const Event& event : run.events) {
        if (event.kind != EventKind::capture) continue;
        const auto [ball, rim] = run.ids(event);
        lines.push_back(fmt::format("{:<6}{:>12.6f} s  {}", ball, event.time, rim));
    }
    if (run.events.empty()) {
        for (std::size_t i = 0; i < run.balls.size(); ++i) {
            if (!run.balls[i].rim) continue;
            lines.push_back(fmt::format("{:<6}{}", run.scene.balls[i].id,
                                        run.scene.rims[*run.balls[i].rim].id));
        }
    }
    for (std::size_t i = 0; i < std::min(lines.size(), kMost); ++i) {
        report.line(i == 0 ? "captured" : "", lines[i]);
    }
    if (lines.size() > kMost) report.line("", fmt::format("and {} more", lines.size() - kMost));
}

// What players ask for; of scenes that begin with one moving ball.
void report_outcome(Report& report, const Run& run) {
    const std::optional<Outcome> outcome = outcome_of(run);
    if (!outcome || !outcome->cue_ball) return;
    const auto id = [&run](std::uint32_t ball) -> const std::string& {
        return run.scene.balls[ball].id;
    };
    constexpr std::size_t kMost = 8;
    if (outcome->hits.empty()) report.line("hits", id(*outcome->cue_ball) + " hits nothing");
    for (std::size_t i = 0; i < std::min(outcome->hits.size(), kMost); ++i) {
        const Outcome::Hit& hit = outcome->hits[i];
        std::string text = fmt::format("{:<6}{:>12.6f} s", id(hit.ball), hit.time);
        if (hit.cushions > 0) text += "  after " + counted(hit.cushions, "cushion");
        report.line(i == 0 ? "hits" : "", text);
    }
    if (outcome->hits.size() > kMost) {
        report.line("", fmt::format("and {} more", outcome->hits.size() - kMost));
    }
    report.line("cushions", fmt::format("{} meets {} before its first hit and {} after; {} driven "
                                        "to one",
                                        id(*outcome->cue_ball), outcome->cushions_before_hit,
                                        outcome->cushions_after_hit,
                                        counted(outcome->driven_to_cushion, "other ball")));
    report.line("kisses", std::to_string(outcome->kisses));
}

void report_audit(Report& report, const Audit& audit) {
    report.line("audit", audit.clean ? "clean" : "NOT CLEAN");
    std::string gap = fmt::format("{:.3g} radii", audit.worst_gap);
    if (audit.worst_gap_ids.size() == 2) {
        gap += fmt::format(", between {} and {} at {:.9g} s", audit.worst_gap_ids[0],
                           audit.worst_gap_ids[1], audit.worst_gap_time);
    }
    report.line("", "worst gap " + gap);
    report.line("", fmt::format("largest energy gain {:.3g}, momentum error {:.3g}, jump {:.3g}",
                                audit.largest_energy_gain, audit.largest_momentum_error,
                                audit.largest_jump));
    if (audit.unexplained > 0) {
        report.line("", counted(audit.unexplained, "change") + " without explanation");
    }
}

// Fewest digits of the confirmed ones; nothing if there are none.
template <class Range, class Digits>
std::optional<double> fewest(const Range& range, Digits digits) {
    std::optional<double> found;
    for (const auto& element : range) {
        if (element.confirmed) found = std::min(found.value_or(99), digits(element));
    }
    return found;
}

void report_certificate(Report& report, const Run& run, const Certificate& certificate) {
    using EventDigits = Certificate::EventDigits;
    using BallDigits = Certificate::BallDigits;
    const auto& events = certificate.events;
    const auto confirmed = std::ranges::count(events, true, &EventDigits::confirmed);
    report.line("certified",
                fmt::format("{} of {}, by {}{}", confirmed, counted(events.size(), "event"),
                            certificate.reference,
                            certificate.witness.empty() ? "" : " and " + certificate.witness));
    if (!certificate.conclusive) {
        report.line("", "NOT CONCLUSIVE: no two higher precisions agree as far as that");
    }
    if (const auto time = fewest(events, [](const EventDigits& e) { return e.time; })) {
        report.line(
            "", fmt::format("digits at least: time {:.1f}, position {:.1f}, velocity {:.1f}", *time,
                            *fewest(events, [](const EventDigits& e) { return e.position; }),
                            *fewest(events, [](const EventDigits& e) { return e.velocity; })));
    }
    const auto at = [&](std::uint64_t index) {
        const Event& event = run.events[index];
        const auto [ball, other] = run.ids(event);
        return fmt::format("event {}, {} of {}{} at {:.9g} s", index, to_string(event.kind), ball,
                           other.empty() ? "" : " and " + other, event.time);
    };
    if (certificate.first_uncertain) {
        report.line("", "first uncertain: " + at(*certificate.first_uncertain));
    }
    if (certificate.first_out_of_order &&
        certificate.first_out_of_order != certificate.first_uncertain) {
        report.line("", "first whose order is uncertain: " + at(*certificate.first_out_of_order));
    }
    constexpr std::size_t kMost = 24;
    std::size_t count = 0;
    for (std::size_t i = 0; i < run.balls.size(); ++i) {
        const BallDigits& ball = certificate.balls[i];
        if (!ball.confirmed || ++count > kMost) continue;
        report.line(count == 1 ? "digits" : "",
                    fmt::format("{:<6} position {:4.1f}, velocity {:4.1f}", run.scene.balls[i].id,
                                ball.position, ball.velocity));
    }
    if (count > kMost) report.line("", fmt::format("and {} more", count - kMost));
    if (count < run.balls.size()) {
        report.line(count == 0 ? "digits" : "",
                    counted(run.balls.size() - count, "ball") + " without any");
    }
}

}  // namespace

std::string summary(const Run& run, const std::string& name, double seconds) {
    Report report;
    report.title(fmt::format("{}: {} at {:.9g} s, after {}", name, words(run.status), run.time,
                             counted(run.event_count, "event")));
    report.line("status", to_string(run.status));
    report_events(report, run);
    report_balls(report, run);
    report_captures(report, run);
    report_outcome(report, run);
    if (!run.scene.cue) report_energy(report, run);
    if (run.audit) report_audit(report, *run.audit);
    if (run.certificate) report_certificate(report, run, *run.certificate);
    report.line("engine", run.engine.name);
    report.line("took",
                fmt::format("{:.3g} s, {:.3g} events/s", seconds,
                            static_cast<double>(run.event_count) / std::max(seconds, 1e-9)));
    return report.take();
}

std::string contents(const Scene& scene) {
    std::string text = counted(scene.balls.size(), "ball");
    const std::array others{std::pair{scene.segments.size(), "segment"},
                            std::pair{scene.arcs.size(), "arc"},
                            std::pair{scene.rims.size(), "rim"}};
    for (const auto& [count, noun] : others) {
        if (count > 0) text += ", " + counted(count, noun);
    }
    return text;
}

}  // namespace osculo::cli

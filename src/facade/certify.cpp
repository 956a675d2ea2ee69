#include "certify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "osculo/math/instant.hpp"

namespace osculo {

bool Certificate::certain() const {
    return conclusive && std::ranges::all_of(events, &EventDigits::confirmed) &&
           std::ranges::all_of(balls, &BallDigits::confirmed);
}

namespace facade {
namespace {

double norm(Point p) {
    return std::hypot(p.x, p.y);
}

double digits(double difference, double scale) {
    if (difference == 0) return Certificate::kMostDigits;
    if (!(difference < scale)) return 0;  // and so for NaN
    return std::min(Certificate::kMostDigits, std::log10(scale) - std::log10(difference));
}

double digits(Point a, Point b, double scale) {
    return digits(std::hypot(a.x - b.x, a.y - b.y), scale);
}

double time_digits(const Event& a, const Event& b) {
    const double difference = math::duration<double>(math::two_sum(a.time, a.time_low),
                                                     math::two_sum(b.time, b.time_low));
    return digits(std::abs(difference), std::abs(b.time));
}

/// Which events each ball takes part in, in order.
struct Histories {
    explicit Histories(const Run& run) : of_ball(run.balls.size()), places(run.events.size()) {
        for (std::size_t i = 0; i < run.events.size(); ++i) {
            const Event& event = run.events[i];
            places[i] = {of_ball[event.ball].size(), 0};
            of_ball[event.ball].push_back(i);
            if (event.kind != EventKind::ball_ball) continue;
            places[i][1] = of_ball[event.other].size();
            of_ball[event.other].push_back(i);
        }
    }

    std::vector<std::vector<std::size_t>> of_ball;
    /// Of each event, its place in the histories of its one or two balls.
    std::vector<std::array<std::size_t, 2>> places;
};

bool same_things(const Event& a, const Event& b) {
    if (a.kind != b.kind || a.ball != b.ball) return false;
    if (a.kind == EventKind::transition) return a.from == b.from && a.to == b.to;
    return a.other == b.other;
}

/// Events of one run found in another one.
class Comparison {
public:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    Comparison(const Run& run, const Histories& histories, const Run& other)
        : match(run.events.size(), kNone), follows(run.balls.size(), true) {
        const Histories others(other);
        for (std::size_t i = 0; i < run.events.size(); ++i) {
            const Event& event = run.events[i];
            const bool both = event.kind == EventKind::ball_ball;
            const auto& places = histories.places[i];
            bool found = follows[event.ball] && (!both || follows[event.other]) &&
                         places[0] < others.of_ball[event.ball].size();
            if (found) {
                const std::size_t j = others.of_ball[event.ball][places[0]];
                found = same_things(event, other.events[j]) &&
                        (!both || others.places[j][1] == places[1]);
                if (found) match[i] = j;
            }
            if (!found) {
                follows[event.ball] = false;
                if (both) follows[event.other] = false;
            }
        }
        for (std::size_t b = 0; b < follows.size(); ++b) {
            follows[b] = follows[b] && others.of_ball[b].size() == histories.of_ball[b].size() &&
                         other.balls[b].fate == run.balls[b].fate &&
                         other.balls[b].rim == run.balls[b].rim;
        }
        whole = std::ranges::find(match, kNone) == match.end() &&
                std::ranges::find(follows, false) == follows.end();
    }

    std::vector<std::size_t> match;  ///< of each event, its index in the other run
    std::vector<bool> follows;       ///< each ball: the same history and end
    bool whole = false;              ///< all of that
};

class Certifier {
public:
    Certifier(const Run& run, const Histories& histories)
        : run_(run), histories_(histories), speeds_(run.balls.size()) {
        for (std::size_t b = 0; b < speeds_.size(); ++b)
            speeds_[b] = norm(run.balls[b].state.velocity);
        for (const Event& event : run.events) {
            for (std::size_t k = 0; k < ball_count(event); ++k) {
                double& speed = speeds_[ball_of(event, k)];
                speed = std::max(
                    {speed, norm(event.before[k].velocity), norm(event.after[k].velocity)});
            }
        }
        certificate_.events.assign(
            run.events.size(),
            {true, Certificate::kMostDigits, Certificate::kMostDigits, Certificate::kMostDigits});
        certificate_.balls.assign(run.balls.size(),
                                  {true, Certificate::kMostDigits, Certificate::kMostDigits});
    }

    /// Takes away what the other run does not confirm.
    void hold_against(const Run& other, const Comparison& comparison) {
        for (std::size_t i = 0; i < run_.events.size(); ++i) {
            if (comparison.match[i] == Comparison::kNone) {
                certificate_.events[i] = {};
            } else if (certificate_.events[i].confirmed) {
                compare(i, other.events[comparison.match[i]]);
            }
        }
        for (std::size_t b = 0; b < run_.balls.size(); ++b) {
            Certificate::BallDigits& ball = certificate_.balls[b];
            if (!comparison.follows[b]) {
                ball = {};
            } else if (ball.confirmed) {
                compare(ball, b, run_.balls[b].state, other.balls[b].state);
            }
        }
    }

    [[nodiscard]] Certificate take(const Comparison& reference) {
        const auto& events = certificate_.events;
        const auto uncertain =
            std::ranges::find(events, false, &Certificate::EventDigits::confirmed);
        if (uncertain != events.end())
            certificate_.first_uncertain = std::uint64_t(uncertain - events.begin());
        for (std::size_t i = 0; i < events.size(); ++i) {
            if (events[i].confirmed && reference.match[i] == i) continue;
            certificate_.first_out_of_order = i;
            break;
        }
        return std::move(certificate_);
    }

private:
    static std::size_t ball_count(const Event& event) {
        return event.kind == EventKind::ball_ball ? 2 : 1;
    }
    static std::size_t ball_of(const Event& event, std::size_t k) {
        return k == 0 ? event.ball : event.other;
    }
    template <class Digits>
    void compare(Digits& found, std::size_t ball, const BallState& a, const BallState& b) const {
        const double place = std::max(norm(b.position), run_.scene.balls[ball].radius);
        found.position = std::min(found.position, digits(a.position, b.position, place));
        found.velocity = std::min(found.velocity, digits(a.velocity, b.velocity, speeds_[ball]));
    }
    void compare(std::size_t i, const Event& other) {
        const Event& event = run_.events[i];
        Certificate::EventDigits& found = certificate_.events[i];
        found.time = std::min(found.time, time_digits(event, other));
        for (std::size_t k = 0; k < ball_count(event); ++k) {
            compare(found, ball_of(event, k), event.before[k], other.before[k]);
            compare(found, ball_of(event, k), event.after[k], other.after[k]);
        }
    }

    const Run& run_;
    const Histories& histories_;
    std::vector<double> speeds_;  ///< the largest of each ball [m/s]
    Certificate certificate_;
};

/// Whether the witness has everything that run and reference agree on.
bool confirms(const Comparison& reference, const Comparison& witness) {
    for (std::size_t i = 0; i < reference.match.size(); ++i) {
        if (reference.match[i] != Comparison::kNone && witness.match[i] == Comparison::kNone)
            return false;
    }
    for (std::size_t b = 0; b < reference.follows.size(); ++b) {
        if (reference.follows[b] && !witness.follows[b]) return false;
    }
    return true;
}

/// Events to look at beyond twice those that are certain.
constexpr std::uint64_t kBeyond = 1000;

std::vector<Precision> above(Precision precision) {
    std::vector<Precision> result;
    // Where long double is double it is no witness.
    constexpr bool kExtends =
        std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;
    if (precision < Precision::extended && kExtends) result.push_back(Precision::extended);
    for (const Precision p : {Precision::quad, Precision::digits50, Precision::digits100}) {
        if (precision < p) result.push_back(p);
    }
    return result;
}

}  // namespace

Certificate compare(const Run& run, const Run& reference, const Run* witness) {
    const Histories histories(run);
    Certifier certifier(run, histories);
    const Comparison with_reference(run, histories, reference);
    certifier.hold_against(reference, with_reference);
    bool conclusive = false;
    if (witness != nullptr) {
        const Comparison with_witness(run, histories, *witness);
        conclusive = confirms(with_reference, with_witness);
        certifier.hold_against(*witness, with_witness);
    }
    Certificate certificate = certifier.take(with_reference);
    certificate.conclusive = conclusive;
    return certificate;
}

Certificate certify(const Run& run, Precision precision) {
    const std::vector<Precision> ladder = above(precision);
    if (ladder.empty()) {
        throw SceneError("precision", "must be below 100 digits for a run to be certified",
                         std::string(to_string(precision)));
    }
    Certificate certificate;
    std::optional<Run> witness;
    Scene scene = run.scene;
    for (const Precision next : ladder) {
        Run reference = simulate(scene, {next, Record::events});
        const std::string confirmed_by = certificate.reference;
        certificate = compare(run, reference, witness ? &*witness : nullptr);
        certificate.reference = to_string(next);
        certificate.witness = confirmed_by;
        if (certificate.conclusive) break;
        witness = std::move(reference);
        // Nothing can be said long after the run has gone its own way: do not compute it.
        if (certificate.first_uncertain) {
            scene.limits.events =
                std::min(scene.limits.events, 2 * *certificate.first_uncertain + kBeyond);
        }
    }
    return certificate;
}

}  // namespace facade
}  // namespace osculo

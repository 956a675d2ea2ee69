// Accumulating impacts: rows at low restitution, with the thresholds below which they collapse.

#include <algorithm>
#include <limits>
#include <numbers>

#include "case.hpp"

namespace osculo::bench::stability {
namespace {

constexpr Status kEither[] = {Status::time_limit, Status::zeno};

/// 1 if some neighbours of a row along x have ended up together, or the run said `zeno`.
Values read_collapse(const Run& run) {
    if (run.status == Status::zeno) return {1};
    double slowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < run.balls.size(); ++k) {
        const BallState &a = run.balls[k].state, &b = run.balls[k + 1].state;
        slowest = std::min(slowest, std::abs(a.velocity.x - b.velocity.x));
    }
    return {slowest < 1e-12 ? 1.0 : 0.0};
}

Case named(std::string name, std::string stiff) {
    Case c;
    c.name = std::move(name);
    c.family = "collapse";
    c.stiff = std::move(stiff);
    c.statuses.assign(std::begin(kEither), std::end(kEither));
    c.scene.limits = {1000, 1'000'000};
    c.most_events = 100'000;  // the more digits, the longer until nothing is left of a speed
    c.about = 5000;
    return c;
}

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", x);
    return text;
}

/// Momentum is all that must come out of a collapse: the status says the rest.
void add_rows(Catalogue& all) {
    for (const double e : {0.0, 0.1, 0.5}) {
        for (const int count : {3, 5, 10, 20}) {
            for (const double gap : {0.0, 0.5}) {
                Case c = named("row of " + std::to_string(count) +
                                   (gap > 0 ? ", gaps 0.5" : ", touching") + ", e = " + number(e),
                               "one ball into a row at rest");
                c.scene.impacts.ball_ball.restitution = e;
                for (int k = 0; k < count; ++k) {
                    c.scene.balls.push_back(ball(std::to_string(k), 1, 1,
                                                 {k == 0 ? -5 : (k - 1) * (2 + gap), 0},
                                                 {k == 0 ? 1. : 0., 0}));
                }
                c.read = [](const Run& run) {
                    double sum = 0;
                    for (const FinalBall& b : run.balls) sum += b.state.velocity.x;
                    return Values{sum};
                };
                c.expected = {{1}};
                c.source = "momentum";
                c.may_lose = 2;
                all.push_back(c);
            }
        }
    }
}

/// [beads] thrown at a wall, all at one speed: they collapse if e is at most
/// tan^2 (pi / 4 (1 - 1 / beads)) (Bernu and Mazighi 1990).
Case beads(int count, double part) {
    const double threshold = std::pow(std::tan(std::numbers::pi / 4 * (1 - 1.0 / count)), 2);
    const double e = threshold * part;
    Case c = named(std::to_string(count) + " beads at a wall, " + number(part) +
                       " of the threshold " + number(threshold),
                   "a row that collapses at low restitution");
    c.scene.impacts.ball_ball.restitution = e;
    c.scene.impacts.ball_cushion.restitution = e;
    c.scene.impacts.rest_speed = 0;  // or whatever is slower than that would be together
    if (part < 1)
        c.only = Simultaneous::sequential;  // what has become too close is one cluster, which parts
    c.scene.segments = {{"wall", {101, 9}, {101, -9}, Side::both}};
    for (int k = 0; k < count; ++k) {
        c.scene.balls.push_back(ball(std::to_string(k), 1, 1, {2.5 * k, 0}, {1, 0}));
    }
    c.read = read_collapse;
    c.expected = {{part < 1 ? 1. : 0.}};
    c.source = "threshold";
    return c;
}

/// Closing speeds of the two gaps of three things in a row: ball 0 and 1, and ball 1 with ball 2 or
/// with a wall. An impact of the one adds to the other, times 1 + e, or half of that for a ball.
struct Closing {
    long double first, second;
    bool wall;
    long double e;

    /// The number of impacts from one of the first gap on; at most [most].
    [[nodiscard]] int count(int most) const {
        Closing c = *this;
        int n = 0;
        for (; n < most; ++n) {
            const bool at_first = n % 2 == 0;
            long double& own = at_first ? c.first : c.second;
            long double& other = at_first ? c.second : c.first;
            if (!(own > 0)) break;
            other += own * (1 + e) * (!at_first && wall ? 1 : 0.5L);
            own *= -e;
        }
        return n;
    }
};

/// Three balls, or two and a wall, at [part] of the restitution below which they can collapse, on
/// the way to it: closing speeds that come again after each cycle, times lambda.
Case three(bool wall, double part) {
    const double threshold = wall ? 3 - 2 * std::sqrt(2.0) : 7 - 4 * std::sqrt(3.0);
    const double e = threshold * part;
    Case c = named(std::string(wall ? "2 balls and a wall, " : "3 balls, ") + number(part) +
                       " of the threshold " + number(threshold),
                   "the fewest that can collapse");
    const long double h = (1 + static_cast<long double>(e)) / 2, g = wall ? 2 * h : h;
    const long double half = (g * h - 2 * static_cast<long double>(e)) / 2;
    const long double root =
        half * half - static_cast<long double>(e) * static_cast<long double>(e);
    const long double lambda = half + (root > 0 ? std::sqrt(root) : 0.0L);
    const Closing closing{1, (lambda + static_cast<long double>(e) - g * h) / g, wall,
                          static_cast<long double>(e)};
    const auto v1 = static_cast<double>(closing.second);  // ball 1 against what is behind it
    c.scene.impacts.ball_ball.restitution = e;
    c.scene.impacts.ball_cushion.restitution = e;
    c.scene.impacts.rest_speed = 0;
    if (part < 1) c.only = Simultaneous::sequential;
    c.scene.balls = {ball("0", 1, 1, {-2, 0}, {1 + v1, 0}), ball("1", 1, 1, {0, 0}, {v1, 0})};
    if (wall) {
        c.scene.segments = {{"wall", {1.5, 9}, {1.5, -9}, Side::both}};
    } else {
        c.scene.balls.push_back(ball("2", 1, 1, {2.5, 0}));
    }
    if (part < 1) {
        c.read = read_collapse;
        c.expected = {{1}};
    } else {
        c.read = read_count;
        c.expected = {{static_cast<double>(closing.count(1000))}};
    }
    c.source = "threshold";
    return c;
}

void add_gases(Catalogue& all) {
    for (const double e : {0.1, 0.5, 0.9}) {
        Case c = named("cooling gas of 36, e = " + number(e), "a gas that clusters and collapses");
        add_box(c.scene, 0, 0, 18, 18);
        c.scene.impacts.ball_ball.restitution = e;
        c.scene.impacts.ball_cushion.restitution = e;
        for (int k = 0; k < 36; ++k) {
            const double turn = 2.399963229728653 * k;  // the golden angle
            c.scene.balls.push_back(ball(std::to_string(k), 1, 1,
                                         {1.5 + 3.0 * (k % 6), 1.5 + 3.0 * (k / 6)},
                                         {std::cos(turn), std::sin(turn)}));
        }
        c.scene.limits = {1e6, 1'000'000};
        c.most_events = 200'000;
        c.status_only = true;
        c.about = 20'000;
        all.push_back(c);
    }
}

/// A ball bounces between a wall and one that rolls towards it and slows down.
Case slowing(double e) {
    Case c = named("between a wall and a slowing ball, e = " + number(e),
                   "bounces accumulate as the other one slows down");
    c.scene.motion = RollingMotion{0.01};
    c.scene.impacts.ball_ball.restitution = e;
    c.scene.impacts.ball_cushion.restitution = e;
    c.scene.segments = {{"wall", {0, 9}, {0, -9}, Side::left}};
    c.scene.balls = {ball("light", 1, 0.1, {0.3, 0}), ball("heavy", 1000, 0.1, {1, 0}, {-0.5, 0})};
    c.statuses = {Status::at_rest, Status::zeno};
    c.status_only = true;
    return c;
}

}  // namespace

void add_collapses(Catalogue& all) {
    add_rows(all);
    for (const int count : {4, 6, 10, 15}) {
        all.push_back(beads(count, 0.93));
        all.push_back(beads(count, 1.07));
    }
    for (const bool wall : {false, true}) {
        for (const double part : {0.5, 0.99, 1.01, 1.5}) all.push_back(three(wall, part));
    }
    add_gases(all);
    for (const double e : {0.0, 0.5, 1.0}) all.push_back(slowing(e));
}

}  // namespace osculo::bench::stability

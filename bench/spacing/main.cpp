// Balls that all but touch: what comes out as the gap between them goes to zero, with the balls
// named in random orders, under both laws for contacts at one instant. (The order of names is what
// decides between contacts of one instant; where a ball stands in a scene's list never does.)
//
//     bench_spacing [--orders N] [--seed N] [CSV [MARKDOWN]]      default: 100 orders of seed 1
//
// For each scene, gap and law: how far the final velocities are from those that the law `symmetric`
// gives at the gap 0 (of the order nearest to them and of the one furthest away), how far two
// orders are apart, and how many outcomes there are. Differences of velocities are the largest of
// any ball, in units of the speed of the one that comes. Exit code 1 if the symmetric law depends
// on the order, or if the outcome at the gap 0 is not what it should be.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "osculo/simulate.hpp"
#include "scenes.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench::spacing;

using Velocities = std::vector<Point>;
using Order = std::vector<std::size_t>;

/// Outcomes that differ by less are one.
constexpr double kSame = 1e-9;

constexpr std::pair<const char*, Simultaneous> kLaws[] = {{"sequential", Simultaneous::sequential},
                                                          {"symmetric", Simultaneous::symmetric}};

struct Outcome {
    Velocities velocities;  ///< in the order of Spaced::make
    std::uint64_t events = 0;
};

/// Of one scene with one gap under one law.
struct Row {
    const char* scene;
    const char* law;
    double gap;
    double nearest = 0;   ///< to what is symmetric at the gap 0, of all orders
    double furthest = 0;  ///< from it
    double spread = 0;    ///< between any two orders
    std::size_t outcomes = 0;
    std::uint64_t least_events = 0;
    std::uint64_t most_events = 0;
};

double distance(const Velocities& a, const Velocities& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::hypot(a[i].x - b[i].x, a[i].y - b[i].y));
    }
    return most;
}

/// Of the balls: as they stand, backwards, and at random (the same for the same seed everywhere).
std::vector<Order> orders_of(std::size_t balls, std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Order order(balls);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Order> all{order, Order(order.rbegin(), order.rend())};
    while (all.size() < count) {
        for (std::size_t k = balls; k > 1; --k) std::swap(order[k - 1], order[random() % k]);
        all.push_back(order);
    }
    return all;
}

Outcome play(const Scene& scene, const Order& order) {
    Scene shuffled = scene;
    for (std::size_t k = 0; k < order.size(); ++k) {
        Ball& ball = shuffled.balls[k];
        ball = scene.balls[order[k]];
        ball.id = std::to_string(100 + k);
    }
    const Run run = simulate(shuffled, {.record = Record::none});
    if (run.status != Status::time_limit && run.status != Status::at_rest) {
        std::fprintf(stderr, "a run ended with %s\n", std::string(to_string(run.status)).c_str());
        std::exit(1);
    }
    Outcome outcome{Velocities(order.size()), run.event_count};
    for (std::size_t k = 0; k < order.size(); ++k) {
        outcome.velocities[order[k]] = run.balls[k].state.velocity;
    }
    return outcome;
}

Row compare(Row row, const std::vector<Outcome>& all, const Velocities& reference) {
    row.nearest = INFINITY;
    row.least_events = all.front().events;
    std::vector<const Velocities*> different;
    for (const Outcome& outcome : all) {
        const double off = distance(outcome.velocities, reference);
        row.nearest = std::min(row.nearest, off);
        row.furthest = std::max(row.furthest, off);
        row.least_events = std::min(row.least_events, outcome.events);
        row.most_events = std::max(row.most_events, outcome.events);
        bool is_new = true;
        for (const Outcome& other : all) {
            row.spread = std::max(row.spread, distance(outcome.velocities, other.velocities));
        }
        for (const Velocities* known : different) {
            if (distance(outcome.velocities, *known) < kSame) is_new = false;
        }
        if (is_new) different.push_back(&outcome.velocities);
    }
    row.outcomes = different.size();
    return row;
}

/// Growing, from 0.
std::vector<double> gaps() {
    std::vector<double> all{0};
    for (int k = -15; k <= -2; ++k)
        all.push_back(std::strtod(("1e" + std::to_string(k)).c_str(), nullptr));
    return all;
}

bool sound(const Row& row, const Spaced& scene) {
    const bool symmetric = std::strcmp(row.law, "symmetric") == 0;
    const bool one_outcome = (!symmetric && !scene.well_posed) || row.spread < kSame;
    const bool as_expected = scene.expected.empty() || row.gap != 0 ||
                             !(symmetric || scene.well_posed) || row.furthest < kSame;
    if (one_outcome && as_expected) return true;
    std::printf("WRONG: %s, %s, gap %g: %.1e from what is expected, orders %.1e apart\n", row.scene,
                row.law, row.gap, row.furthest, row.spread);
    return false;
}

void write_csv(std::FILE* file, const std::vector<Row>& rows) {
    std::fputs(
        "scene,simultaneous,gap_radii,nearest,furthest,spread,outcomes,least_events,most_events\n",
        file);
    for (const Row& row : rows) {
        std::fprintf(file, "\"%s\",%s,%g,%.2e,%.2e,%.2e,%zu,%llu,%llu\n", row.scene, row.law,
                     row.gap, row.nearest, row.furthest, row.spread, row.outcomes,
                     static_cast<unsigned long long>(row.least_events),
                     static_cast<unsigned long long>(row.most_events));
    }
}

/// With one decimal, below rounding no more than that.
std::string shortly(double x) {
    if (x > 0 && x < 1e-15) return "< 1e-15";
    char text[20];
    std::snprintf(text, sizeof text, x > 0.001 ? "%.3f" : x > 0 ? "%.1e" : "0", x);
    return text;
}

/// The two laws side by side; not every gap.
void write_markdown(std::FILE* file, const std::vector<Row>& rows) {
    std::fputs(
        "| scene | gap | sequential: off | orders apart | outcomes | symmetric: off | orders apart "
        "|\n|---|---|---|---|---|---|---|\n",
        file);
    for (std::size_t k = 0; k < rows.size(); k += std::size(kLaws)) {
        const Row &one = rows[k], &other = rows[k + 1];
        const double shown[] = {0, 1e-15, 1e-13, 1e-12, 1e-6, 1e-2};
        if (std::find(std::begin(shown), std::end(shown), one.gap) == std::end(shown)) continue;
        std::fprintf(file, "| %s | %g | %s | %s | %zu | %s | %s |\n", one.scene, one.gap,
                     shortly(one.furthest).c_str(), shortly(one.spread).c_str(), one.outcomes,
                     shortly(other.furthest).c_str(), shortly(other.spread).c_str());
    }
}

struct Settings {
    std::size_t orders = 100;
    std::uint64_t seed = 1;
    std::vector<const char*> paths;
};

/// False if the words make no sense.
bool read_arguments(int argc, char** argv, Settings& settings) {
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (std::strcmp(argv[i], "--orders") == 0 && more) {
            settings.orders = std::strtoull(argv[++i], nullptr, 10);
        } else if (std::strcmp(argv[i], "--seed") == 0 && more) {
            settings.seed = std::strtoull(argv[++i], nullptr, 10);
        } else if (argv[i][0] == '-') {
            return false;
        } else {
            settings.paths.push_back(argv[i]);
        }
    }
    return settings.paths.size() <= 2;
}

/// All gaps and laws, that is kLaws in turn for each gap.
void play_all(const Spaced& spaced, const Settings& settings, std::vector<Row>& rows) {
    Velocities reference = spaced.expected;
    if (reference.empty()) {
        const Scene scene = spaced.make(0);
        const auto orders = orders_of(scene.balls.size(), 1, settings.seed);
        reference = play(scene, orders.front()).velocities;
    }
    for (const double gap : gaps()) {
        Scene scene = spaced.make(gap);
        const auto orders = orders_of(scene.balls.size(), settings.orders, settings.seed);
        for (const auto& [name, law] : kLaws) {
            scene.impacts.simultaneous = law;
            std::vector<Outcome> all;
            for (const Order& order : orders) all.push_back(play(scene, order));
            rows.push_back(compare({spaced.name, name, gap}, all, reference));
        }
    }
}

bool write(const char* path, void (*writer)(std::FILE*, const std::vector<Row>&),
           const std::vector<Row>& rows) {
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", path);
        return false;
    }
    writer(file, rows);
    return std::fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    if (!read_arguments(argc, argv, settings)) {
        std::fputs("usage: bench_spacing [--orders N] [--seed N] [CSV [MARKDOWN]]\n", stderr);
        return 2;
    }
    std::vector<Row> rows;
    int wrong = 0;
    for (const Spaced& spaced : scenes()) {
        const std::size_t first = rows.size();
        play_all(spaced, settings, rows);
        for (std::size_t k = first; k < rows.size(); ++k) wrong += !sound(rows[k], spaced);
    }
    if (settings.paths.empty()) write_markdown(stdout, rows);
    bool written = true;
    if (!settings.paths.empty()) written = write(settings.paths[0], write_csv, rows);
    if (settings.paths.size() > 1) {
        written = write(settings.paths[1], write_markdown, rows) && written;
    }
    if (!written) return 2;
    return wrong == 0 ? 0 : 1;
}

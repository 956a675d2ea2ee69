// How errors grow, event by event, in every precision: the digits of places that are left.
//
//     bench_error_growth [--quick] [CSV]
//
// Every scene comes in seeded variants; medians of what is right, as long as that is half of them.
// A run is right as long as every ball meets what it meets in
// the run with 100 digits, in the same order. The error at an event is that of the places of its
// balls, over the radius; pieces hold places to 32 digits, which is where the curves of the wider
// types begin.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <numbers>

#include "osculo/presets.hpp"
#include "play.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench::stability;

constexpr double kFloor = 1e-32;

struct Workload {
    const char* name;
    int variants;
    std::uint64_t events;
    Scene (*make)(std::uint64_t seed);
};

Scene gas(std::uint64_t seed) {
    return presets::make("gas", {.balls = 16, .seed = seed});
}

/// Sixteen balls, of which the one that comes is a little beside the axis, by the seed.
Scene frictionless(std::uint64_t seed) {
    Scene scene = presets::make("frictionless-break", {});
    scene.balls.front().position.x += 1e-4 * static_cast<double>(seed);
    scene.limits.time = 1e6;
    return scene;
}

Scene cloth(std::uint64_t seed) {
    return presets::make("break", {.speed = 6, .seed = seed});
}

/// One ball in a circle: no chaos.
Scene circle(std::uint64_t seed) {
    Scene scene;
    scene.arcs = {{"circle", {0, 0}, 10, 0, 2 * std::numbers::pi}};
    const double angle = 0.3 + 0.05 * static_cast<double>(seed);
    scene.balls = {ball("ball", 1, 1, {4, 0}, {std::cos(angle), std::sin(angle)})};
    scene.limits.time = 1e9;
    return scene;
}

constexpr Workload kWorkloads[] = {
    {"16 disks", 20, 700, gas},
    {"break without friction", 20, 500, frictionless},
    {"break on cloth", 20, 1000, cloth},
    {"one ball in a circle", 20, 700, circle},
};

/// Where every ball begins each of its pieces, in double-double.
std::vector<std::vector<const Piece*>> pieces_of(const Run& run) {
    std::vector<std::vector<const Piece*>> all(run.balls.size());
    for (const Piece& piece : run.pieces) all[piece.ball].push_back(&piece);
    return all;
}

double distance(const Piece& a, const Piece& b) {
    return std::hypot((a.position.x - b.position.x) + (a.position_low.x - b.position_low.x),
                      (a.position.y - b.position.y) + (a.position_low.y - b.position_low.y));
}

bool same(const Event& a, const Event& b) {
    return a.kind == b.kind && a.ball == b.ball && a.other == b.other;
}

/// Error at each event up to the first one that is another one, in radii.
std::vector<double> errors(const Run& run, const Run& reference) {
    const auto mine = pieces_of(run), theirs = pieces_of(reference);
    std::vector<std::size_t> count(run.balls.size(), 0);
    std::vector<double> all;
    for (std::size_t k = 0; k < std::min(run.events.size(), reference.events.size()); ++k) {
        const Event& event = run.events[k];
        if (!same(event, reference.events[k])) break;
        if (event.kind == EventKind::capture) {  // nothing begins
            if (!all.empty()) all.push_back(all.back());
            continue;
        }
        double worst = kFloor;
        bool begins = true;  // a ball that the run ends with has no piece after the event
        const auto look_at = [&](std::uint32_t i) {
            const std::size_t piece = ++count[i];
            begins = begins && piece < mine[i].size() && piece < theirs[i].size();
            if (!begins) return;
            worst = std::max(
                worst, distance(*mine[i][piece], *theirs[i][piece]) / run.scene.balls[i].radius);
        };
        look_at(event.ball);
        if (event.kind == EventKind::ball_ball) look_at(event.other);
        if (!begins) break;
        all.push_back(worst);
    }
    return all;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Slope of the straight line through the logarithms of what is well above the floor: digits per
/// event. NaN if that is too little.
double slope(const std::vector<double>& errors) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        if (errors[k] < 100 * kFloor) continue;
        const auto event = static_cast<double>(k);
        const double digits = std::log10(errors[k]);
        n += 1, x += event, y += digits, xx += event * event, xy += event * digits;
    }
    return n < 20 || errors.back() < 1e5 * kFloor ? NAN : (n * xy - x * y) / (n * xx - x * x);
}

/// Median errors by event, as long as half of the variants are right.
void report(std::FILE* file, const Workload& workload, Precision precision,
            const std::vector<std::vector<double>>& runs) {
    const std::size_t half = (runs.size() + 1) / 2;
    std::vector<double> medians;
    for (;;) {
        std::vector<double> at;
        for (const auto& run : runs) {
            if (medians.size() < run.size()) at.push_back(run[medians.size()]);
        }
        if (at.size() < half) break;
        medians.push_back(median(at));
        if (file != nullptr) {
            std::fprintf(file, "%s,%s,%zu,%.3e,%zu\n", workload.name,
                         std::string(to_string(precision)).c_str(), medians.size(), medians.back(),
                         at.size());
        }
    }
    std::printf("%-24s %-9s %4zu events, error %.0e radii, ", workload.name,
                std::string(to_string(precision)).c_str(), medians.size(),
                medians.empty() ? 0 : medians.back());
    const double lost = slope(medians);
    if (std::isnan(lost)) {
        std::puts("too near the last digit written to tell more");
    } else {
        std::printf("%.3f digits lost per event\n", lost);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    bool quick = false;
    const char* path = nullptr;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0) {
            quick = true;
        } else {
            path = argv[i];
        }
    }
    std::FILE* file = path == nullptr ? nullptr : std::fopen(path, "w");
    if (path != nullptr && file == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", path);
        return 2;
    }
    if (file != nullptr) std::fputs("scene,precision,event,error_radii,runs\n", file);
    for (const Workload& workload : kWorkloads) {
        std::map<Precision, std::vector<std::vector<double>>> all;
        const int variants = quick ? 3 : workload.variants;
        for (int seed = 1; seed <= variants; ++seed) {
            Scene scene = workload.make(static_cast<std::uint64_t>(seed));
            scene.limits.events = quick ? 100 : workload.events;
            const Run reference = simulate(scene, {.precision = Precision::digits100});
            for (const Precision precision : kPrecisions) {
                if (precision == Precision::digits100) continue;
                all[precision].push_back(
                    errors(simulate(scene, {.precision = precision}), reference));
            }
        }
        for (const auto& [precision, runs] : all) report(file, workload, precision, runs);
    }
    if (file != nullptr && std::fclose(file) != 0) return 2;
    return 0;
}

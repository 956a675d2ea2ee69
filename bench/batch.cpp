// Batches of shots on a pool table, outcomes only: shots per second, how many cores that takes, and
// memory; or a fixed amount of work for tools that count instructions:
//
//     bench_batch                      the table of figures
//     bench_batch KIND SHOTS           plays that many shots on one thread
//
// A kind is break (strikes of 6 to 10 m/s into a rack of eight-ball) or balls-15 (strikes of 1 to
// 8 m/s, each from another layout of the cue ball and 14 others, as starts).

#include "osculo/batch.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "osculo/presets.hpp"
#include "presets/place_disks.hpp"
#include "presets/tables.hpp"

namespace {

using namespace osculo;
using presets::uniform;

constexpr presets::Bed kBed = presets::kPool9ft;
constexpr double kRadius = presets::kPoolBallRadius;

Scene table() {
    Scene scene;
    presets::add_table(scene, "pool-9ft");
    presets::set_table_laws(scene, "pool-9ft");
    presets::add_rack(scene, "eight-ball");
    return scene;
}

/// A little different from each other, so that no shot is the mean of all.
std::vector<Strike> breaks(std::size_t count, std::mt19937_64& random) {
    std::vector<Strike> strikes(count);
    for (Strike& strike : strikes) {
        strike.speed = 6 + 4 * uniform(random);
        strike.azimuth = std::numbers::pi / 2 + 0.01 * (uniform(random) - 0.5);
        strike.side = 0.2 * (uniform(random) - 0.5);
        strike.height = 0.2 * (uniform(random) - 0.5);
    }
    return strikes;
}

/// One after another, [shot][ball]: the cue ball moves at random, the 8-ball is not there.
struct MidGame {
    std::vector<BallState> states;
    std::vector<std::uint8_t> present;
};
MidGame mid_game(const Scene& scene, std::size_t count, std::mt19937_64& random) {
    MidGame shots;
    const double room = kBed.width - 2.2 * kRadius;
    for (std::size_t shot = 0; shot < count; ++shot) {
        const auto places = presets::place_disks(15, kRadius / room, random);
        const Point direction = presets::random_direction(random);
        const double speed = 1 + 5 * uniform(random);
        std::size_t next = 0;
        for (const Ball& ball : scene.balls) {
            const bool is_there = ball.id != "8";
            shots.present.push_back(is_there ? 1 : 0);
            shots.states.emplace_back();
            if (!is_there) continue;
            const Point& place = places[next++];
            shots.states.back().position = {
                1.1 * kRadius + place.x * room,
                1.1 * kRadius + place.y * (kBed.length - 2.2 * kRadius)};
            if (ball.id == "cue") {
                shots.states.back().velocity = {speed * direction.x, speed * direction.y};
            }
        }
    }
    return shots;
}

/// Processor time of all threads and time of the clock on the wall [s].
struct Times {
    double processor = 0;
    double wall = 0;
};

template <class Shots>
Times play(const Scene& scene, const Shots& shots, unsigned threads, BatchResult& result) {
    Batch batch(scene, {.threads = threads});
    batch.run(shots, result);
    Times best{1e300, 1e300};
    for (int repetition = 0; repetition < 5; ++repetition) {
        const auto clock = std::clock();
        const auto start = std::chrono::steady_clock::now();
        batch.run(shots, result);
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        best.wall = std::min(best.wall, wall.count());
        best.processor =
            std::min(best.processor, static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
    }
    return best;
}

template <class Shots>
void report(const char* kind, const Scene& scene, const Shots& shots) {
    for (const unsigned threads : {1U, 2U}) {
        BatchResult result;
        const Times times = play(scene, shots, threads, result);
        std::uint64_t events = 0;
        std::size_t at_rest = 0;
        for (std::size_t i = 0; i < result.shots; ++i) {
            events += result.event_count[i];
            at_rest += result.status[i] == ShotStatus::at_rest;
        }
        const auto count = static_cast<double>(result.shots);
        std::printf(
            "%-8s %u threads %9.0f shots/s %9.0f shots/s and core %7.1f us/shot %6.1f events/shot "
            "%zu of %zu at rest\n",
            kind, threads, count / times.wall, count / times.processor,
            1e6 * times.processor / count, static_cast<double>(events) / count, at_rest,
            result.shots);
    }
}

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

}  // namespace

int main(int argc, char** argv) {
    const Scene scene = table();
    std::mt19937_64 random(1);
    const std::string kind = argc > 2 ? argv[1] : "";
    const std::size_t count = argc > 2 ? static_cast<std::size_t>(std::atol(argv[2])) : 4000;
    if (argc > 2) {
        BatchResult result;
        if (kind == "break") {
            Batch(scene, {.threads = 1}).run(breaks(count, random), result);
        } else {
            const MidGame shots = mid_game(scene, count, random);
            Batch(scene, {.threads = 1}).run(Starts{shots.states, shots.present}, result);
        }
        return 0;
    }
    report("break", scene, std::span<const Strike>(breaks(count, random)));
    const MidGame shots = mid_game(scene, count, random);
    report("balls-15", scene, Starts{shots.states, shots.present});

    const std::size_t many = 100000;
    const auto strikes = breaks(many, random);
    const long before = peak_memory();
    BatchResult result;
    Batch(scene, {.limits = Limits{0.01, 1000}, .threads = 2})
        .run(std::span<const Strike>(strikes), result);
    std::printf("memory of %zu outcomes: %.0f bytes per shot of %zu balls\n", many,
                1024.0 * static_cast<double>(peak_memory() - before) / static_cast<double>(many),
                result.balls);
    return 0;
}

// Shots on a pool table, nothing recorded: time and events per shot and per event, or a fixed
// amount of work for tools that count instructions:
//
//     bench_shots                      the table of figures
//     bench_shots KIND SHOTS           plays that many shots and prints the events and a hash of
//                                      every bit of where the balls end up
//
// A kind is break-4.5, break-10 (speed of the cue ball [m/s]), balls-5, -10, -15 (random mid-game
// positions, 1 to 6 m/s, random direction) or cut (two balls, the second hit at a random angle).

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "compile_scene.hpp"
#include "osculo/presets.hpp"
#include "presets/place_disks.hpp"
#include "presets/tables.hpp"

namespace {

using namespace osculo;
using presets::uniform;

using Type = engine::ClothScene<double, impact::CushionHan2005, engine::NoRecorder>;

constexpr presets::Bed kBed = presets::kPool9ft;
constexpr double kRadius = presets::kPoolBallRadius;

Scene bare_table() {
    Scene scene;
    presets::add_table(scene, "pool-9ft");
    presets::set_table_laws(scene, "pool-9ft");
    return scene;
}

void add_ball(Scene& scene, const char* id, Point position, Point velocity) {
    Ball ball;
    ball.id = id;
    ball.mass = presets::kPoolBallMass;
    ball.radius = kRadius;
    ball.position = position;
    ball.velocity = velocity;
    scene.balls.push_back(ball);
}

// The speeds and places differ a little from shot to shot, so that no shot is the mean of all.
Scene break_shot(double speed, std::mt19937_64& random) {
    Scene scene = bare_table();
    add_ball(
        scene, "cue",
        {kBed.width / 2 + 0.004 * (uniform(random) - 0.5), kBed.length / 4 - 0.1 * uniform(random)},
        {0, speed});
    presets::add_rack(scene, "eight-ball");
    return scene;
}

Scene mid_game(std::uint32_t balls, std::mt19937_64& random) {
    Scene scene = bare_table();
    // On the unit square, stretched to the bed: apart there, farther apart here.
    const double room = kBed.width - 2.2 * kRadius;
    const auto places = presets::place_disks(balls, kRadius / room, random);
    const Point direction = presets::random_direction(random);
    const double speed = 1 + 5 * uniform(random);
    const std::size_t cue = random() % balls;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Point position{1.1 * kRadius + places[i].x * room,
                             1.1 * kRadius + places[i].y * (kBed.length - 2.2 * kRadius)};
        const bool moves = i == cue;
        add_ball(scene, ("b" + std::to_string(i)).c_str(), position,
                 moves ? Point{speed * direction.x, speed * direction.y} : Point{});
    }
    return scene;
}

Scene cut_shot(std::mt19937_64& random) {
    Scene scene = bare_table();
    const Point object{kBed.width / 2, 1.2};
    const double aside = 1.9 * kRadius * (2 * uniform(random) - 1);
    const double speed = 1 + 3 * uniform(random);
    add_ball(scene, "cue", {object.x + aside, 0.5}, {0, speed});
    add_ball(scene, "object", object, {});
    return scene;
}

struct Work {
    std::string name;
    std::function<Scene(std::mt19937_64&)> make;
};

const std::vector<Work>& kinds() {
    static const std::vector<Work> all{
        {"break-4.5", [](auto& random) { return break_shot(4.5, random); }},
        {"break-10", [](auto& random) { return break_shot(10, random); }},
        {"balls-15", [](auto& random) { return mid_game(15, random); }},
        {"balls-10", [](auto& random) { return mid_game(10, random); }},
        {"balls-5", [](auto& random) { return mid_game(5, random); }},
        {"cut", [](auto& random) { return cut_shot(random); }},
    };
    return all;
}

constexpr std::size_t kShots = 200;

std::vector<engine::SceneData<Type>> compile(const Work& work, std::size_t count) {
    std::mt19937_64 random(1);
    std::vector<engine::SceneData<Type>> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(facade::compile_scene<Type>(work.make(random)).data);
    }
    return result;
}

struct Played {
    std::uint64_t events = 0;
    std::uint64_t predictions = 0;
    std::size_t not_at_rest = 0;
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a

    void add_bits(double x) {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        for (int shift = 0; shift < 64; shift += 8) {
            hash = (hash ^ ((bits >> shift) & 0xFFU)) * 1099511628211U;
        }
    }
};

/// All of them on one engine: what is known of the table is computed once.
Played play(engine::Engine<Type>& engine, const std::vector<engine::SceneData<Type>>& shots,
            std::size_t count) {
    Played sum;
    for (std::size_t i = 0; i < count; ++i) {
        engine.restart(shots[i].bodies);
        const Status status = engine.run({600, 1'000'000});
        sum.events += engine.event_count();
        sum.predictions += engine.prediction_count();
        sum.not_at_rest += status != Status::at_rest;
        for (const auto& body : engine.bodies()) {
            sum.add_bits(body.state.position.x.hi);
            sum.add_bits(body.state.position.y.lo);
            sum.add_bits(body.state.spin.z());
        }
    }
    return sum;
}

}  // namespace

int main(int argc, char** argv) {
    for (const Work& work : kinds()) {
        if (argc > 1 && work.name != argv[1]) continue;
        const std::size_t count = argc > 2 ? static_cast<std::size_t>(std::atol(argv[2])) : kShots;
        const auto shots = compile(work, std::max(count, kShots));
        engine::Engine<Type> engine(shots.front());
        if (argc > 2) {
            const Played sum = play(engine, shots, count);  // always the same shots are set up
            std::printf("%llu events, hash %016llx\n", static_cast<unsigned long long>(sum.events),
                        static_cast<unsigned long long>(sum.hash));
            return 0;
        }
        double best = 1e300;
        Played sum;
        for (int repetition = 0; repetition < 5; ++repetition) {
            const auto start = std::clock();
            sum = play(engine, shots, kShots);
            best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        }
        const auto events = static_cast<double>(sum.events);
        std::printf(
            "%-10s %6.1f events/shot %5.2f predictions/event %8.2f us/shot %6.3f us/event %zu "
            "unfinished\n",
            work.name.c_str(), events / kShots, static_cast<double>(sum.predictions) / events,
            1e6 * best / kShots, 1e6 * best / events, sum.not_at_rest);
    }
    return 0;
}

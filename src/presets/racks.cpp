#include "presets/racks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "presets/nearest_name.hpp"
#include "presets/parameters.hpp"
#include "presets/place_disks.hpp"

namespace osculo::presets {
namespace {

struct Rack {
    std::string_view name;
    Game game;
    double ball_radius;
    bool has_neighbours;
    void (*add)(Scene&, const Bed&, const RackOptions&);
};

constexpr std::array kRacks{
    Rack{"eight-ball", Game::pool, kPoolBallRadius, true, add_eight_ball},
    Rack{"nine-ball", Game::pool, kPoolBallRadius, true, add_nine_ball},
    Rack{"snooker", Game::snooker, kSnookerBallRadius, true, add_snooker},
    Rack{"three-cushion", Game::carom, kCaromBallRadius, false, add_three_cushion},
};

const char* name_of(Game game) {
    switch (game) {
        case Game::pool: return "pool";
        case Game::snooker: return "snooker";
        case Game::carom: return "carom";
    }
    return "";
}

}  // namespace

Racker::Racker(Scene& scene, const Bed& bed, double mass, double radius, const RackOptions& options)
    : scene_(scene), bed_(bed), mass_(mass), radius_(radius), gap_(options.gap) {
    if (options.seed) random_.emplace(*options.seed);
}

double Racker::row_height() const {
    return spacing() * std::sqrt(0.75);
}

void Racker::add(const std::string& id, Point place) {
    Ball ball;
    ball.id = id;
    ball.mass = mass_;
    ball.radius = radius_;
    ball.position = place;
    scene_.balls.push_back(ball);
}

void Racker::add_shaken(const std::string& id, Point place) {
    if (random_) {
        // A thousandth less than there is, so that rounding never makes neighbours overlap.
        const Point shake = random_in_disk(*random_);
        place.x += 0.999 * gap_ / 2 * shake.x;
        place.y += 0.999 * gap_ / 2 * shake.y;
    }
    add(id, place);
}

void Racker::add_cue(Point place) {
    const bool has_one = std::ranges::find(scene_.balls, "cue", &Ball::id) != scene_.balls.end();
    if (!has_one) add("cue", place);
}

void add_rack(Scene& scene, std::string_view name, const RackOptions& options) {
    const std::string quoted = '"' + std::string(name) + '"';
    const auto rack = std::ranges::find(kRacks, name, &Rack::name);
    if (rack == kRacks.end()) {
        std::array<std::string_view, kRacks.size()> names;
        std::ranges::transform(kRacks, names.begin(), &Rack::name);
        throw SceneError(
            "rack", "must be " + listed(names, " or ", "\"") + did_you_mean(name, names), quoted);
    }
    const Table* const table = table_of(scene);
    if (table == nullptr || table->game != rack->game) {
        throw SceneError(
            "rack", std::string("needs a ") + name_of(rack->game) + " table to stand on",
            quoted + (table == nullptr ? " without one" : " on " + std::string(table->name)));
    }
    if (!rack->has_neighbours && options != RackOptions{}) {
        throw SceneError("rack", "must have neighbours to take a gap or a seed", quoted);
    }
    // Beyond one radius the triangle of the 7 ft table would reach its foot cushion.
    if (!(options.gap >= 0 && options.gap <= rack->ball_radius)) {
        throw SceneError("rack.gap", "must be from 0 to " + number_text(rack->ball_radius),
                         number_text(options.gap));
    }
    rack->add(scene, table->bed, options);
}

}  // namespace osculo::presets

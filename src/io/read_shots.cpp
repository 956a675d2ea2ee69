#include <algorithm>

#include "io/read.hpp"
#include "osculo/io.hpp"
#include "osculo/shots.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

constexpr std::string_view kShotsSchema = "osculo/shots-1";

Strike read_strike(const Value& value) {
    static constexpr Names kKeys{"speed", "azimuth", "elevation", "offset"};
    const Fields fields(value, kKeys);
    Strike strike;
    strike.speed = fields.require("speed").number();
    strike.azimuth = fields.require("azimuth").number();
    if (const auto elevation = fields.find("elevation")) strike.elevation = elevation->number();
    if (const auto offset = fields.find("offset")) {
        const Point ab = offset->point();
        strike.side = ab.x;
        strike.height = ab.y;
    }
    return strike;
}

Start read_start(const Value& value, const Scene& scene) {
    static constexpr Names kKeys{"balls"};
    static constexpr Names kBallKeys{"id", "position", "velocity", "spin"};
    const Fields fields(value, kKeys);
    Start start;
    start.states.resize(scene.balls.size());
    start.present.resize(scene.balls.size());
    fields.require("balls").for_each([&](const Value& element) {
        const Fields ball(element, kBallKeys);
        const Value id = ball.require("id");
        const auto found = std::ranges::find(scene.balls, id.text(), &Ball::id);
        if (found == scene.balls.end()) id.fail("must be the id of a ball of the scene");
        const auto index = static_cast<std::size_t>(found - scene.balls.begin());
        if (start.present[index] != 0) id.fail("must be given once", "given twice");
        start.present[index] = 1;
        start.states[index].position = ball.require("position").point();
        if (const auto velocity = ball.find("velocity")) {
            start.states[index].velocity = velocity->point();
        }
        if (const auto spin = ball.find("spin")) start.states[index].spin = read_spin(*spin);
    });
    return start;
}

}  // namespace

Shot shot_from_json(std::string_view line, const Scene& scene) {
    const Document document = parse_json(line);
    const Value value(document, "shot");
    if (value.member("balls")) return read_start(value, scene);
    return read_strike(value);
}

bool is_shots_header(std::string_view line) {
    static constexpr Names kSchemas{kShotsSchema};
    static constexpr Names kKeys{"schema"};
    const Document document = parse_json(line);
    const Value value(document, "header");
    const auto schema = value.member("schema");
    if (!schema) return false;
    choice(*schema, kSchemas);
    const Fields only(value, kKeys);
    return true;
}

}  // namespace osculo::io

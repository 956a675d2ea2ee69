#include "io/read.hpp"
#include "io/read_laws.hpp"
#include "osculo/presets.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

Ball read_ball(const Value& value) {
    static constexpr Names kKeys{"id", "mass", "radius", "position", "velocity", "spin", "inertia"};
    const Fields fields(value, kKeys);
    Ball ball;
    ball.id = fields.require("id").text();
    ball.mass = fields.require("mass").number();
    ball.radius = fields.require("radius").number();
    ball.position = fields.require("position").point();
    if (const auto velocity = fields.find("velocity")) ball.velocity = velocity->point();
    if (const auto spin = fields.find("spin")) ball.spin = read_spin(*spin);
    if (const auto inertia = fields.find("inertia")) ball.inertia = inertia->number();
    return ball;
}

Segment read_segment(const Value& value) {
    static constexpr Names kSides{"left", "both"};
    static constexpr Names kKeys{"id", "from", "to", "side"};
    const Fields fields(value, kKeys);
    Segment segment;
    segment.id = fields.require("id").text();
    segment.from = fields.require("from").point();
    segment.to = fields.require("to").point();
    if (const auto side = fields.find("side")) {
        segment.side = choice(*side, kSides) == 0 ? Side::left : Side::both;
    }
    return segment;
}

Arc read_arc(const Value& value) {
    static constexpr Names kKeys{"id", "center", "radius", "from_angle", "to_angle"};
    const Fields fields(value, kKeys);
    Arc arc;
    arc.id = fields.require("id").text();
    arc.center = fields.require("center").point();
    arc.radius = fields.require("radius").number();
    // Without angles it is the full circle; one angle alone says too little.
    if (fields.find("from_angle") || fields.find("to_angle")) {
        arc.from_angle = fields.require("from_angle").number();
        arc.to_angle = fields.require("to_angle").number();
    }
    return arc;
}

Rim read_rim(const Value& value) {
    static constexpr RimLaw kRimLaws[]{RimLaw::capture, RimLaw::paper, RimLaw::tipping};
    static constexpr Names kLaws{to_string(kRimLaws[0]), to_string(kRimLaws[1]),
                                 to_string(kRimLaws[2])};
    static constexpr Names kKeys{"id", "center", "radius", "law", "restitution"};
    const Fields fields(value, kKeys);
    Rim rim;
    rim.id = fields.require("id").text();
    rim.center = fields.require("center").point();
    rim.radius = fields.require("radius").number();
    if (const auto law = fields.find("law")) rim.law = kRimLaws[choice(*law, kLaws)];
    if (const auto e = fields.find("restitution")) rim.restitution = e->number();
    return rim;
}

Limits read_limits(const Value& value) {
    static constexpr Names kKeys{"time", "events"};
    const Fields fields(value, kKeys);
    Limits limits;
    if (const auto time = fields.find("time")) limits.time = time->number();
    if (const auto events = fields.find("events")) limits.events = events->natural();
    return limits;
}

void add_rack(Scene& scene, const Value& value) {
    static constexpr Names kKeys{"name", "gap", "seed"};
    if (value.kind() == NodeKind::text) {
        presets::add_rack(scene, value.text());
        return;
    }
    const Fields fields(value, kKeys);
    presets::RackOptions options;
    if (const auto gap = fields.find("gap")) options.gap = gap->number();
    if (const auto seed = fields.find("seed")) options.seed = seed->natural();
    presets::add_rack(scene, fields.require("name").text(), options);
}

template <class Thing>
void append(std::vector<Thing>& things, const std::optional<Value>& value,
            Thing (*read)(const Value&)) {
    if (!value) return;
    things.reserve(things.size() + value->size());
    value->for_each([&](const Value& element) { things.push_back(read(element)); });
}

}  // namespace

Scene read_scene(const Value& value) {
    static constexpr Names kSchemas{kSceneSchema};
    static constexpr Names kKeys{"schema", "motion",   "gravity", "table", "rack",
                                 "balls",  "segments", "arcs",    "rims",  "impacts",
                                 "cue",    "closed",   "limits"};
    // The version comes first: the keys of another one may be unknown to this.
    if (const auto schema = value.member("schema")) choice(*schema, kSchemas);
    const Fields fields(value, kKeys);
    static_cast<void>(fields.require("schema"));

    Scene scene;
    if (const auto table = fields.find("table")) {
        presets::add_table(scene, table->text());
        presets::set_table_laws(scene, table->text());
    }
    if (const auto motion = fields.find("motion")) scene.motion = read_motion(*motion);
    // The impacts of a table have friction, which no other motion law knows.
    if (!std::holds_alternative<ClothMotion>(scene.motion)) scene.impacts = {};
    if (const auto gravity = fields.find("gravity")) scene.gravity = gravity->number();
    // The balls that are listed come first: a rack leaves out a cue ball that is there already.
    append(scene.balls, fields.find("balls"), read_ball);
    if (const auto rack = fields.find("rack")) add_rack(scene, *rack);
    append(scene.segments, fields.find("segments"), read_segment);
    append(scene.arcs, fields.find("arcs"), read_arc);
    append(scene.rims, fields.find("rims"), read_rim);
    if (const auto impacts = fields.find("impacts")) {
        scene.impacts = read_impacts(*impacts, scene.impacts);
    }
    const auto cue = fields.find("cue");
    if (cue) scene.cue = read_cue(*cue);
    if (const auto closed = fields.find("closed")) scene.closed = closed->boolean();
    if (const auto limits = fields.find("limits")) scene.limits = read_limits(*limits);
    // As level as what is in the way of the stick allows.
    if (cue && !cue->member("elevation") && !scene.cue->allow_obstructed) {
        scene.cue->elevation = least_elevation(scene).value_or(0);
    }
    validate(scene);
    return scene;
}

}  // namespace osculo::io

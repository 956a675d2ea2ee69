#include "io/json_text.hpp"
#include "io/members.hpp"
#include "io/read.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

void write_ball(JsonText& json, const Ball& ball) {
    Members members(json);
    members.string("id", ball.id);
    members.number("mass", ball.mass);
    members.number("radius", ball.radius);
    members.vector("position", ball.position);
    members.vector("velocity", ball.velocity);
    members.rare("spin", ball.spin);
    if (ball.inertia != Ball{}.inertia) members.number("inertia", ball.inertia);
    members.close();
}

void write_segment(JsonText& json, const Segment& segment) {
    Members members(json);
    members.string("id", segment.id);
    members.vector("from", segment.from);
    members.vector("to", segment.to);
    members.string("side", segment.side == Side::left ? "left" : "both");
    members.close();
}

void write_arc(JsonText& json, const Arc& arc) {
    Members members(json);
    members.string("id", arc.id);
    members.vector("center", arc.center);
    members.number("radius", arc.radius);
    members.number("from_angle", arc.from_angle);
    members.number("to_angle", arc.to_angle);
    members.close();
}

void write_rim(JsonText& json, const Rim& rim) {
    Members members(json);
    members.string("id", rim.id);
    members.vector("center", rim.center);
    members.number("radius", rim.radius);
    members.string("law", to_string(rim.law));
    if (rim.restitution) members.number("restitution", *rim.restitution);
    members.close();
}

void write_medium(JsonText& json, const Medium& medium) {
    Members members(json);
    members.number("density", medium.density);
    members.number("viscosity", medium.viscosity);
    members.number("drag_coefficient", medium.drag_coefficient);
    members.key("rolling");
    json.boolean(medium.rolling);
    members.close();
}

void write_motion(JsonText& json, const MotionLaw& motion) {
    Members members(json);
    if (const auto* rolling = std::get_if<RollingMotion>(&motion)) {
        members.string("law", "rolling");
        members.number("friction", rolling->friction);
    } else if (const auto* cloth = std::get_if<ClothMotion>(&motion)) {
        members.string("law", "cloth");
        members.number("sliding_friction", cloth->sliding_friction);
        members.number("rolling_friction", cloth->rolling_friction);
        members.number("spinning_friction", cloth->spinning_friction);
    } else if (const auto* resisted = std::get_if<ResistedMotion>(&motion)) {
        members.string("law", "resisted");
        members.number("constant", resisted->constant);
        members.number("linear", resisted->linear);
        members.number("quadratic", resisted->quadratic);
        if (resisted->medium) {
            members.key("medium");
            write_medium(json, *resisted->medium);
        }
    } else {
        members.string("law", "uniform");
    }
    members.close();
}

void write_ball_ball(JsonText& json, const BallBallImpact& impact) {
    const bool frictional = impact.law == BallBallLaw::frictional;
    Members members(json);
    members.string("law", frictional ? "frictional" : "restitution");
    members.number("restitution", impact.restitution);
    if (frictional) members.vector("friction", impact.friction);
    members.close();
}

void write_ball_cushion(JsonText& json, const CushionImpact& impact) {
    Members members(json);
    members.string("law", to_string(impact.law));
    members.number("restitution", impact.restitution);
    if (impact.law != CushionLaw::restitution) {
        members.number("friction", impact.friction);
    }
    if (impact.law != CushionLaw::restitution && impact.law != CushionLaw::frictional) {
        members.number("height", impact.height);
    }
    if (impact.law == CushionLaw::mathavan_2010 && impact.cloth_friction) {
        members.number("cloth_friction", *impact.cloth_friction);
    }
    if (impact.law == CushionLaw::stronge) {
        members.number("frequency_ratio", impact.frequency_ratio);
    }
    members.close();
}

void write_impacts(JsonText& json, const Scene& scene) {
    Members members(json);
    members.key("ball_ball");
    write_ball_ball(json, scene.impacts.ball_ball);
    members.key("ball_cushion");
    write_ball_cushion(json, scene.impacts.ball_cushion);
    members.string("simultaneous", scene.impacts.simultaneous == Simultaneous::symmetric
                                       ? "symmetric"
                                       : "sequential");
    // It means nothing to uniform motion, but what was set is given back.
    if (!std::holds_alternative<UniformMotion>(scene.motion) ||
        scene.impacts.contact_time != Impacts{}.contact_time) {
        members.number("contact_time", scene.impacts.contact_time);
    }
    if (scene.impacts.rest_speed) members.number("rest_speed", *scene.impacts.rest_speed);
    members.close();
}

void write_cue(JsonText& json, const Cue& cue) {
    Members members(json);
    members.string("ball", cue.ball);
    members.number("speed", cue.speed);
    members.number("azimuth", cue.azimuth);
    members.number("elevation", cue.elevation);
    members.vector("offset", Point{cue.offset[0], cue.offset[1]});
    members.number("mass", cue.mass);
    members.number("end_mass", cue.end_mass);
    members.number("restitution", cue.restitution);
    members.number("miscue_limit", cue.miscue_limit);
    if (cue.allow_obstructed) {
        members.key("allow_obstructed");
        json.boolean(true);
    }
    members.close();
}

}  // namespace

void write_scene(JsonText& json, const Scene& scene, const std::string& indent) {
    const std::string inner = indent + "  ";
    const auto key = [&](std::string_view name) {
        json.raw(",\n");
        json.raw(inner);
        json.string(name);
        json.raw(": ");
    };
    json.raw("{\n" + inner + "\"schema\": ");
    json.string(kSceneSchema);
    key("motion");
    write_motion(json, scene.motion);
    key("gravity");
    json.number(scene.gravity);
    key("balls");
    json.lines(scene.balls, inner, [&](const Ball& ball) { write_ball(json, ball); });
    key("segments");
    json.lines(scene.segments, inner, [&](const Segment& s) { write_segment(json, s); });
    key("arcs");
    json.lines(scene.arcs, inner, [&](const Arc& arc) { write_arc(json, arc); });
    key("rims");
    json.lines(scene.rims, inner, [&](const Rim& rim) { write_rim(json, rim); });
    key("impacts");
    write_impacts(json, scene);
    if (scene.cue) {
        key("cue");
        write_cue(json, *scene.cue);
    }
    key("closed");
    json.boolean(scene.closed);
    key("limits");
    json.raw("{\"time\": ");
    json.number(scene.limits.time);
    json.raw(", \"events\": ");
    json.number(scene.limits.events);
    json.raw("}\n" + indent + "}");
}

std::string scene_to_json(const Scene& scene) {
    JsonText json;
    write_scene(json, scene, "");
    json.raw("\n");
    return json.take();
}

}  // namespace osculo::io

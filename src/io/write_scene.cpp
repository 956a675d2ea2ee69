#include "io/json_text.hpp"
#include "io/read.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

void write_ball(JsonText& json, const Ball& ball) {
    json.raw("{\"id\": ");
    json.string(ball.id);
    json.raw(", \"mass\": ");
    json.number(ball.mass);
    json.raw(", \"radius\": ");
    json.number(ball.radius);
    json.raw(", \"position\": ");
    json.vector(ball.position);
    json.raw(", \"velocity\": ");
    json.vector(ball.velocity);
    if (!is_plus_zero(ball.spin)) {
        json.raw(", \"spin\": ");
        json.vector(ball.spin);
    }
    if (ball.inertia != Ball{}.inertia) {
        json.raw(", \"inertia\": ");
        json.number(ball.inertia);
    }
    json.raw("}");
}

void write_segment(JsonText& json, const Segment& segment) {
    json.raw("{\"id\": ");
    json.string(segment.id);
    json.raw(", \"from\": ");
    json.vector(segment.from);
    json.raw(", \"to\": ");
    json.vector(segment.to);
    json.raw(segment.side == Side::left ? ", \"side\": \"left\"}" : ", \"side\": \"both\"}");
}

void write_arc(JsonText& json, const Arc& arc) {
    json.raw("{\"id\": ");
    json.string(arc.id);
    json.raw(", \"center\": ");
    json.vector(arc.center);
    json.raw(", \"radius\": ");
    json.number(arc.radius);
    json.raw(", \"from_angle\": ");
    json.number(arc.from_angle);
    json.raw(", \"to_angle\": ");
    json.number(arc.to_angle);
    json.raw("}");
}

void write_rim(JsonText& json, const Rim& rim) {
    json.raw("{\"id\": ");
    json.string(rim.id);
    json.raw(", \"center\": ");
    json.vector(rim.center);
    json.raw(", \"radius\": ");
    json.number(rim.radius);
    json.raw(", \"law\": \"capture\"}");
}

// `, "name": number`
void write_number(JsonText& json, std::string_view name, double number) {
    json.raw(", \"");
    json.raw(name);
    json.raw("\": ");
    json.number(number);
}

void write_motion(JsonText& json, const MotionLaw& motion) {
    if (const auto* rolling = std::get_if<RollingMotion>(&motion)) {
        json.raw("{\"law\": \"rolling\"");
        write_number(json, "friction", rolling->friction);
    } else if (const auto* cloth = std::get_if<ClothMotion>(&motion)) {
        json.raw("{\"law\": \"cloth\"");
        write_number(json, "sliding_friction", cloth->sliding_friction);
        write_number(json, "rolling_friction", cloth->rolling_friction);
        write_number(json, "spinning_friction", cloth->spinning_friction);
    } else {
        json.raw("{\"law\": \"uniform\"");
    }
    json.raw("}");
}

void write_impacts(JsonText& json, const Scene& scene) {
    const BallBallImpact& balls = scene.impacts.ball_ball;
    const CushionImpact& cushion = scene.impacts.ball_cushion;
    const bool frictional = balls.law == BallBallLaw::frictional;
    json.raw("{\"ball_ball\": {\"law\": ");
    json.string(frictional ? "frictional" : "restitution");
    write_number(json, "restitution", balls.restitution);
    if (frictional) {
        json.raw(", \"friction\": ");
        json.vector(balls.friction);
    }
    json.raw("}, \"ball_cushion\": {\"law\": ");
    json.string(to_string(cushion.law));
    write_number(json, "restitution", cushion.restitution);
    if (cushion.law != CushionLaw::restitution) {
        write_number(json, "friction", cushion.friction);
        write_number(json, "height", cushion.height);
    }
    json.raw("}, \"simultaneous\": \"sequential\"");
    if (!std::holds_alternative<UniformMotion>(scene.motion)) {
        write_number(json, "contact_time", scene.impacts.contact_time);
    }
    json.raw("}");
}

void write_cue(JsonText& json, const Cue& cue) {
    json.raw("{\"ball\": ");
    json.string(cue.ball);
    write_number(json, "speed", cue.speed);
    write_number(json, "azimuth", cue.azimuth);
    write_number(json, "elevation", cue.elevation);
    json.raw(", \"offset\": ");
    json.vector(Point{cue.offset[0], cue.offset[1]});
    write_number(json, "mass", cue.mass);
    write_number(json, "end_mass", cue.end_mass);
    write_number(json, "restitution", cue.restitution);
    write_number(json, "miscue_limit", cue.miscue_limit);
    json.raw("}");
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

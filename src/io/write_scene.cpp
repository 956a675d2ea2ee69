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

void write_restitution(JsonText& json, const Restitution& law) {
    json.raw("{\"law\": \"restitution\", \"restitution\": ");
    json.number(law.restitution);
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
    json.raw("{\"law\": \"uniform\"}");
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
    json.raw("{\"ball_ball\": ");
    write_restitution(json, scene.impacts.ball_ball);
    json.raw(", \"ball_cushion\": ");
    write_restitution(json, scene.impacts.ball_cushion);
    json.raw(", \"simultaneous\": \"sequential\"}");
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

#include "io/certificate.hpp"
#include "io/json_text.hpp"
#include "io/members.hpp"
#include "io/outcome.hpp"
#include "io/read.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

void write_states(JsonText& json, const std::array<BallState, 2>& states, bool both) {
    json.raw("[");
    for (std::size_t i = 0; i < (both ? 2U : 1U); ++i) {
        if (i > 0) json.raw(", ");
        Members members(json);
        members.state(states[i]);
        members.close();
    }
    json.raw("]");
}

void write_event(JsonText& json, const Run& run, const Event& event) {
    const bool both = event.kind == EventKind::ball_ball;
    const bool transition = event.kind == EventKind::transition;
    Members members(json);
    members.number("time", event.time);
    members.low_part("time_low", event.time_low);
    members.string("kind", to_string(event.kind));
    members.key("ids");
    if (transition) {
        json.strings(std::array{run.scene.balls[event.ball].id});
        members.string("from", to_string(event.from));
        members.string("to", to_string(event.to));
    } else {
        json.strings(run.ids(event));
        members.vector("point", event.point);
        members.vector("normal", event.normal);
        if (event.cluster != 0) {
            members.number("cluster", std::uint64_t{event.cluster});
            members.key("well_posed");
            json.boolean(event.well_posed);
        }
    }
    members.key("before");
    write_states(json, event.before, both);
    members.key("after");
    write_states(json, event.after, both);
    members.close();
}

void write_piece(JsonText& json, const Run& run, const Piece& piece) {
    Members members(json);
    members.string("ball", run.scene.balls[piece.ball].id);
    members.number("from", piece.from);
    members.low_part("from_low", piece.from_low);
    members.number("to", piece.to);
    members.low_part("to_low", piece.to_low);
    members.string("law", to_string(piece.phase));
    const bool over_hole = piece.phase == Phase::tipping || piece.phase == Phase::flying;
    if (over_hole || piece.phase == Phase::rim) {
        members.string("rim", run.scene.rims[piece.rim].id);
    }
    if (over_hole) {
        members.number("height", piece.height);
        members.number("climb", piece.climb);
    }
    if (piece.phase == Phase::tipping) members.number("inertia", piece.inertia);
    members.vector("position", piece.position);
    members.rare("position_low", piece.position_low);
    members.vector("velocity", piece.velocity);
    members.rare("acceleration", piece.acceleration);
    members.rare("spin", piece.spin);
    members.rare("spin_rate", piece.spin_rate);
    members.rare("resistance", piece.resistance);
    members.close();
}

void write_ball(JsonText& json, const Run& run, const FinalBall& ball) {
    const auto index = static_cast<std::size_t>(&ball - run.balls.data());
    Members members(json);
    members.string("id", run.scene.balls[index].id);
    members.string("state", to_string(ball.fate));
    members.state(ball.state);
    if (ball.rim) members.string("rim", run.scene.rims[*ball.rim].id);
    members.close();
}

void write_audit(JsonText& json, const Audit& audit) {
    Members members(json);
    members.boolean("clean", audit.clean);
    members.number("energy_initial", audit.energy_initial);
    members.number("energy_final", audit.energy_final);
    members.number("largest_energy_gain", audit.largest_energy_gain);
    members.number("largest_momentum_error", audit.largest_momentum_error);
    members.number("worst_gap", audit.worst_gap);
    members.number("worst_gap_time", audit.worst_gap_time);
    members.key("worst_gap_ids");
    json.strings(audit.worst_gap_ids);
    members.number("largest_jump", audit.largest_jump);
    members.number("unexplained", audit.unexplained);
    members.close();
}

}  // namespace

std::string run_to_json(const Run& run) {
    JsonText json;
    const auto key = [&json](std::string_view name) { json.next_member("  ", name); };
    json.raw("{\n  \"schema\": ");
    json.string(kRunSchema);
    key("status");
    json.string(to_string(run.status));
    key("time");
    json.number(run.time);
    key("event_count");
    json.number(run.event_count);
    if (run.settled_count > 0) {
        key("settled_count");
        json.number(run.settled_count);
    }
    key("engine");
    json.raw("{\"name\": ");
    json.string(run.engine.name);
    json.raw(", \"left_out\": ");
    json.lines(run.engine.left_out, "  ", [&](const std::string& text) { json.string(text); });
    json.raw("}");
    if (run.audit) {
        key("audit");
        write_audit(json, *run.audit);
    }
    if (run.certificate) {
        key("certificate");
        write_certificate(json, run, *run.certificate);
    }
    if (const auto outcome = outcome_of(run)) {
        key("outcome");
        write_outcome(json, run, *outcome);
    }
    key("balls");
    json.lines(run.balls, "  ", [&](const FinalBall& ball) { write_ball(json, run, ball); });
    key("points");
    json.strings(run.points);
    key("events");
    json.lines(run.events, "  ", [&](const Event& event) { write_event(json, run, event); });
    key("pieces");
    json.lines(run.pieces, "  ", [&](const Piece& piece) { write_piece(json, run, piece); });
    key("scene");
    write_scene(json, run.scene, "  ");
    json.raw("\n}\n");
    return json.take();
}

}  // namespace osculo::io

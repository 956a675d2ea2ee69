#include "io/members.hpp"
#include "io/outcome.hpp"

namespace osculo::io {
namespace {

void write_hit(JsonText& json, const Run& run, const Outcome::Hit& hit) {
    Members members(json);
    members.string("ball", run.scene.balls[hit.ball].id);
    members.number("time", hit.time);
    members.number("cushions", hit.cushions);
    members.close();
}

void write_fall(JsonText& json, const Run& run, const Outcome::Fall& fall) {
    Members members(json);
    members.string("ball", run.scene.balls[fall.ball].id);
    members.string("rim", run.scene.rims[fall.rim].id);
    members.number("time", fall.time);
    members.close();
}

void write_tally(JsonText& json, const std::string& id, const Outcome::Tally& tally) {
    Members members(json);
    members.string("id", id);
    members.number("balls", tally.balls);
    members.number("cushions", tally.cushions);
    members.vector("position", tally.position);
    members.close();
}

}  // namespace

void write_outcome(JsonText& json, const Run& run, const Outcome& outcome) {
    constexpr std::string_view kIndent = "    ";
    const auto key = [&](std::string_view name) { json.next_member(kIndent, name); };
    json.raw("{\n    \"kisses\": ");
    json.number(outcome.kisses);
    key("driven_to_cushion");
    json.number(outcome.driven_to_cushion);
    if (outcome.cue_ball) {
        key("cue_ball");
        json.string(run.scene.balls[*outcome.cue_ball].id);
    }
    key("cushions_before_hit");
    json.number(outcome.cushions_before_hit);
    key("cushions_after_hit");
    json.number(outcome.cushions_after_hit);
    if (outcome.rest_time) {
        key("rest_time");
        json.number(*outcome.rest_time);
    }
    key("hits");
    json.lines(outcome.hits, kIndent, [&](const auto& hit) { write_hit(json, run, hit); });
    key("falls");
    json.lines(outcome.falls, kIndent, [&](const auto& fall) { write_fall(json, run, fall); });
    key("balls");
    json.lines(outcome.balls, kIndent, [&](const auto& tally) {
        const auto index = static_cast<std::size_t>(&tally - outcome.balls.data());
        write_tally(json, run.scene.balls[index].id, tally);
    });
    json.raw("\n  }");
}

}  // namespace osculo::io

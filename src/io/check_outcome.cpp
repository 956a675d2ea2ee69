#include <cmath>

#include "io/outcome.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

void fail(const Value& value) {
    value.fail("must be what the events give");
}

void expect(const Value& value, double number) {
    const double given = value.number();
    if (given != number && !(std::isnan(given) && std::isnan(number))) fail(value);
}

void expect(const Value& value, std::uint64_t number) {
    if (value.natural() != number) fail(value);
}

void expect(const Value& value, const std::string& text) {
    if (value.text() != text) fail(value);
}

void expect(const Value& value, const Point& point) {
    const Point given = value.point();
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    if (!same(given.x, point.x) || !same(given.y, point.y)) fail(value);
}

// Each element by check(element, thing).
template <class Thing, class Check>
void expect_all(const Value& value, const std::vector<Thing>& things, Check check) {
    if (value.size() != things.size()) {
        value.fail("must be what the events give, an array of length " +
                   std::to_string(things.size()));
    }
    std::size_t index = 0;
    value.for_each([&](const Value& element) { check(element, things[index++]); });
}

}  // namespace

void check_outcome(const Value& value, const Run& run) {
    static constexpr Names kKeys{"kisses",
                                 "driven_to_cushion",
                                 "cue_ball",
                                 "rest_time",
                                 "cushions_before_hit",
                                 "cushions_after_hit",
                                 "hits",
                                 "falls",
                                 "balls"};
    static constexpr Names kHitKeys{"ball", "time", "cushions"};
    static constexpr Names kFallKeys{"ball", "rim", "time"};
    static constexpr Names kTallyKeys{"id", "balls", "cushions", "position"};
    const Fields fields(value, kKeys);
    const std::optional<Outcome> outcome = outcome_of(run);
    if (!outcome) value.fail("needs the events that it follows from", "without them");

    expect(fields.require("kisses"), outcome->kisses);
    expect(fields.require("driven_to_cushion"), outcome->driven_to_cushion);
    expect(fields.require("cushions_before_hit"), outcome->cushions_before_hit);
    expect(fields.require("cushions_after_hit"), outcome->cushions_after_hit);
    const auto& balls = run.scene.balls;
    if (outcome->cue_ball) expect(fields.require("cue_ball"), balls[*outcome->cue_ball].id);
    if (outcome->rest_time) expect(fields.require("rest_time"), *outcome->rest_time);
    for (const auto& [name, is_there] : {std::pair{"cue_ball", outcome->cue_ball.has_value()},
                                         std::pair{"rest_time", outcome->rest_time.has_value()}}) {
        const auto extra = fields.find(name);
        if (extra && !is_there) extra->fail("must not be there: the events give none");
    }
    expect_all(fields.require("hits"), outcome->hits, [&](const Value& v, const Outcome::Hit& hit) {
        const Fields members(v, kHitKeys);
        expect(members.require("ball"), balls[hit.ball].id);
        expect(members.require("time"), hit.time);
        expect(members.require("cushions"), hit.cushions);
    });
    expect_all(fields.require("falls"), outcome->falls,
               [&](const Value& v, const Outcome::Fall& fall) {
                   const Fields members(v, kFallKeys);
                   expect(members.require("ball"), balls[fall.ball].id);
                   expect(members.require("rim"), run.scene.rims[fall.rim].id);
                   expect(members.require("time"), fall.time);
               });
    expect_all(fields.require("balls"), outcome->balls,
               [&](const Value& v, const Outcome::Tally& tally) {
                   const Fields members(v, kTallyKeys);
                   const auto index = static_cast<std::size_t>(&tally - outcome->balls.data());
                   expect(members.require("id"), balls[index].id);
                   expect(members.require("balls"), tally.balls);
                   expect(members.require("cushions"), tally.cushions);
                   expect(members.require("position"), tally.position);
               });
}

}  // namespace osculo::io

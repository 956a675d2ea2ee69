#include <unordered_map>

#include "io/certificate.hpp"
#include "io/outcome.hpp"
#include "io/read.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

// The places of things by their ids. Refers to the ids: what has them must stay where it is.
class Index {
public:
    explicit Index(const std::vector<std::string>& ids) {
        for (const std::string& id : ids) add(id);
    }
    template <class Thing>
    explicit Index(const std::vector<Thing>& things) {
        for (const Thing& thing : things) add(thing.id);
    }

    [[nodiscard]] std::uint32_t operator()(const Value& id) const {
        const auto found = places_.find(id.text());
        if (found == places_.end()) id.fail("must be an id of the scene");
        return found->second;
    }

private:
    void add(std::string_view id) { places_.emplace(id, count_++); }

    std::uint32_t count_ = 0;
    std::unordered_map<std::string_view, std::uint32_t> places_;
};

struct Indices {
    explicit Indices(const Run& run)
        : balls(run.scene.balls),
          segments(run.scene.segments),
          arcs(run.scene.arcs),
          rims(run.scene.rims),
          points(run.points) {}

    [[nodiscard]] const Index& of_other(EventKind kind) const {
        switch (kind) {
            case EventKind::capture:
            case EventKind::rim_entry:
            case EventKind::rim_exit: return rims;
            case EventKind::ball_ball: return balls;
            case EventKind::ball_segment: return segments;
            case EventKind::ball_arc: return arcs;
            case EventKind::ball_point: return points;
            case EventKind::transition: break;
        }
        return balls;
    }

    Index balls, segments, arcs, rims, points;
};

BallState read_state(const Fields& fields) {
    BallState state;
    state.position = fields.require("position").point();
    state.velocity = fields.require("velocity").point();
    if (const auto spin = fields.find("spin")) state.spin = read_spin(*spin);
    return state;
}

std::array<BallState, 2> read_states(const Value& value, EventKind kind) {
    static constexpr Names kKeys{"position", "velocity", "spin"};
    const std::size_t expected = kind == EventKind::ball_ball ? 2 : 1;
    if (value.size() != expected) {
        value.fail("must be an array of length " + std::to_string(expected));
    }
    std::array<BallState, 2> states;
    std::size_t count = 0;
    value.for_each([&](const Value& state) { states[count++] = read_state(Fields(state, kKeys)); });
    return states;
}

Phase read_phase(const Value& value) {
    static constexpr Phase kPhases[]{Phase::uniform, Phase::rest,    Phase::spinning,
                                     Phase::rolling, Phase::sliding, Phase::resisted,
                                     Phase::rim,     Phase::tipping, Phase::flying};
    static constexpr Names kPhaseNames{
        to_string(kPhases[0]), to_string(kPhases[1]), to_string(kPhases[2]),
        to_string(kPhases[3]), to_string(kPhases[4]), to_string(kPhases[5]),
        to_string(kPhases[6]), to_string(kPhases[7]), to_string(kPhases[8])};
    return kPhases[choice(value, kPhaseNames)];
}

Event read_event(const Value& value, const Indices& indices) {
    static constexpr Names kKeys{"time",   "time_low", "kind", "ids", "point",   "normal",
                                 "before", "after",    "from", "to",  "cluster", "well_posed"};
    static constexpr EventKind kKinds[]{
        EventKind::capture,    EventKind::ball_ball,  EventKind::ball_segment, EventKind::ball_arc,
        EventKind::ball_point, EventKind::transition, EventKind::rim_entry,    EventKind::rim_exit};
    static constexpr Names kKindNames{
        to_string(kKinds[0]), to_string(kKinds[1]), to_string(kKinds[2]), to_string(kKinds[3]),
        to_string(kKinds[4]), to_string(kKinds[5]), to_string(kKinds[6]), to_string(kKinds[7])};
    const Fields fields(value, kKeys);
    Event event;
    event.time = fields.require("time").number();
    if (const auto low = fields.find("time_low")) event.time_low = low->number();
    event.kind = kKinds[choice(fields.require("kind"), kKindNames)];

    const bool transition = event.kind == EventKind::transition;
    const Value ids = fields.require("ids");
    if (transition && ids.size() != 1) ids.fail("must be an array of length 1");
    if (!transition && ids.size() != 2) ids.fail("must be an array of length 2");
    bool is_first = true;
    ids.for_each([&](const Value& id) {
        (is_first ? event.ball : event.other) =
            is_first ? indices.balls(id) : indices.of_other(event.kind)(id);
        is_first = false;
    });

    if (transition) {
        event.from = read_phase(fields.require("from"));
        event.to = read_phase(fields.require("to"));
    } else {
        event.point = fields.require("point").point();
        event.normal = fields.require("normal").point();
        if (const auto cluster = fields.find("cluster")) {
            const std::uint64_t number = cluster->natural();
            if (number == 0 || number > 0xFFFFFFFFU) cluster->fail("must be from 1 to 4294967295");
            event.cluster = static_cast<std::uint32_t>(number);
        }
        if (const auto unique = fields.find("well_posed")) event.well_posed = unique->boolean();
    }
    event.before = read_states(fields.require("before"), event.kind);
    event.after = read_states(fields.require("after"), event.kind);
    if (transition) event.point = event.before[0].position;
    return event;
}

Piece read_piece(const Value& value, const Indices& indices) {
    static constexpr Names kKeys{"ball",         "from",      "from_low",     "to",       "to_low",
                                 "law",          "position",  "position_low", "velocity", "spin",
                                 "acceleration", "spin_rate", "resistance",   "rim",      "height",
                                 "climb",        "inertia"};
    const Fields fields(value, kKeys);
    Piece piece;
    piece.ball = indices.balls(fields.require("ball"));
    piece.from = fields.require("from").number();
    if (const auto low = fields.find("from_low")) piece.from_low = low->number();
    piece.to = fields.require("to").number();
    if (const auto low = fields.find("to_low")) piece.to_low = low->number();
    piece.phase = read_phase(fields.require("law"));
    const bool over_hole = piece.phase == Phase::tipping || piece.phase == Phase::flying;
    if (over_hole || piece.phase == Phase::rim) {
        piece.rim = indices.rims(fields.require("rim"));
    } else if (const auto rim = fields.find("rim")) {
        rim->fail("is for the laws rim, tipping and flying only");
    }
    const auto over_edge = [&](const char* name, bool belongs) {
        if (belongs) return fields.require(name).number();
        if (const auto given = fields.find(name)) {
            given->fail("is for balls that tip over a rim only");
        }
        return 0.0;
    };
    piece.height = over_edge("height", over_hole);
    piece.climb = over_edge("climb", over_hole);
    piece.inertia = over_edge("inertia", piece.phase == Phase::tipping);
    piece.position = fields.require("position").point();
    if (const auto low = fields.find("position_low")) piece.position_low = low->point();
    piece.velocity = fields.require("velocity").point();
    if (const auto a = fields.find("acceleration")) piece.acceleration = a->point();
    if (const auto spin = fields.find("spin")) piece.spin = read_spin(*spin);
    if (const auto rate = fields.find("spin_rate")) piece.spin_rate = read_spin(*rate);
    if (const auto law = fields.find("resistance")) piece.resistance = law->numbers<3>();
    return piece;
}

// The balls must be those of the scene, in its order.
FinalBall read_final_ball(const Value& value, std::size_t place, const Indices& indices) {
    static constexpr Names kKeys{"id", "state", "position", "velocity", "spin", "rim"};
    static constexpr BallFate kFates[]{BallFate::rest, BallFate::moving, BallFate::captured};
    static constexpr Names kFateNames{to_string(kFates[0]), to_string(kFates[1]),
                                      to_string(kFates[2])};
    const Fields fields(value, kKeys);
    const Value id = fields.require("id");
    if (indices.balls(id) != place) id.fail("must be in the order of the scene's balls");
    FinalBall ball;
    ball.fate = kFates[choice(fields.require("state"), kFateNames)];
    ball.state = read_state(fields);
    if (const auto rim = fields.find("rim")) ball.rim = indices.rims(*rim);
    return ball;
}

Audit read_audit(const Value& value) {
    static constexpr Names kKeys{"clean",          "energy_initial",      "energy_final",
                                 "worst_gap",      "largest_energy_gain", "largest_momentum_error",
                                 "worst_gap_time", "worst_gap_ids",       "largest_jump",
                                 "unexplained"};
    const Fields fields(value, kKeys);
    Audit audit;
    audit.clean = fields.require("clean").boolean();
    audit.energy_initial = fields.require("energy_initial").number();
    audit.energy_final = fields.require("energy_final").number();
    audit.largest_energy_gain = fields.require("largest_energy_gain").number();
    audit.largest_momentum_error = fields.require("largest_momentum_error").number();
    audit.worst_gap = fields.require("worst_gap").number();
    audit.worst_gap_time = fields.require("worst_gap_time").number();
    fields.require("worst_gap_ids").for_each([&](const Value& id) {
        audit.worst_gap_ids.emplace_back(id.text());
    });
    audit.largest_jump = fields.require("largest_jump").number();
    audit.unexplained = fields.require("unexplained").natural();
    return audit;
}

EngineInfo read_engine(const Value& value) {
    static constexpr Names kKeys{"name", "left_out"};
    const Fields fields(value, kKeys);
    EngineInfo engine;
    engine.name = fields.require("name").text();
    fields.require("left_out").for_each([&](const Value& text) {
        engine.left_out.emplace_back(text.text());
    });
    return engine;
}

Status read_status(const Value& value) {
    static constexpr Status kStatuses[]{Status::at_rest, Status::time_limit, Status::event_limit,
                                        Status::zeno, Status::numeric};
    static constexpr Names kStatusNames{to_string(kStatuses[0]), to_string(kStatuses[1]),
                                        to_string(kStatuses[2]), to_string(kStatuses[3]),
                                        to_string(kStatuses[4])};
    return kStatuses[choice(value, kStatusNames)];
}

}  // namespace

Run read_run(const Value& value) {
    static constexpr Names kSchemas{kRunSchema};
    static constexpr Names kKeys{"schema", "status", "time",        "event_count", "settled_count",
                                 "engine", "audit",  "certificate", "outcome",     "balls",
                                 "points", "events", "pieces",      "scene"};
    if (const auto schema = value.member("schema")) choice(*schema, kSchemas);
    const Fields fields(value, kKeys);
    static_cast<void>(fields.require("schema"));

    Run run;
    run.scene = read_scene(fields.require("scene"));
    run.status = read_status(fields.require("status"));
    run.time = fields.require("time").number();
    run.event_count = fields.require("event_count").natural();
    if (const auto count = fields.find("settled_count")) run.settled_count = count->natural();
    run.engine = read_engine(fields.require("engine"));
    if (const auto audit = fields.find("audit")) run.audit = read_audit(*audit);
    if (const auto certificate = fields.find("certificate")) {
        run.certificate = read_certificate(*certificate, run);
    }
    fields.require("points").for_each(
        [&](const Value& name) { run.points.emplace_back(name.text()); });

    const Indices indices(run);
    const Value balls = fields.require("balls");
    balls.for_each([&](const Value& ball) {
        run.balls.push_back(read_final_ball(ball, run.balls.size(), indices));
    });
    if (run.balls.size() != run.scene.balls.size()) {
        balls.fail("must have as many elements as the scene has balls");
    }
    const Value events = fields.require("events");
    run.events.reserve(events.size());
    events.for_each([&](const Value& event) { run.events.push_back(read_event(event, indices)); });
    const Value pieces = fields.require("pieces");
    run.pieces.reserve(pieces.size());
    pieces.for_each([&](const Value& piece) { run.pieces.push_back(read_piece(piece, indices)); });
    if (const auto outcome = fields.find("outcome")) check_outcome(*outcome, run);
    return run;
}

}  // namespace osculo::io

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"

namespace osculo::io {
namespace {

bool equal(const osculo::Run& a, const osculo::Run& b) {
    return a.scene == b.scene && a.status == b.status && a.time == b.time &&
           a.event_count == b.event_count && a.settled_count == b.settled_count &&
           a.engine == b.engine && a.points == b.points && a.events == b.events &&
           a.pieces == b.pieces && a.balls == b.balls && a.audit == b.audit &&
           a.certificate == b.certificate;
}

// A small run with one of everything, made by hand.
osculo::Run small_run() {
    osculo::Run run;
    run.scene.balls.push_back({"a", 1, 0.5, {0, 0}, {1, 0}, {}});
    run.scene.balls.push_back({"b", 1, 0.5, {3, 0}, {}, {}});
    run.scene.segments.push_back({"wall", {5, -1}, {5, 1}, Side::both});
    run.scene.rims.push_back({"hole", {-3, 0}, 1, RimLaw::capture});
    run.status = Status::event_limit;
    run.time = 4;
    run.event_count = 3;
    run.settled_count = 2;
    run.engine = {"test", {"nothing"}};
    run.points = {"wall.from", "wall.to"};
    const BallState moving{{2, 0}, {1, 0}, {}};
    const BallState still{{3, 0}, {0, 0}, {0, 0, 7}};
    run.events.push_back(
        {2, 1e-17, EventKind::ball_ball, 0, 1, {2.5, 0}, {1, 0}, {moving, still}, {still, moving}});
    run.events.push_back(
        {2.5, 0, EventKind::ball_point, 1, 1, {5, 1}, {0.6, 0.8}, {moving, {}}, {still, {}}});
    run.events[0].cluster = run.events[1].cluster = 1;
    run.events[0].well_posed = run.events[1].well_posed = false;
    run.events.push_back(
        {3, 0, EventKind::capture, 0, 0, {-2, 0}, {-1, 0}, {moving, {}}, {moving, {}}});
    run.pieces.push_back({0, 0, 0, 2, 1e-17, {0, 0}, {0, -1e-18}, {1, 0}, {}});
    run.balls.push_back({BallFate::captured, moving, 0});
    run.balls.push_back({BallFate::rest, still, std::nullopt});
    Audit audit;
    audit.clean = true;
    audit.worst_gap = -1e-17;
    audit.worst_gap_ids = {"a", "b"};
    run.audit = audit;
    return run;
}

TEST(RunJson, IsWrittenAsDocumented) {
    const std::string text = run_to_json(small_run());
    EXPECT_EQ(text.substr(0, text.find("  \"scene\"")), R"({
  "schema": "osculo/run-1",
  "status": "event_limit",
  "time": 4,
  "event_count": 3,
  "settled_count": 2,
  "engine": {"name": "test", "left_out": [
    "nothing"
  ]},
  "audit": {"clean": true, "energy_initial": 0, "energy_final": 0, "largest_energy_gain": 0, "largest_momentum_error": 0, "worst_gap": -1e-17, "worst_gap_time": 0, "worst_gap_ids": ["a", "b"], "largest_jump": 0, "unexplained": 0},
  "outcome": {
    "kisses": 0,
    "driven_to_cushion": 1,
    "cue_ball": "a",
    "cushions_before_hit": 0,
    "cushions_after_hit": 0,
    "hits": [
      {"ball": "b", "time": 2, "cushions": 0}
    ],
    "falls": [
      {"ball": "a", "rim": "hole", "time": 3}
    ],
    "balls": [
      {"id": "a", "balls": 1, "cushions": 0, "position": [2, 0]},
      {"id": "b", "balls": 1, "cushions": 1, "position": [3, 0]}
    ]
  },
  "balls": [
    {"id": "a", "state": "captured", "position": [2, 0], "velocity": [1, 0], "rim": "hole"},
    {"id": "b", "state": "rest", "position": [3, 0], "velocity": [0, 0], "spin": [0, 0, 7]}
  ],
  "points": ["wall.from", "wall.to"],
  "events": [
    {"time": 2, "time_low": 1e-17, "kind": "ball_ball", "ids": ["a", "b"], "point": [2.5, 0], "normal": [1, 0], "cluster": 1, "well_posed": false, "before": [{"position": [2, 0], "velocity": [1, 0]}, {"position": [3, 0], "velocity": [0, 0], "spin": [0, 0, 7]}], "after": [{"position": [3, 0], "velocity": [0, 0], "spin": [0, 0, 7]}, {"position": [2, 0], "velocity": [1, 0]}]},
    {"time": 2.5, "kind": "ball_point", "ids": ["b", "wall.to"], "point": [5, 1], "normal": [0.6, 0.8], "cluster": 1, "well_posed": false, "before": [{"position": [2, 0], "velocity": [1, 0]}], "after": [{"position": [3, 0], "velocity": [0, 0], "spin": [0, 0, 7]}]},
    {"time": 3, "kind": "capture", "ids": ["a", "hole"], "point": [-2, 0], "normal": [-1, 0], "before": [{"position": [2, 0], "velocity": [1, 0]}], "after": [{"position": [2, 0], "velocity": [1, 0]}]}
  ],
  "pieces": [
    {"ball": "a", "from": 0, "to": 2, "to_low": 1e-17, "law": "uniform", "position": [0, 0], "position_low": [0, -1e-18], "velocity": [1, 0]}
  ],
)");
}

TEST(RunJson, RoundTripIsTheIdentity) {
    EXPECT_TRUE(equal(run_from_json(run_to_json(small_run())), small_run()));
    for (const presets::Info& info : presets::list()) {
        for (const Record record : {Record::none, Record::events, Record::pieces}) {
            const Scene scene = presets::make(info.name);
            const bool audit =
                info.name != "gas" && std::holds_alternative<UniformMotion>(scene.motion);
            const osculo::Run run = simulate(scene, {.record = record, .audit = audit});
            const std::string text = run_to_json(run);
            const osculo::Run again = run_from_json(text);
            EXPECT_TRUE(equal(again, run)) << info.name;
            EXPECT_EQ(run_to_json(again), text) << info.name;
        }
    }
}

TEST(RunJson, AnOutcomeNeedsEvents) {
    osculo::Run run = simulate(presets::make("break"), {.record = Record::none});
    EXPECT_EQ(run_to_json(run).find("\"outcome\""), std::string::npos);
    run = simulate(presets::make("break"), {.record = Record::events});
    const std::string text = run_to_json(run);
    EXPECT_NE(text.find("\"outcome\""), std::string::npos);
    EXPECT_TRUE(equal(run_from_json(text), run));
}

TEST(RunJson, SameRunSameBytes) {
    const Scene scene = presets::make("break");
    EXPECT_EQ(run_to_json(simulate(scene)), run_to_json(simulate(scene)));
}

TEST(RunJson, NumbersThatAreNotFiniteSurvive) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    osculo::Run run = small_run();
    run.status = Status::numeric;
    run.audit->energy_initial = kInfinity;
    run.audit->worst_gap = -kInfinity;
    run.pieces[0].velocity.x = std::nan("");
    const osculo::Run again = run_from_json(run_to_json(run));
    EXPECT_EQ(again.audit->energy_initial, kInfinity);
    EXPECT_EQ(again.audit->worst_gap, -kInfinity);
    EXPECT_TRUE(std::isnan(again.pieces[0].velocity.x));
}

TEST(RunJson, HasTheCertificate) {
    osculo::Run run = small_run();
    run.certificate = Certificate{"quad", "extended", true, 2, 1, {}, {}};
    run.certificate->events = {{true, 15.5, 14, 13}, {true, 16, 16, 16}, {}};
    run.certificate->balls = {{true, 12.25, 11}, {}};
    const std::string text = run_to_json(run);
    const std::size_t from = text.find("  \"certificate\"");
    EXPECT_EQ(text.substr(from, text.find("  \"outcome\"") - from), R"(  "certificate": {
    "certain": false,
    "reference": "quad",
    "witness": "extended",
    "conclusive": true,
    "first_uncertain": 2,
    "first_out_of_order": 1,
    "balls": [
      {"id": "a", "confirmed": true, "position": 12.25, "velocity": 11},
      {"id": "b", "confirmed": false}
    ],
    "events": [
      {"confirmed": true, "time": 15.5, "position": 14, "velocity": 13},
      {"confirmed": true, "time": 16, "position": 16, "velocity": 16},
      {"confirmed": false}
    ]
  },
)");
    EXPECT_TRUE(equal(run_from_json(text), run));
    run.certificate = simulate(presets::make("carom"), {.certify = true}).certificate;
    run.certificate->balls.resize(2);
    EXPECT_TRUE(equal(run_from_json(run_to_json(run)), run));
}

TEST(RunJson, ACertificateMustFitItsRun) {
    osculo::Run run = small_run();
    run.certificate = Certificate{"quad", "extended", true, 1, 1, {{}}, {{}, {}}};
    const auto message = [&run] {
        try {
            static_cast<void>(run_from_json(run_to_json(run)));
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message(), "certificate.first_uncertain: must be the index of an event, but it is 1");
    run.certificate->first_uncertain = run.certificate->first_out_of_order = 0;
    EXPECT_EQ(message(), "");
    std::string text = run_to_json(run);
    text.replace(text.find("\"certain\": false"), 16, "\"certain\": true");
    EXPECT_THROW(static_cast<void>(run_from_json(text)), SceneError);
    run.certificate->balls.pop_back();
    EXPECT_EQ(message().substr(0, 70),
              "certificate.balls: must have as many elements as the scene has balls, ");
}

std::string error_after_replacing(const std::string& what, const std::string& by) {
    std::string text = run_to_json(small_run());
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
    try {
        static_cast<void>(run_from_json(text));
        return "no error";
    } catch (const SceneError& error) {
        return error.what();
    }
}

TEST(RunJson, ErrorsHavePaths) {
    EXPECT_EQ(error_after_replacing("osculo/run-1", "osculo/scene-1"),
              "schema: must be osculo/run-1, but it is \"osculo/scene-1\"");
    EXPECT_EQ(error_after_replacing("\"event_limit\"", "\"evnt_limit\""),
              "status: must be at_rest, time_limit, event_limit, zeno or numeric, did you mean "
              "event_limit?, but it is \"evnt_limit\"");
    EXPECT_EQ(error_after_replacing("[\"a\", \"b\"], \"point\"", "[\"a\", \"c\"], \"point\""),
              "events[0].ids[1]: must be an id of the scene, but it is \"c\"");
    EXPECT_EQ(error_after_replacing("\"wall.to\"]", "\"wall.too\"]"),
              "events[1].ids[1]: must be an id of the scene, but it is \"wall.to\"");
    EXPECT_EQ(error_after_replacing("\"ball\": \"a\", \"from\"", "\"ball\": \"wall\", \"from\""),
              "pieces[0].ball: must be an id of the scene, but it is \"wall\"");
    EXPECT_EQ(error_after_replacing("\"kind\": \"capture\"", "\"kind\": \"ball_ball\""),
              "events[2].ids[1]: must be an id of the scene, but it is \"hole\"");
    EXPECT_EQ(error_after_replacing("\"id\": \"b\", \"state\"", "\"id\": \"a\", \"state\""),
              "balls[1].id: must be in the order of the scene's balls, but it is \"a\"");
    EXPECT_EQ(error_after_replacing("\"mass\": 1,", "\"mass\": -1,"),
              "balls[0].mass: must be > 0, but it is -1");
    EXPECT_EQ(error_after_replacing("\"mass\": 1,", "\"mass\": \"x\","),
              "scene.balls[0].mass: must be a number, but it is \"x\"");
    EXPECT_EQ(error_after_replacing("\"cluster\": 1", "\"cluster\": 0"),
              "events[0].cluster: must be from 1 to 4294967295, but it is 0");
    EXPECT_EQ(error_after_replacing("\"kisses\": 0", "\"kises\": 0"),
              "outcome.kises: unknown key, did you mean kisses?");
    EXPECT_EQ(error_after_replacing("\"kisses\": 0", "\"kisses\": 1"),
              "outcome.kisses: must be what the events give, but it is 1");
    EXPECT_EQ(error_after_replacing("\"ball\": \"b\", \"time\": 2", "\"ball\": \"a\", \"time\": 2"),
              "outcome.hits[0].ball: must be what the events give, but it is \"a\"");
    EXPECT_EQ(error_after_replacing("\"hits\": [", "\"rest_time\": 3, \"hits\": ["),
              "outcome.rest_time: must not be there: the events give none, but it is 3");
    EXPECT_EQ(error_after_replacing("\"unexplained\": 0", "\"unexplaned\": 0"),
              "audit.unexplaned: unknown key, did you mean unexplained?");
}

TEST(RunJson, SchemaTellsScenesFromRuns) {
    const auto run = scene_or_run_from_json(run_to_json(small_run()));
    ASSERT_TRUE(std::holds_alternative<osculo::Run>(run));
    EXPECT_TRUE(equal(std::get<osculo::Run>(run), small_run()));
    const auto scene = scene_or_run_from_json(scene_to_json(small_run().scene));
    ASSERT_TRUE(std::holds_alternative<Scene>(scene));
    EXPECT_EQ(std::get<Scene>(scene), small_run().scene);
    EXPECT_THROW(static_cast<void>(scene_or_run_from_json("{}")), SceneError);
    EXPECT_THROW(static_cast<void>(scene_or_run_from_json("[]")), SceneError);
}

}  // namespace
}  // namespace osculo::io

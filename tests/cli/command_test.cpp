#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "osculo/version.hpp"
#include "process.hpp"

// What each command does when all is well.
namespace osculo::cli::test {
namespace {

using io::run_to_json;
using io::scene_to_json;

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
}

TEST(Help, IsThereForEveryCommandWithAnExample) {
    const Result help = osculo({"--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* command : {"run", "render", "replay", "validate", "explain", "expand",
                                "presets", "batch", "merge"}) {
        EXPECT_TRUE(contains(help.out, std::string("\n  ") + command)) << command;
        const Result own = osculo({command, "--help"});
        EXPECT_EQ(own.code, 0);
        EXPECT_TRUE(contains(own.out, std::string("\n  osculo ") + command)) << own.out;
    }
}

TEST(Version, IsThatOfTheLibrary) {
    const Result result = osculo({"--version"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, std::string("osculo ") + kVersion + '\n');
}

TEST(Run, PrintsASummary) {
    const std::string name = "preset:frictionless-break";
    const Result result = osculo({"run", name});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(result.out.starts_with(name + ": time limit reached at 10 s, after "));
    for (const char* part : {"\n  status    time_limit\n", "\n  events    ", " ball_ball, ",
                             "\n  captured  ", " pocket-", "\n  energy    ", "\n  engine    "}) {
        EXPECT_TRUE(contains(result.out, part)) << part << result.out;
    }
    EXPECT_FALSE(contains(result.out, "audit"));
    EXPECT_TRUE(contains(osculo({"run", name, "--audit"}).out, "\n  audit     clean\n"));
    EXPECT_EQ(osculo({"run", name, "--quiet"}).out, "");
}

// A disc that turns stores energy, and friction between discs turns some of it into motion.
TEST(Run, CountsTheEnergyOfSpin) {
    const TemporaryDirectory directory;
    const std::string scene = directory / "spin.json";
    write(scene, R"({"schema": "osculo/scene-1",
        "balls": [{"id": "a", "mass": 2, "radius": 0.5, "inertia": 0.5, "position": [0, 0],
                   "velocity": [1, 0], "spin": [0, 0, 4]},
                  {"id": "b", "mass": 1, "position": [3, 0], "radius": 0.5}],
        "impacts": {"ball_ball": {"law": "frictional", "restitution": 1, "friction": [1, 0, 0]}},
        "limits": {"time": 5}})");
    // 2 / 2 (1^2 + 0.5 (0.5 4)^2) J; slipping, friction loses some.
    const Result result = osculo({"run", scene});
    EXPECT_TRUE(contains(result.out, "\n  energy    3 J at the start, 2.")) << result.out;
}

TEST(Run, SaysWhatPlayersAskFor) {
    const Result result = osculo({"run", "preset:break"});
    EXPECT_TRUE(result.out.starts_with("preset:break: everything at rest at ")) << result.out;
    for (const char* part :
         {"\n  hits      1         ", "\n  cushions  cue meets 0 before its first hit and ",
          " other balls driven to one\n", "\n  kisses    "}) {
        EXPECT_TRUE(contains(result.out, part)) << part << result.out;
    }
    EXPECT_TRUE(contains(osculo({"run", "preset:carom"}).out, " s  after 4 cushions\n"));
    EXPECT_FALSE(contains(osculo({"run", "preset:gas"}).out, "\n  hits"));
    EXPECT_FALSE(contains(osculo({"run", "preset:break", "--record", "none"}).out, "\n  hits"));
}

TEST(Run, WritesWhatTheLibraryComputes) {
    const TemporaryDirectory directory;
    const std::string json = directory / "run.json";
    const std::string svg = directory / "shot.svg";
    const Result result = osculo({"run", "preset:carom", "-o", json, "--svg", svg});
    EXPECT_EQ(result.code, 0);
    const osculo::Run expected = simulate(presets::make("carom"));
    EXPECT_EQ(content_of(json), run_to_json(expected));
    EXPECT_EQ(content_of(svg), io::to_svg(expected));
    EXPECT_EQ(directory.file_count(), 2U);
}

TEST(Run, ReadsStdinAndWritesStdout) {
    const Result result = osculo({"run", "-", "-o", "-"}, scene_to_json(presets::make("cradle")));
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, run_to_json(simulate(presets::make("cradle"))));
    EXPECT_TRUE(result.err.starts_with("-: time limit reached"));
    EXPECT_EQ(osculo({"run", "preset:cradle", "-o", "-", "--quiet"}).err, "");
    EXPECT_TRUE(osculo({"run", "preset:cradle", "--svg", "-"}).out.starts_with("<svg"));
}

TEST(Run, TakesItsOptions) {
    const auto run_with = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"run", "preset:frictionless-break", "-o", "-", "-q"});
        return io::run_from_json(osculo(options).out);
    };
    EXPECT_EQ(run_with({"--time", "0.5"}).time, 0.5);
    EXPECT_EQ(run_with({"--events", "7"}).event_count, 7U);
    EXPECT_TRUE(run_with({"--record", "none"}).events.empty());
    EXPECT_FALSE(run_with({"--record", "events"}).events.empty());
    EXPECT_TRUE(run_with({"--record", "events"}).pieces.empty());
    EXPECT_FALSE(run_with({}).pieces.empty());
    EXPECT_TRUE(run_with({"--audit"}).audit->clean);
    for (const char* precision : {"double", "extended", "quad", "50", "100"}) {
        const osculo::Run run = run_with({"--precision", precision, "--time", "0.2"});
        EXPECT_TRUE(contains(run.engine.name, precision)) << run.engine.name;
    }
}

TEST(Run, CertifiesWhatCanBeTrusted) {
    const Result result = osculo({"run", "preset:carom", "--certify"});
    EXPECT_EQ(result.code, 0) << result.out;
    EXPECT_TRUE(
        contains(result.out, " events, by quad and extended\n            digits at least: "))
        << result.out;
    EXPECT_TRUE(contains(result.out, "\n  digits    "));
    EXPECT_FALSE(contains(result.out, "uncertain"));
    const Result early =
        osculo({"run", "preset:gas", "--certify", "--time", "1e9", "--events", "400"});
    EXPECT_EQ(early.code, 1) << early.out;  // that it ended early matters more
    const Result lost = osculo({"run", "preset:gas", "--certify", "-o", "-"});
    EXPECT_EQ(lost.code, 5) << lost.err;
    EXPECT_TRUE(contains(lost.err, "first uncertain: event ")) << lost.err;
    const osculo::Run run = io::run_from_json(lost.out);
    ASSERT_TRUE(run.certificate.has_value());
    EXPECT_FALSE(run.certificate->certain());
    EXPECT_EQ(run_to_json(run), lost.out);
    const Result highest = osculo({"run", "preset:carom", "--certify", "--precision", "100"});
    EXPECT_EQ(highest.code, 3);
    EXPECT_TRUE(contains(highest.err, "must be below 100 digits")) << highest.err;
}

// A break with cloth, spin and rails, and as many contacts as pi has digits.
TEST(Run, CertifiesShotsToTheirEnd) {
    for (const char* scene : {"preset:break", "preset:pi"}) {
        const Result result = osculo({"run", scene, "--certify", "-o", "-"});
        ASSERT_EQ(result.code, 0) << scene << result.err;
        const osculo::Run run = io::run_from_json(result.out);
        ASSERT_TRUE(run.certificate.has_value());
        EXPECT_TRUE(run.certificate->certain() && run.certificate->conclusive) << scene;
        EXPECT_EQ(run.certificate->events.size(), run.event_count);
        if (std::string(scene) == "preset:pi") {
            EXPECT_EQ(run.event_count, 314U);
        }
        for (const auto& ball : run.certificate->balls) {
            EXPECT_GT(std::min(ball.position, ball.velocity), 10) << scene;
        }
    }
}

TEST(Run, ExitCodeSaysHowItEnded) {
    EXPECT_EQ(osculo({"run", "preset:gas", "--time", "0.01"}).code, 0);
    const Result early = osculo({"run", "preset:gas", "--events", "10"});
    EXPECT_EQ(early.code, 1);
    EXPECT_TRUE(contains(early.out, "event limit reached"));

    Scene still = presets::make("cradle");
    still.balls[0].velocity = {};
    EXPECT_EQ(osculo({"run", "-"}, scene_to_json(still)).code, 0);
}

TEST(Replay, WritesAPageOfRunsAndScenes) {
    const Scene scene = presets::make("carom");
    const osculo::Run run = simulate(scene);
    EXPECT_EQ(osculo({"replay", "-"}, run_to_json(run)).out, io::to_html(run));
    EXPECT_EQ(osculo({"replay", "preset:carom", "--width", "700"}).out, io::to_html(run, 700));
    const Result bare =
        osculo({"replay", "-"}, run_to_json(simulate(scene, {.record = Record::events})));
    EXPECT_EQ(bare.code, 4);
    EXPECT_TRUE(contains(bare.err, "no pieces")) << bare.err;
}

TEST(Render, DrawsScenesAndRuns) {
    const Scene scene = presets::make("carom");
    EXPECT_EQ(osculo({"render", "-"}, scene_to_json(scene)).out, io::to_svg(scene));
    const osculo::Run run = simulate(scene);
    EXPECT_EQ(osculo({"render", "-"}, run_to_json(run)).out, io::to_svg(run));
    EXPECT_EQ(osculo({"render", "preset:carom", "--width", "640"}).out,
              io::to_svg(scene, {.width = 640}));
}

TEST(Validate, SaysWhatIsInTheScene) {
    const Result result = osculo({"validate", "preset:break"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "preset:break: valid: 16 balls, 18 segments, 12 arcs, 6 rims, closed\n");
}

TEST(Explain, NamesTheEngineAndWhatItLeavesOut) {
    const Result result = osculo({"explain", "preset:gas", "--record", "none"});
    EXPECT_EQ(result.code, 0);
    const EngineInfo engine = choose_engine(presets::make("gas"), {.record = Record::none});
    EXPECT_TRUE(contains(result.out, "\n  engine    " + engine.name + '\n')) << result.out;
    for (const std::string& reason : engine.left_out) EXPECT_TRUE(contains(result.out, reason));
}

TEST(Expand, SpellsOutTableAndRack) {
    const std::string text =
        R"({"schema": "osculo/scene-1", "table": "pool-7ft", "rack": "eight-ball"})";
    const Result result = osculo({"expand", "-"}, text);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, scene_to_json(io::scene_from_json(text)));
}

TEST(Presets, AreListedAndWritten) {
    const Result list = osculo({"presets"});
    EXPECT_EQ(list.code, 0);
    for (const presets::Info& info : presets::list()) {
        EXPECT_TRUE(contains(list.out, std::string(info.name))) << info.name;
        const Result one = osculo({"presets", std::string(info.name)});
        const auto text = presets::short_text(info.name);
        EXPECT_EQ(one.out, text ? *text : scene_to_json(presets::make(info.name)));
    }
    const Result gas = osculo({"presets", "gas", "--balls", "12", "--packing", "0.5", "--speed",
                               "2", "--restitution", "0.9", "--seed", "3"});
    EXPECT_EQ(
        gas.out,
        scene_to_json(presets::make(
            "gas", {.balls = 12, .packing = 0.5, .speed = 2.0, .restitution = 0.9, .seed = 3})));
    EXPECT_EQ(osculo({"presets", "pi", "--digits", "2"}).out,
              scene_to_json(presets::make("pi", {.digits = 2})));
    EXPECT_EQ(osculo({"presets", "frictionless-break", "--gap", "0"}).out,
              scene_to_json(presets::make("frictionless-break", {.gap = 0.0})));
    // The short form of a shot runs like the shot.
    const std::string text = osculo({"presets", "break", "--gap", "2e-4"}).out;
    EXPECT_EQ(osculo({"expand", "-"}, text).out,
              scene_to_json(presets::make("break", {.gap = 2e-4})));
}

TEST(Msgpack, IsChosenByTheEndingOfTheName) {
    const TemporaryDirectory directory;
    const std::string scene = directory / "scene.msgpack";
    const std::string run = directory / "run.msgpack";
    EXPECT_EQ(osculo({"presets", "carom", "-o", scene}).code, 0);
    EXPECT_EQ(osculo({"run", scene, "-o", run}).code, 0);
    const osculo::Run expected = simulate(presets::make("carom"));
    EXPECT_EQ(content_of(run), io::msgpack_from_json(run_to_json(expected)));
    EXPECT_EQ(osculo({"render", run}).out, io::to_svg(expected));
}

}  // namespace
}  // namespace osculo::cli::test

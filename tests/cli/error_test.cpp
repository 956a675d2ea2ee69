#include <algorithm>

#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "process.hpp"

// Exit codes 2, 3 and 4, each with one line on stderr and nothing on stdout.
namespace osculo::cli::test {
namespace {

void expect_error(const Result& result, int code, const std::string& message) {
    EXPECT_EQ(result.code, code) << message;
    EXPECT_EQ(result.err, "osculo: " + message + '\n');
    EXPECT_EQ(result.out, "");
}

TEST(Usage, UnknownWordsGetSuggestions) {
    expect_error(osculo({}), 2, "a command is needed, see osculo --help");
    expect_error(osculo({"rnu"}), 2,
                 "unknown command \"rnu\", did you mean run? (see osculo --help)");
    expect_error(osculo({"frobnicate"}), 2, "unknown command \"frobnicate\" (see osculo --help)");
    expect_error(osculo({"run", "preset:box", "--adit"}), 2,
                 "unexpected \"--adit\", did you mean --audit? (see osculo run --help)");
    expect_error(osculo({"validate", "preset:box", "more"}), 2,
                 "unexpected \"more\" (see osculo validate --help)");
}

TEST(Usage, WrongArguments) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"run"},
                                               {"run", "preset:box", "--time", "soon"},
                                               {"run", "preset:box", "--time"},
                                               {"run", "preset:box", "--events", "-3"},
                                               {"presets", "gas", "--seed", "-3"},
                                               {"run", "preset:box", "--precision", "half"},
                                               {"run", "preset:box", "--record", "all"},
                                               {"render", "preset:box", "--width", "0"},
                                               {"presets", "gas", "--balls", "ten"}}) {
        const Result result = osculo(arguments);
        EXPECT_EQ(result.code, 2) << arguments.back();
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_TRUE(result.err.starts_with("osculo: ")) << result.err;
    }
}

TEST(InvalidScene, HasNamePathRuleAndValue) {
    Scene scene = presets::make("cradle");
    scene.balls[3].mass = -1;
    const TemporaryDirectory directory;
    const std::string path = directory / "scene.json";
    write(path, io::scene_to_json(scene));
    for (const char* command : {"run", "render", "validate", "explain", "expand"}) {
        expect_error(osculo({command, path}), 3,
                     path + ": balls[3].mass: must be > 0, but it is -1");
    }
    expect_error(osculo({"validate", "-"}, "{\n  \"schema\": \"osculo/scene-1\",\n  \"bals\": []}"),
                 3, "-: bals: unknown key, did you mean balls?");
}

TEST(InvalidScene, BrokenFiles) {
    const auto error = [](const std::string& text) {
        const Result result = osculo({"run", "-"}, text);
        EXPECT_EQ(result.code, 3) << text;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        return result.err.substr(0, 36);
    };
    EXPECT_EQ(error(""), "osculo: -: is empty\n");
    EXPECT_EQ(error("{\"schema\": \"osculo/scene-1\",\n\"balls\": ["),
              "osculo: -: line 2, column 11: syntax");
    EXPECT_EQ(error("{\"schema\": NaN}"), "osculo: -: line 1, column 12: syntax");
    EXPECT_EQ(error(std::string(100'000, '[')), "osculo: -: nested deeper than 32 lev");
    EXPECT_EQ(error("\x89PNG\r\n\x1a\n"), "osculo: -: line 1, column 1: syntax ");
}

TEST(InvalidScene, OptionsAndPresets) {
    expect_error(osculo({"run", "preset:box", "--time", "-1"}), 3,
                 "preset:box: limits.time: must be > 0 and finite, but it is -1");
    expect_error(
        osculo({"run", "preset:bx"}), 3,
        "preset:bx: preset: must be the name of a preset, did you mean box?, but it is bx");
    expect_error(osculo({"presets", "cradle", "--balls", "2"}), 3,
                 "preset:cradle: balls: must be from 3 to 15, but it is 2");
    const osculo::Scene scene = presets::make("box");
    const std::string run = osculo({"run", "preset:box", "-o", "-", "-q"}).out;
    expect_error(osculo({"run", "-"}, run), 3,
                 "-: schema: must be osculo/scene-1, but it is \"osculo/run-1\"");
}

TEST(InputOutput, UnreadableFiles) {
    const TemporaryDirectory directory;
    expect_error(osculo({"run", directory / "none.json"}), 4,
                 "cannot read " + (directory / "none.json") + ": No such file or directory");
    expect_error(osculo({"validate", directory / ""}), 4,
                 "cannot read " + (directory / "") + ": Is a directory");
}

TEST(InputOutput, UnwritableFiles) {
    const TemporaryDirectory directory;
    const std::string path = directory / "none/run.json";
    expect_error(osculo({"run", "preset:box", "-o", path}), 4,
                 "cannot write " + path + ": No such file or directory");
    expect_error(osculo({"run", "preset:box", "-o", directory / ""}), 4,
                 "cannot write " + (directory / "") + ": Is a directory");
}

TEST(InputOutput, FullDevice) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
    expect_error(osculo({"run", "preset:box", "-o", "/dev/full"}), 4,
                 "cannot write /dev/full: No space left on device");
    expect_error(shell("$OSCULO presets > /dev/full"), 4,
                 "cannot write standard output: No space left on device");
}

}  // namespace
}  // namespace osculo::cli::test

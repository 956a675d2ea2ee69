#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/batch/npz.hpp"
#include "osculo/io.hpp"
#include "osculo/shots.hpp"
#include "process.hpp"
#include "support/batches.hpp"

// Batches from files to files.
namespace osculo::cli::test {
namespace {

using osculo::test::pool_scene;
using osculo::test::random_strikes;

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
}

std::string text_of(double x) {
    std::ostringstream text;
    text.precision(17);
    text << x;
    return text.str();
}

std::string json_line(const Strike& strike) {
    std::string line = "{\"speed\": " + text_of(strike.speed) +
                       ", \"azimuth\": " + text_of(strike.azimuth) + ", \"offset\": [" +
                       text_of(strike.side) + ", " + text_of(strike.height) + "]";
    if (!std::isnan(strike.elevation)) line += ", \"elevation\": " + text_of(strike.elevation);
    return line + "}\n";
}

std::string csv_line(const Strike& strike) {
    return text_of(strike.azimuth) + "," + text_of(strike.speed) + "," + text_of(strike.side) +
           "," + text_of(strike.height) + "," +
           (std::isnan(strike.elevation) ? "" : text_of(strike.elevation)) + "\n";
}

/// A table and shots as files, and what should come of them.
class BatchFiles : public testing::Test {
protected:
    BatchFiles() {
        write(table, io::scene_to_json(scene));
        std::string lines = "{\"schema\": \"osculo/shots-1\"}\n";
        std::string csv = "azimuth, speed, a, b, elevation\n";
        for (const Strike& strike : strikes) {
            lines += json_line(strike);
            csv += csv_line(strike);
        }
        write(shots, lines);
        write(directory / "shots.csv", csv);
    }

    [[nodiscard]] std::string expected(io::OutcomeFormat format) const {
        const BatchResult result = simulate_batch(scene, strikes);
        std::string text = io::outcomes_header(format, scene, {});
        for (std::size_t i = 0; i < strikes.size(); ++i) {
            io::append_outcome(text, format, scene, result, i, i, "");
        }
        return text;
    }

    [[nodiscard]] Result batch(const std::string& out, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"batch", table, shots, "-o", directory / out});
        return osculo(options);
    }
    [[nodiscard]] std::string content(const std::string& name) {
        return content_of(directory / name);
    }

    TemporaryDirectory directory;
    Scene scene = pool_scene(6);
    std::vector<Strike> strikes = random_strikes(40, 1);
    std::string table = directory / "table.json";
    std::string shots = directory / "shots.jsonl";
};

TEST_F(BatchFiles, AreWhatTheLibraryComputes) {
    const std::string json = expected(io::OutcomeFormat::json);
    const std::string csv = expected(io::OutcomeFormat::csv);
    const Result result = batch("out.jsonl");
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(content("out.jsonl"), json);
    for (const char* threads : {"1", "2", "5"}) {
        EXPECT_EQ(batch("out.csv", {"--threads", threads}).code, 0);
        EXPECT_EQ(content("out.csv"), csv);
    }
    EXPECT_EQ(osculo({"batch", table, "-"}, content("shots.jsonl")).out, json);
    EXPECT_EQ(osculo({"batch", table, directory / "shots.csv"}).out, json);
    // Every line is JSON with the members that the README lists.
    std::istringstream lines(json);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_NO_THROW((void)io::msgpack_from_json(line)) << line;
    }
    EXPECT_EQ(directory.file_count(), 5U);
}

TEST_F(BatchFiles, OfShardsMergeToTheSameBytes) {
    for (const char* end : {".jsonl", ".csv", ".npz"}) {
        const std::string all = std::string("all") + end;
        ASSERT_EQ(batch(all).code, 0);
        for (const int n : {1, 3, 7, 45}) {  // 45: more than there are shots
            if (n == 45 && std::string(end) != ".jsonl") continue;
            std::vector<std::string> merge{"merge", "-o", directory / (std::string("m") + end)};
            std::string together;
            for (int i = 1; i <= n; ++i) {
                const std::string shard = std::to_string(i) + '/' + std::to_string(n);
                const std::string part = std::to_string(i) + end;
                ASSERT_EQ(batch(part, {"--shard", shard}).code, 0) << shard;
                together += content(part);
                merge.push_back(directory / part);
            }
            ASSERT_EQ(osculo(merge).code, 0);
            EXPECT_TRUE(content(std::string("m") + end) == content(all)) << n;
            if (std::string(end) == ".npz") continue;
            EXPECT_TRUE(together == content(all)) << n;
        }
    }
}

TEST_F(BatchFiles, ReportBrokenLinesAndGoOn) {
    const std::string good = content_of(shots);
    std::istringstream in(good);
    std::string broken;
    std::string line;
    std::getline(in, line);  // no header
    for (int i = 1; std::getline(in, line); ++i) {
        if (i == 3) broken += "{\"speed\": 1, \"azimut\": 2}\n\n";
        if (i == 5) broken += "{\"speed\": 1,\n";
        if (i == 6) broken += "{\"speed\": -1, \"azimuth\": 1}\n";
        if (i == 7) broken += "{\"balls\": [{\"id\": \"cue\", \"position\": [0.5, 0.5]}]}\n";
        broken += line + '\n';
    }
    write(shots, broken);
    const Result result = batch("out.jsonl");
    EXPECT_EQ(result.code, 3);
    EXPECT_TRUE(contains(result.err, "line 3: azimut: unknown key, did you mean azimuth?"))
        << result.err;
    EXPECT_TRUE(contains(result.err, "line 7: line 1, column ")) << result.err;
    EXPECT_TRUE(contains(result.err, ": line 9: cue.speed: must be > 0, but it is -1\n"))
        << result.err;
    EXPECT_TRUE(contains(result.err, "line 11: shot: must be a strike")) << result.err;
    EXPECT_TRUE(contains(result.err, "osculo: 4 of 44 shots are invalid\n"));
    // The others are as they were, but for their numbers.
    std::istringstream outcomes(content("out.jsonl"));
    std::istringstream undisturbed(expected(io::OutcomeFormat::json));
    std::getline(outcomes, line);
    std::getline(undisturbed, line);
    int invalid = 0;
    int shot = 0;
    for (std::string other; std::getline(outcomes, line); ++shot) {
        EXPECT_TRUE(line.starts_with("{\"shot\": " + std::to_string(shot) + ", "));
        if (contains(line, "\"invalid\"")) {
            EXPECT_TRUE(contains(line, "\"error\": \""));
            ++invalid;
            continue;
        }
        std::getline(undisturbed, other);
        EXPECT_EQ(line.substr(line.find("\"status\"")), other.substr(other.find("\"status\"")));
    }
    EXPECT_EQ(invalid, 4);
    EXPECT_EQ(shot, 44);

    const Result strict = batch("strict.jsonl", {"--strict"});
    EXPECT_EQ(strict.code, 3);
    EXPECT_EQ(std::ranges::count(content("strict.jsonl"), '\n'), 1 + 2);
    EXPECT_TRUE(content("out.jsonl").starts_with(content("strict.jsonl")));
}

TEST_F(BatchFiles, AreGoneOnWith) {
    for (const char* end : {".jsonl", ".csv"}) {
        const std::string name = std::string("out") + end;
        const std::string all =
            expected(end == std::string(".csv") ? io::OutcomeFormat::csv : io::OutcomeFormat::json);
        // What a crash leaves, cut off anywhere; and what an interrupt leaves.
        for (const std::size_t size : {std::size_t{0}, std::size_t{5}, all.size() / 3,
                                       all.size() / 2, all.size() - 1, all.size()}) {
            write(directory / (name + ".part"), all.substr(0, size));
            EXPECT_EQ(batch(name, {"--resume"}).code, 0);
            EXPECT_TRUE(content(name) == all) << size;
            write(directory / name, all.substr(0, all.rfind('\n', size) + 1));
            EXPECT_EQ(batch(name, {"--resume"}).code, 0);
            EXPECT_TRUE(content(name) == all) << size;
        }
    }
    // With the first shots only, then with all.
    ASSERT_EQ(batch("all.npz").code, 0);
    const std::string lines = content_of(shots);
    write(shots, lines.substr(0, lines.find('\n', lines.size() / 2) + 1));
    ASSERT_EQ(batch("out.npz").code, 0);
    EXPECT_NE(content("out.npz"), content("all.npz"));
    write(shots, lines);
    ASSERT_EQ(batch("out.npz", {"--resume"}).code, 0);
    EXPECT_TRUE(content("out.npz") == content("all.npz"));
    // Nothing there yet; and a shard.
    EXPECT_EQ(batch("new.jsonl", {"--resume"}).code, 0);
    EXPECT_TRUE(content("new.jsonl") == expected(io::OutcomeFormat::json));
    ASSERT_EQ(batch("part.jsonl", {"--shard", "2/3"}).code, 0);
    const std::string part = content("part.jsonl");
    write(directory / "part.jsonl", part.substr(0, part.find('\n', part.size() / 2) + 1));
    ASSERT_EQ(batch("part.jsonl", {"--shard", "2/3", "--resume"}).code, 0);
    EXPECT_EQ(content("part.jsonl"), part);
}

TEST_F(BatchFiles, AreNotGoneOnWithIfTheyAreOfSomethingElse) {
    for (const char* name : {"out.jsonl", "out.npz"}) {
        ASSERT_EQ(batch(name).code, 0);
        const std::string before = content(name);
        const Result other = batch(name, {"--resume", "--time", "1"});
        EXPECT_EQ(other.code, 4);
        EXPECT_TRUE(contains(other.err, "cannot be resumed")) << other.err;
        EXPECT_EQ(content(name), before);
    }
    const Result shard = batch("out.jsonl", {"--resume", "--shard", "2/2"});
    EXPECT_EQ(shard.code, 4);
    EXPECT_FALSE(std::filesystem::exists(directory / "out.jsonl.part"));
    EXPECT_TRUE(contains(shard.err, "shot 20 is not where it should be")) << shard.err;
}

TEST_F(BatchFiles, ArePlayedOnAfterAnInterrupt) {
    const std::string lines = content_of(shots).substr(content_of(shots).find('\n') + 1);
    std::string many;
    for (int i = 0; i < 150; ++i) many += lines;
    write(shots, many);
    ASSERT_EQ(batch("all.jsonl").code, 0);
    const std::string all = content("all.jsonl");
    // Interrupted once the first outcomes are there: more than the header, which comes before the
    // program listens. It may be done by then, rarely.
    const std::string out = directory / "out.jsonl";
    const std::string line = "$OSCULO batch '" + table + "' '" + shots + "' -o '" + out +
                             "' & until [ \"$(wc -l < '" + out +
                             ".part')\" -gt 1 ]; do kill -0 $! || break; sleep 0.002; done "
                             "2> /dev/null; kill -INT $!; wait $!";
    Result result;
    std::string part = all;
    for (int attempt = 0; attempt < 10 && part == all; ++attempt) {
        std::filesystem::remove(out);
        result = shell(line);
        part = content("out.jsonl");
    }
    ASSERT_EQ(result.code, 130) << result.err;
    EXPECT_TRUE(contains(result.err, "osculo: interrupted after ")) << result.err;
    EXPECT_TRUE(contains(result.err, " shots; the same command with --resume goes on\n"));
    EXPECT_GT(std::ranges::count(part, '\n'), 1);
    EXPECT_LT(part.size(), all.size());
    EXPECT_TRUE(part.ends_with("\n"));
    EXPECT_TRUE(all.starts_with(part));
    EXPECT_EQ(batch("out.jsonl", {"--resume"}).code, 0);
    EXPECT_TRUE(content("out.jsonl") == all);
}

NpyArray doubles(const double* data, const std::vector<std::size_t>& shape) {
    std::size_t count = 1;
    for (const std::size_t n : shape) count *= n;
    std::string bytes(reinterpret_cast<const char*>(data), count * sizeof(double));
    return {byte_order() + std::string("f8"), shape, std::move(bytes)};
}

TEST_F(BatchFiles, MayBeArrays) {
    const NamedArrays arrays{{"strikes", doubles(&strikes[0].speed, {strikes.size(), 5})}};
    write(directory / "shots.npz", npz_from_arrays(arrays));
    const Result result = osculo({"batch", table, directory / "shots.npz"});
    EXPECT_EQ(result.out, expected(io::OutcomeFormat::json)) << result.err;

    // Columns as in a BatchResult.
    ASSERT_EQ(batch("out.npz").code, 0);
    const NamedArrays outcomes = read_npz(directory / "out.npz");
    const BatchResult expected_result = simulate_batch(scene, strikes);
    const NpyArray* const position = find_array(outcomes, "position");
    ASSERT_NE(position, nullptr);
    EXPECT_EQ(position->shape, (std::vector<std::size_t>{40, 7, 2}));
    EXPECT_EQ(std::memcmp(position->bytes.data(), expected_result.position.data(),
                          position->bytes.size()),
              0);
    const NpyArray* const rim = find_array(outcomes, "rim");
    EXPECT_EQ(rim->type, byte_order() + std::string("i4"));
    EXPECT_EQ(std::memcmp(rim->bytes.data(), expected_result.rim.data(), rim->bytes.size()), 0);

    write(directory / "shots.npz",
          npz_from_arrays({{"strikes", doubles(&strikes[0].speed, {4, 4})}}));
    EXPECT_TRUE(contains(osculo({"batch", table, directory / "shots.npz"}).err,
                         "strikes: must be shots x 5 of float64"));
    write(directory / "shots.npz", "nonsense");
    EXPECT_EQ(osculo({"batch", table, directory / "shots.npz"}).code, 4);
}

TEST_F(BatchFiles, MayBeStarts) {
    constexpr std::size_t kShots = 12;
    const auto states = osculo::test::random_states(scene, kShots, 3);
    std::vector<std::uint8_t> present(states.size(), 1);
    std::string lines;
    for (std::size_t shot = 0; shot < kShots; ++shot) {
        lines += "{\"balls\": [";
        std::string between;
        for (std::size_t i = scene.balls.size(); i-- > 0;) {
            const std::size_t k = shot * scene.balls.size() + i;
            present[k] = k % 5 != 0;
            if (present[k] == 0) continue;
            const BallState& s = states[k];
            lines += between + "{\"id\": \"" + scene.balls[i].id + "\", \"position\": [" +
                     text_of(s.position.x) + ", " + text_of(s.position.y) + "], \"velocity\": [" +
                     text_of(s.velocity.x) + ", " + text_of(s.velocity.y) + "], \"spin\": [" +
                     text_of(s.spin[0]) + ", " + text_of(s.spin[1]) + ", " + text_of(s.spin[2]) +
                     "]}";
            between = ", ";
        }
        lines += "]}\n";
    }
    write(shots, "nonsense\n" + lines);
    const BatchResult result = simulate_batch(scene, Starts{states, present});
    std::string expected_text = io::outcomes_header(io::OutcomeFormat::csv, scene, {});
    for (std::size_t i = 0; i < kShots; ++i) {
        io::append_outcome(expected_text, io::OutcomeFormat::csv, scene, result, i, i + 1, "");
    }
    EXPECT_EQ(batch("out.csv").code, 3);
    const std::string out = content("out.csv");
    const std::size_t first = out.find('\n') + 1;
    const std::size_t second = out.find('\n', first) + 1;
    EXPECT_TRUE(contains(out.substr(first, second - first), "0,invalid,"));
    EXPECT_EQ(out.substr(0, first) + out.substr(second), expected_text);

    const NpyArray there{"|u1", {kShots, scene.balls.size()}, {present.begin(), present.end()}};
    write(directory / "starts.npz",
          npz_from_arrays(
              {{"states", doubles(&states[0].position.x, {kShots, 7, 7})}, {"present", there}}));
    EXPECT_EQ(std::ranges::count(osculo({"batch", table, directory / "starts.npz"}).out, '\n'),
              1 + int{kShots});
}

TEST_F(BatchFiles, RefuseWhatMakesNoSense) {
    const auto error = [&](const std::vector<std::string>& options) {
        const Result result = batch("out.jsonl", options);
        EXPECT_NE(result.code, 0);
        return result.err;
    };
    EXPECT_TRUE(contains(error({"--shard", "0/3"}), "--shard: must be i/n with i from 1 to n"));
    EXPECT_TRUE(contains(error({"--shard", "4/3"}), "--shard: must be i/n"));
    EXPECT_TRUE(contains(error({"--shard", "x"}), "--shard: must be i/n"));
    EXPECT_TRUE(contains(error({"--time", "-1"}), "limits.time: must be > 0"));
    EXPECT_EQ(osculo({"batch", table, "-", "--shard", "1/2"}).code, 2);
    EXPECT_EQ(osculo({"batch", table, directory / "none.jsonl"}).code, 4);
    EXPECT_EQ(osculo({"batch", directory / "none.json", shots}).code, 4);
    write(directory / "bad.csv", "speed,azimut\n1,2\n");
    EXPECT_TRUE(contains(osculo({"batch", table, directory / "bad.csv"}).err,
                         "line 1: unknown column \"azimut\""));
    write(shots, "{\"schema\": \"osculo/shots-9\"}\n");
    EXPECT_TRUE(contains(error({}), "line 1: schema: must be osculo/shots-1"));
    Scene rolling = scene;
    rolling.motion = RollingMotion{};
    rolling.impacts = {};
    write(table, io::scene_to_json(rolling));
    write(shots, "{\"speed\": 1, \"azimuth\": 2}\n");
    EXPECT_TRUE(contains(error({}), "cue: needs balls with spin")) << error({});
    EXPECT_EQ(osculo({"merge", directory / "none.npz"}).code, 4);
}

}  // namespace
}  // namespace osculo::cli::test

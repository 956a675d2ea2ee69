#include <filesystem>

#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "process.hpp"

// Runs that are stopped, kept in a file, and gone on with.
namespace osculo::cli::test {
namespace {

bool contains(const std::string& text, const std::string& what) {
    return text.find(what) != std::string::npos;
}

TEST(Snapshot, GoesOnToTheSameBytes) {
    const TemporaryDirectory directory;
    const std::string whole = directory / "whole.json";
    const std::string parts = directory / "parts.json";
    const std::string file = directory / "snapshot";
    ASSERT_EQ(osculo({"run", "preset:break", "-o", whole, "--audit"}).code, 0);
    const Result first =
        osculo({"run", "preset:break", "--audit", "--time", "0.5", "--snapshot", file});
    EXPECT_EQ(first.code, 0);
    EXPECT_TRUE(first.out.starts_with("preset:break: time limit reached at 0.5 s, after "))
        << first.out;
    EXPECT_EQ(osculo({"run", file, "--events", "90", "--snapshot", file}).code, 1);
    const Result last = osculo({"run", file, "-o", parts});
    EXPECT_EQ(last.code, 0);
    EXPECT_TRUE(last.out.starts_with(file + ": everything at rest at ")) << last.out;
    EXPECT_EQ(content_of(parts), content_of(whole));
    // A stop is a run with that limit, whether it is kept or not.
    ASSERT_EQ(osculo({"run", "preset:break", "--time", "0.5", "-o", whole}).code, 0);
    ASSERT_EQ(
        osculo({"run", "preset:break", "--time", "0.5", "-o", parts, "--snapshot", file}).code, 0);
    EXPECT_EQ(content_of(parts), content_of(whole));
    EXPECT_EQ(directory.file_count(), 3U);
}

TEST(Snapshot, GoesOnBeyondTheLimitItHad) {
    const TemporaryDirectory directory;
    const std::string file = directory / "snapshot";
    const std::string name = "preset:frictionless-break";  // ends at 10 s
    ASSERT_EQ(osculo({"run", name, "--snapshot", file}).code, 0);
    EXPECT_EQ(osculo({"run", file, "--time", "12", "-o", "-"}).out,
              osculo({"run", name, "--time", "12", "-o", "-"}).out);
    EXPECT_EQ(osculo({"run", file, "-o", "-"}).out, osculo({"run", name, "-o", "-"}).out);
    // From stream to stream.
    const Result stream = osculo({"run", name, "--time", "3", "--snapshot", "-"});
    EXPECT_TRUE(io::is_snapshot(stream.out));
    EXPECT_TRUE(contains(stream.err, "time limit reached at 3 s"));
    EXPECT_EQ(osculo({"run", "-", "-o", "-"}, stream.out).out,
              osculo({"run", name, "-o", "-"}).out);
}

TEST(Snapshot, IsWrittenAtAnInterrupt) {
    const TemporaryDirectory directory;
    const std::string file = directory / "snapshot";
    Scene scene = presets::make("gas");
    scene.limits = {1e9, 1'000'000'000};
    write(directory / "gas.json", io::scene_to_json(scene));
    // Interrupted while it plays: once it has used half a second of processor time, or more.
    const Result stopped =
        shell("$OSCULO run '" + (directory / "gas.json") + "' --record none --snapshot '" + file +
              "' & until [ \"$(cut -d' ' -f14 /proc/$!/stat)\" -ge 50 ]; do kill -0 $! || break; "
              "sleep 0.01; done; "
              "kill -INT $!; wait $!");
    EXPECT_EQ(stopped.code, 130);
    EXPECT_TRUE(contains(stopped.err, "osculo: interrupted at ")) << stopped.err;
    EXPECT_TRUE(contains(stopped.err, " events; osculo run " + file + " goes on\n"));
    const std::uint64_t events =
        io::simulation_from_snapshot(content_of(file)).event_count() + 1000;
    const auto run_to = [&](const std::string& what) {
        const Result result = osculo(
            {"run", what, "--record", "none", "--events", std::to_string(events), "-o", "-"});
        return result.out;
    };
    const Result went_on = osculo({"run", file, "--events", std::to_string(events), "-o", "-"});
    EXPECT_EQ(went_on.code, 1);
    EXPECT_TRUE(went_on.out == run_to(directory / "gas.json"));
    EXPECT_EQ(run_to(file), "");  // refused: see below
}

TEST(Snapshot, ThatCannotBeGoneOnWithIsAnError) {
    const TemporaryDirectory directory;
    const std::string file = directory / "snapshot";
    ASSERT_EQ(osculo({"run", "preset:cradle", "--time", "1", "--snapshot", file}).code, 0);
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--precision", "quad"},
                                                    {"--record", "none"},
                                                    {"--audit"},
                                                    {"--certify"}}) {
        std::vector<std::string> words{"run", file};
        words.insert(words.end(), options.begin(), options.end());
        const Result result = osculo(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.err, "osculo: " + options[0] + ": " + file +
                                  " is a snapshot, which goes on as it was begun\n");
    }
    EXPECT_EQ(osculo({"run", file, "--time", "-1"}).code, 3);
    const Result other = osculo({"validate", file});
    EXPECT_EQ(other.code, 3);
    std::string bytes = content_of(file);
    bytes[bytes.size() / 2] ^= 4;
    write(file, bytes);
    const Result damaged = osculo({"run", file});
    EXPECT_EQ(damaged.code, 3);
    EXPECT_EQ(damaged.err,
              "osculo: " + file + ": is damaged: its checksum is not that of its content\n");
    EXPECT_EQ(osculo({"run", "preset:cradle", "--snapshot", directory / "no/s"}).code, 4);
}

}  // namespace
}  // namespace osculo::cli::test

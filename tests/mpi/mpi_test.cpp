#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/process.hpp"
#include "osculo/io.hpp"
#include "support/batches.hpp"

// Several ranks on one machine write what one process writes.
namespace osculo::cli::test {
namespace {

/// Ranks may be more than processors, and tests may run as root in a container.
const std::string kMpirun =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe ";

class MpiBatch : public testing::Test {
protected:
    MpiBatch() {
        write(directory / "table.json", io::scene_to_json(osculo::test::pool_scene(6)));
        write_shots(1500);
    }

    void write_shots(std::size_t count) {
        std::ostringstream lines;
        lines.precision(17);
        for (const Strike& s : osculo::test::random_strikes(count, 5)) {
            lines << "{\"speed\": " << s.speed << ", \"azimuth\": " << s.azimuth << "}\n";
        }
        write(directory / "shots.jsonl", lines.str());
    }

    [[nodiscard]] std::string arguments(const std::string& out) const {
        return " batch '" + (directory / "table.json") + "' '" + (directory / "shots.jsonl") +
               "' -o '" + (directory / out) + "' ";
    }
    [[nodiscard]] Result one(const std::string& out) const {
        return shell("$OSCULO" + arguments(out));
    }
    [[nodiscard]] Result ranks(int n, const std::string& out, const std::string& more = {}) const {
        return shell(kMpirun + "-n " + std::to_string(n) + " " + OSCULO_MPI_PROGRAM +
                     arguments(out) + more);
    }
    /// Four ranks, of which the last one is killed once there are outcomes.
    [[nodiscard]] Result ranks_with_a_death(const std::string& options) const {
        return shell(
            "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; mpirun "
            "--oversubscribe -n 4 " +
            options + OSCULO_MPI_PROGRAM + arguments("out.jsonl") +
            "& run=$!; until [ \"$(wc -l < '" + (directory / "out.jsonl.part") +
            "')\" -gt 1 ]; do kill -0 $run || break; sleep 0.002; done 2> /dev/null; "
            "kill -KILL $(pgrep -P $run | tail -1); wait $run");
    }
    [[nodiscard]] std::string content(const std::string& name) const {
        return content_of(directory / name);
    }

    TemporaryDirectory directory;
};

TEST_F(MpiBatch, WritesTheBytesOfOneProcess) {
    for (const std::string end : {".jsonl", ".npz"}) {
        ASSERT_EQ(one("one" + end).code, 0);
        for (const int n : {1, 2, 3, 4}) {
            const Result result = ranks(n, "ranks" + end);
            ASSERT_EQ(result.code, 0) << result.err;
            EXPECT_TRUE(content("ranks" + end) == content("one" + end)) << n;
        }
    }
    EXPECT_EQ(ranks(3, "threads.jsonl", "--threads 2").code, 0);
    EXPECT_TRUE(content("threads.jsonl") == content("one.jsonl"));
}

TEST_F(MpiBatch, GoesOnWithWhatIsThere) {
    ASSERT_EQ(one("one.jsonl").code, 0);
    const std::string all = content("one.jsonl");
    write(directory / "part.jsonl", all.substr(0, all.find('\n', all.size() / 3) + 1));
    ASSERT_EQ(ranks(3, "part.jsonl", "--resume").code, 0);
    EXPECT_TRUE(content("part.jsonl") == all);
}

TEST_F(MpiBatch, SaysWhatIsWrong) {
    std::string lines = content("shots.jsonl");
    write(directory / "shots.jsonl", "broken\n" + lines);
    const Result broken = ranks(3, "out.jsonl");
    EXPECT_EQ(broken.code, 3);
    EXPECT_NE(broken.err.find("line 1: line 1, column 1: "), std::string::npos) << broken.err;
    EXPECT_EQ(std::ranges::count(content("out.jsonl"), '\n'), 1 + 1 + 1500);
    write(directory / "table.json", "{}");
    const Result bad = ranks(3, "bad.jsonl");
    EXPECT_NE(bad.code, 0);
    EXPECT_NE(bad.err.find("schema: must be given"), std::string::npos) << bad.err;
}

// A rank is killed once the first outcomes are written: mpirun ends them all, what is written is
// whole, what is not is listed, and --resume plays it.
TEST_F(MpiBatch, OutlivesTheDeathOfARank) {
    write_shots(20000);
    ASSERT_EQ(one("one.jsonl").code, 0);
    const std::string all = content("one.jsonl");
    // mpirun gives the others a second to say what they have to: on a busy machine too little.
    Result killed;
    for (int attempt = 0; attempt < 5 && killed.err.find("osculo-mpi: ") == std::string::npos;
         ++attempt) {
        std::filesystem::remove(directory / "out.jsonl");
        killed = ranks_with_a_death("");
        EXPECT_NE(killed.code, 0);
        EXPECT_TRUE(all.starts_with(content("out.jsonl.part")));
    }
    EXPECT_NE(killed.err.find("osculo-mpi: interrupted, or a rank has died"), std::string::npos);
    EXPECT_NE(killed.err.find(" were handed out and are not written"), std::string::npos);
    EXPECT_NE(killed.err.find(" has not answered\n"), std::string::npos) << killed.err;
    const std::string part = content("out.jsonl");
    EXPECT_TRUE(all.starts_with(part));
    EXPECT_LT(part.size(), all.size());
    EXPECT_NE(
        killed.err.find("shots " + std::to_string(std::ranges::count(part, '\n') - 1) + " to "),
        std::string::npos)
        << killed.err;
    ASSERT_EQ(ranks(3, "out.jsonl", "--resume").code, 0);
    EXPECT_TRUE(content("out.jsonl") == all);
}

// If mpirun lets the others live, they play what it had.
TEST_F(MpiBatch, PlaysTheShotsOfADeadRank) {
    write_shots(20000);
    ASSERT_EQ(one("one.jsonl").code, 0);
    const Result killed = ranks_with_a_death("--enable-recovery ");
    EXPECT_NE(killed.err.find(" has not answered; others have played its shots\n"),
              std::string::npos)
        << killed.err;
    EXPECT_TRUE(content("out.jsonl") == content("one.jsonl"));
}

}  // namespace
}  // namespace osculo::cli::test

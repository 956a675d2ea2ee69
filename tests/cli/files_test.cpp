#include <gtest/gtest.h>
#include <sys/stat.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "process.hpp"

// Files are whole or not there; pipes and signals end quietly.
namespace osculo::cli::test {
namespace {

TEST(Files, AreReplacedWhole) {
    const TemporaryDirectory directory;
    const std::string path = directory / "scene.json";
    write(path, "old");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    EXPECT_EQ(osculo({"presets", "pi", "-o", path}).code, 0);
    EXPECT_EQ(content_of(path), io::scene_to_json(presets::make("pi")));
    EXPECT_EQ(directory.file_count(), 1U);
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(Files, OldOnesStayIfTheNewOneFails) {
    const TemporaryDirectory directory;
    const std::string path = directory / "run.json";
    write(path, "old");
    EXPECT_EQ(osculo({"run", "preset:box", "--time", "-1", "-o", path}).code, 3);
    // A limit on the size of files: the write fails half-way.
    const Result result =
        shell("trap '' XFSZ; ulimit -f 4; $OSCULO run preset:gas -q -o '" + path + "'");
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.err, "osculo: cannot write " + path + ": File too large\n");
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(directory.file_count(), 1U);
}

TEST(Files, LinksStayLinks) {
    const TemporaryDirectory directory;
    const std::string target = directory / "target.json";
    const std::string link = directory / "link.json";
    write(target, "old");
    std::filesystem::create_symlink("target.json", link);
    EXPECT_EQ(osculo({"presets", "pi", "-o", link}).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(content_of(target), io::scene_to_json(presets::make("pi")));
}

TEST(Pipes, MayBeClosedEarly) {
    const Result head = shell("$OSCULO presets | head -1");
    EXPECT_EQ(head.code, 0);
    EXPECT_EQ(head.err, "");
    // Much more than a pipe holds, and nobody reads.
    const Result none = shell("{ $OSCULO presets gas --balls 100000; echo $? >&2; } | true");
    EXPECT_EQ(none.err, "0\n");
}

TEST(Signals, InterruptEndsWith130AndLeavesNothingBehind) {
    const TemporaryDirectory directory;
    const Result result = shell(
        "timeout --preserve-status -s INT 0.5 $OSCULO run preset:gas --time 1e6 "
        "--events 1000000000 --record none -o '" +
        (directory / "run.json") + "'");
    EXPECT_EQ(result.code, 130);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(directory.file_count(), 0U);
}

}  // namespace
}  // namespace osculo::cli::test

#include <gtest/gtest.h>

#include "process.hpp"

// What the README shows is what comes out.
namespace osculo::cli::test {
namespace {

bool readme_has(const std::string& text) {
    return content_of(OSCULO_README).find(text) != std::string::npos;
}

TEST(Readme, ShowsTheMainJobAsItComesOut) {
    const std::string out = osculo({"run", "preset:break"}).out;
    const std::size_t end = out.find("  engine ");
    ASSERT_NE(end, std::string::npos);
    EXPECT_TRUE(readme_has("```\n" + out.substr(0, end) + "```\n")) << out;
}

TEST(Readme, ShowsTheFileOfTheMainJob) {
    const std::string text = osculo({"presets", "break"}).out;
    EXPECT_TRUE(readme_has("```json\n" + text + "```\n")) << text;
}

}  // namespace
}  // namespace osculo::cli::test

#include "io/document.hpp"

#include <gtest/gtest.h>

#include "osculo/io.hpp"

namespace osculo::io {
namespace {

std::string error_of(std::string_view text) {
    try {
        static_cast<void>(parse_json(text));
        return "no error";
    } catch (const FormatError& error) {
        return error.what();
    }
}

std::string start_of_error(std::string_view text, std::size_t length) {
    return error_of(text).substr(0, length);
}

TEST(Document, BrokenJsonHasLineAndColumn) {
    EXPECT_EQ(start_of_error("", 18), "line 1, column 1: ");
    EXPECT_EQ(start_of_error("{\"a\": 1,\n \"b\": nan}", 19), "line 2, column 8: s");
    EXPECT_EQ(start_of_error("{\n\n  \"a\" 1}", 19), "line 3, column 7: s");
    EXPECT_EQ(error_of("[1e999]"), "line 1, column 6: number overflow parsing '1e999'");
    for (const char* text :
         {"{", "[1, 2", "{\"a\"", "\"text", "tru", "[1,]", "{,}", "01", "+1", "1 2", "NaN",
          "Infinity", "-", "'a'", "\"\x01\"", "\"\xff\"", "/* no */ 1", "\"\\ud800\""}) {
        EXPECT_EQ(start_of_error(text, 5), "line ") << text;
    }
}

TEST(Document, MessagesAreOneShortLine) {
    const std::string error = error_of("[\"" + std::string(1'000'000, 'x') + "\n");
    EXPECT_EQ(start_of_error("[\"" + std::string(1'000'000, 'x') + "\n", 5), "line ");
    EXPECT_LT(error.size(), 300U);
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(Document, DeepNestingIsRefusedNotOverflowed) {
    for (const char* opening : {"[", "{\"a\":"}) {
        std::string text;
        for (int i = 0; i < 1'000'000; ++i) text += opening;
        EXPECT_EQ(error_of(text), "nested deeper than 32 levels");
    }
    EXPECT_EQ(error_of(std::string(32, '[') + std::string(32, ']')), "no error");
}

TEST(Document, NumbersAreExact) {
    const Document document =
        parse_json("[18446744073709551615, -9223372036854775808, 0.1, -0.0, 5e-324, 1e-999]");
    ASSERT_EQ(document.nodes.size(), 7U);
    EXPECT_EQ(document.nodes[0].end(), 7U);
    EXPECT_EQ(document.nodes[1].natural(), 18446744073709551615U);
    EXPECT_EQ(document.nodes[2].integer(), INT64_MIN);
    EXPECT_EQ(document.nodes[3].real(), 0.1);
    EXPECT_EQ(document.nodes[4].payload, std::uint64_t{1} << 63);
    EXPECT_EQ(document.nodes[5].payload, 1U);
    EXPECT_EQ(document.nodes[6].payload, 0U);
}

TEST(Document, KeepsEachTextOnce) {
    const Document document = parse_json(R"({"a": "b", "b": {"a": "a"}})");
    EXPECT_EQ(document.texts.size(), 2U);
    EXPECT_EQ(document.nodes.size(), 4U);
    EXPECT_EQ(document.nodes[2].end(), 4U);
}

}  // namespace
}  // namespace osculo::io

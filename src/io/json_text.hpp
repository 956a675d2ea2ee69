#pragma once

#include <span>
#include <string>
#include <string_view>

#include "osculo/scene.hpp"

namespace osculo::io {

/// JSON being written: one array element per line, everything else on the line of what it is in.
class JsonText {
public:
    JsonText() = default;
    /// Goes on after that text.
    explicit JsonText(std::string text) : text_(std::move(text)) {}

    /// Text that is JSON already: brackets, commas, names.
    void raw(std::string_view text) { text_ += text; }

    /// The shortest decimal number that reads back as the same double. JSON has no infinities and
    /// no NaN: they are written as the texts "inf", "-inf" and "nan".
    void number(double value);
    void number(std::uint64_t value);
    void string(std::string_view value);
    void boolean(bool value) { raw(value ? "true" : "false"); }

    /// A further member of an object, on a line of its own; the value is up to the caller.
    void next_member(std::string_view indent, std::string_view name) {
        raw(",\n");
        raw(indent);
        string(name);
        raw(": ");
    }

    void vector(Point value);        ///< [x, y]
    void vector(const Spin& value);  ///< [x, y, z]

    /// The elements between brackets, each on its own line written by write(element).
    template <class Range, class Write>
    void lines(const Range& elements, std::string_view indent, Write write) {
        raw("[");
        bool first = true;
        for (const auto& element : elements) {
            raw(first ? "\n" : ",\n");
            raw(indent);
            raw("  ");
            write(element);
            first = false;
        }
        if (!first) {
            raw("\n");
            raw(indent);
        }
        raw("]");
    }

    /// The texts between brackets on one line.
    void strings(std::span<const std::string> values);

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    std::string text_;
};

/// True for +0 in every component: such a vector need not be written. (-0 must be.)
[[nodiscard]] bool is_plus_zero(double value);
[[nodiscard]] bool is_plus_zero(Point value);
[[nodiscard]] bool is_plus_zero(const Spin& value);

/// The scene as an object; its lines but the first are indented.
void write_scene(JsonText& json, const Scene& scene, const std::string& indent);

}  // namespace osculo::io

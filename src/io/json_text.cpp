#include "io/json_text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "io/utf8.hpp"

namespace osculo::io {

void JsonText::number(double value) {
    if (std::isnan(value)) return raw("\"nan\"");
    if (std::isinf(value)) return raw(value > 0 ? "\"inf\"" : "\"-inf\"");
    if (value == 0) return raw(std::signbit(value) ? "-0.0" : "0");  // "-0" would be an integer
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    raw({buffer.data(), result.ptr});
}

void JsonText::number(std::uint64_t value) {
    std::array<char, 24> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    raw({buffer.data(), result.ptr});
}

void JsonText::string(std::string_view value) {
    constexpr std::string_view kHex = "0123456789abcdef";
    text_ += '"';
    for (std::size_t at = 0; at < value.size();) {
        const char c = value[at];
        const std::size_t length = utf8_length(value, at);
        if (length == 0) {
            raw(kReplacement);
        } else if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            raw("\\u00");
            text_ += c < 0x10 ? '0' : '1';
            text_ += kHex[static_cast<std::size_t>(c) % 16];
        } else {
            raw(value.substr(at, length));
        }
        at += length == 0 ? 1 : length;
    }
    text_ += '"';
}

void JsonText::vector(Point value) {
    raw("[");
    number(value.x);
    raw(", ");
    number(value.y);
    raw("]");
}

void JsonText::vector(const Spin& value) {
    raw("[");
    number(value[0]);
    raw(", ");
    number(value[1]);
    raw(", ");
    number(value[2]);
    raw("]");
}

void JsonText::strings(std::span<const std::string> values) {
    raw("[");
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) raw(", ");
        string(values[i]);
    }
    raw("]");
}

bool is_plus_zero(double value) {
    return std::bit_cast<std::uint64_t>(value) == 0;
}

bool is_plus_zero(Point value) {
    return is_plus_zero(value.x) && is_plus_zero(value.y);
}

bool is_plus_zero(const Spin& value) {
    return is_plus_zero(value[0]) && is_plus_zero(value[1]) && is_plus_zero(value[2]);
}

}  // namespace osculo::io

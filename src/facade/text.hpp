#pragma once

#include <array>
#include <charconv>
#include <string>

namespace osculo::facade {

/// The shortest text that reads back as x.
[[nodiscard]] inline std::string number_text(double x) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return {buffer.data(), end};
}

/// The parts one after another.
template <class... Parts>
[[nodiscard]] std::string concatenated(const Parts&... parts) {
    std::string text;
    (void(text += parts), ...);
    return text;
}

}  // namespace osculo::facade

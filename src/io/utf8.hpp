#pragma once

#include <cstddef>
#include <string_view>

namespace osculo::io {

/// Length in bytes of the UTF-8 character that starts at text[at], or 0 if none does.
[[nodiscard]] std::size_t utf8_length(std::string_view text, std::size_t at);

/// What stands in for bytes that are not UTF-8, and for characters a format cannot hold.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

}  // namespace osculo::io

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace osculo {

/// The name most like `name`, by edit distance; empty if none is alike enough to be what was meant.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string_view> names);

/// ", did you mean x?" for the nearest name, or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       std::span<const std::string_view> names);

/// `a, b or c`, for the last word " or ".
[[nodiscard]] std::string listed(std::span<const std::string_view> names,
                                 std::string_view last_word, std::string_view quote = "");

}  // namespace osculo

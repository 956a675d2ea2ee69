#include "presets/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace osculo {
namespace {

// Insertions, deletions and replacements that turn a into b, each counting one, and swaps of
// neighbours, the commonest slip, counting one as well.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names) {
    constexpr std::size_t kLongestName = 40;  // nothing longer is a slip of the keyboard
    if (name.size() > kLongestName) return {};
    std::string_view nearest;
    std::size_t nearest_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string_view candidate : names) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < nearest_distance) {
            nearest = candidate;
            nearest_distance = distance;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> names) {
    const std::string_view nearest = nearest_name(name, names);
    if (nearest.empty()) return {};
    return ", did you mean " + std::string(nearest) + "?";
}

std::string listed(std::span<const std::string_view> names, std::string_view last_word,
                   std::string_view quote) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? last_word : ", ";
        text.append(quote).append(names[i]).append(quote);
    }
    return text;
}

}  // namespace osculo

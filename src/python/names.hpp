#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace osculo::python {

/// The names of an enumeration, in its order. What to_string() is asked beyond the last one it
/// answers with a name that it has given before.
template <class Enumeration>
[[nodiscard]] std::vector<std::string_view> names_of() {
    std::vector<std::string_view> names;
    for (unsigned char i = 0; i < 64; ++i) {
        const std::string_view name = to_string(static_cast<Enumeration>(i));
        if (std::ranges::find(names, name) != names.end()) break;
        names.push_back(name);
    }
    return names;
}

}  // namespace osculo::python

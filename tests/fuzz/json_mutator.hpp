#pragma once

#include <string>
#include <string_view>

namespace osculo::fuzz {

/// The document with one node changed: a number made extreme, a word exchanged for another of the
/// schema, an element removed, repeated or moved. Empty if the text is no JSON, and sometimes at
/// random, so that broken text is tried too.
[[nodiscard]] std::string mutated_json(std::string_view text, unsigned seed);

}  // namespace osculo::fuzz

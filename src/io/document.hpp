#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace osculo::io {

enum class NodeKind : std::uint8_t { null, boolean, natural, integer, real, text, array, object };

/// One value. The values inside an array or object follow it directly, up to `end`.
struct Node {
    NodeKind kind = NodeKind::null;
    std::uint32_t key = 0;      ///< of a member of an object: its name in Document::texts
    std::uint64_t payload = 0;  ///< what the functions below read

    [[nodiscard]] bool boolean() const { return payload != 0; }
    [[nodiscard]] std::uint64_t natural() const { return payload; }
    [[nodiscard]] std::int64_t integer() const { return std::bit_cast<std::int64_t>(payload); }
    [[nodiscard]] double real() const { return std::bit_cast<double>(payload); }
    [[nodiscard]] std::size_t text() const { return payload; }  ///< in Document::texts
    [[nodiscard]] std::size_t end() const { return payload; }   ///< in Document::nodes
};

/// A JSON document as one array of nodes, in the order of the text: 16 bytes per value, where a
/// tree of maps takes hundreds, and numbers that are read exactly.
struct Document {
    std::vector<Node> nodes;                                       ///< nodes[0] is the whole
    std::vector<const std::string*> texts;                         ///< each different text once
    std::unordered_map<std::string, std::uint32_t> index_of_text;  ///< owns the texts
    bool is_run = false;  ///< the texts "inf", "-inf" and "nan" may stand for numbers
};

/// Both throw FormatError for input that is broken, has numbers beyond the range of double, or
/// nests deeper than any osculo file does.
[[nodiscard]] Document parse_json(std::string_view text);
[[nodiscard]] Document parse_msgpack(std::string_view bytes);

}  // namespace osculo::io

#include "io/document.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <nlohmann/json.hpp>

#include "io/utf8.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 32;  // ours nest to 6

// Receives what the parser finds, in order, and appends it to a document.
class Builder {
public:
    Builder(std::string_view input, bool is_text) : input_(input), is_text_(is_text) {}

    [[nodiscard]] Document take() { return std::move(document_); }

    // The names of what follows are fixed by the parser.
    bool null() { return add(NodeKind::null, 0); }
    bool boolean(bool value) { return add(NodeKind::boolean, value ? 1 : 0); }
    bool number_integer(std::int64_t value) {
        return add(NodeKind::integer, std::bit_cast<std::uint64_t>(value));
    }
    bool number_unsigned(std::uint64_t value) { return add(NodeKind::natural, value); }
    bool number_float(double value, const std::string& /*source*/) {
        if (!std::isfinite(value)) throw FormatError("a number is infinite or not a number");
        return add(NodeKind::real, std::bit_cast<std::uint64_t>(value));
    }
    bool string(const std::string& value) { return add(NodeKind::text, index_of(value)); }
    bool binary(const json::binary_t& /*value*/) {
        throw FormatError("binary data has no place in an osculo file");
    }
    bool key(const std::string& name) {
        key_ = index_of(name);
        return true;
    }
    bool start_object(std::size_t /*size*/) { return open(NodeKind::object); }
    bool start_array(std::size_t /*size*/) { return open(NodeKind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool parse_error(std::size_t position, const std::string& /*token*/,
                     const json::exception& error) {
        throw FormatError(place(position) + ": " + reason(error.what()));
    }

private:
    bool add(NodeKind kind, std::uint64_t payload) {
        document_.nodes.push_back({kind, key_, payload});
        return true;
    }

    bool open(NodeKind kind) {
        if (open_.size() == kDeepest) {
            throw FormatError("nested deeper than " + std::to_string(kDeepest) + " levels");
        }
        open_.push_back(document_.nodes.size());
        return add(kind, 0);
    }

    bool close() {
        document_.nodes[open_.back()].payload = document_.nodes.size();
        open_.pop_back();
        return true;
    }

    std::uint32_t index_of(const std::string& text) {
        const auto found = document_.index_of_text.find(text);
        if (found != document_.index_of_text.end()) return found->second;
        const std::size_t index = document_.texts.size();
        if (index > std::numeric_limits<std::uint32_t>::max()) throw FormatError("too large");
        if (!is_text_) check_utf8(text);  // the parser of JSON text has done so
        const auto [entry, added] =
            document_.index_of_text.emplace(text, static_cast<std::uint32_t>(index));
        document_.texts.push_back(&entry->first);
        return entry->second;
    }

    static void check_utf8(std::string_view text) {
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t length = utf8_length(text, at);
            if (length == 0) throw FormatError("a text is not UTF-8");
            at += length;
        }
    }

    // `position` counts the bytes read, the offending one included.
    [[nodiscard]] std::string place(std::size_t position) const {
        if (!is_text_) return "byte " + std::to_string(position);
        const std::string_view before =
            input_.substr(0, std::min(position > 0 ? position - 1 : 0, input_.size()));
        const auto line = 1 + std::ranges::count(before, '\n');
        const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
        return "line " + std::to_string(line) + ", column " +
               std::to_string(before.size() - line_start + 1);
    }

    // The parser's message without its label and position, on one line of bearable length.
    static std::string reason(std::string message) {
        if (const auto end = message.find("] "); message.starts_with('[') && end != message.npos) {
            message.erase(0, end + 2);
        }
        if (message.starts_with("parse error at")) message.erase(0, message.find(": ") + 2);
        constexpr std::size_t kLongest = 200;
        if (message.size() > kLongest) {
            const std::size_t middle = message.size() - kLongest / 2;
            message = message.substr(0, kLongest / 2) + " ... " + message.substr(middle);
        }
        for (char& c : message) {
            if (static_cast<unsigned char>(c) < 0x20) c = ' ';
        }
        return message;
    }

    Document document_;
    std::string_view input_;
    bool is_text_;
    std::uint32_t key_ = 0;
    std::vector<std::size_t> open_;  // the arrays and objects around what comes next
};

Document parse(std::string_view input, json::input_format_t format) {
    Builder builder(input, format == json::input_format_t::json);
    if (!json::sax_parse(input.begin(), input.end(), &builder, format)) {
        throw FormatError("cannot be read");
    }
    return builder.take();
}

}  // namespace

Document parse_json(std::string_view text) {
    return parse(text, json::input_format_t::json);
}

Document parse_msgpack(std::string_view bytes) {
    return parse(bytes, json::input_format_t::msgpack);
}

}  // namespace osculo::io

#include "io/value.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>

#include "presets/nearest_name.hpp"

namespace osculo::io {
namespace {

template <class T>
std::string number_text(T value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

// For messages: on one line, and not too long.
std::string shown(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string result;
    for (const char c : text.substr(0, kLongest)) {
        result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
    return text.size() > kLongest ? result + "..." : result;
}

}  // namespace

double Value::number() const {
    switch (kind()) {
        case NodeKind::natural: return static_cast<double>(node().natural());
        case NodeKind::integer: return static_cast<double>(node().integer());
        case NodeKind::real: return node().real();
        case NodeKind::text: return number_not_finite();
        default: fail("must be a number");
    }
}

double Value::number_not_finite() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (document_.is_run) {
        if (text() == "inf") return kInfinity;
        if (text() == "-inf") return -kInfinity;
        if (text() == "nan") return std::numeric_limits<double>::quiet_NaN();
    }
    fail("must be a number");
}

std::uint64_t Value::natural() const {
    if (kind() == NodeKind::natural) return node().natural();
    if (kind() == NodeKind::real) {  // 1e6 is a whole number, too
        const double value = node().real();
        if (value >= 0 && value <= 0x1p53 && std::trunc(value) == value) {
            return static_cast<std::uint64_t>(value);
        }
    }
    fail("must be a whole number from 0 to 18446744073709551615");
}

bool Value::boolean() const {
    require(NodeKind::boolean, "must be true or false");
    return node().boolean();
}

std::string_view Value::text() const {
    require(NodeKind::text, "must be a text");
    return *document_.texts[node().text()];
}

std::size_t Value::size() const {
    require(NodeKind::array, "must be an array");
    std::size_t count = 0;
    for (std::size_t i = index_ + 1; i < node().end(); i = next(i)) ++count;
    return count;
}

std::optional<Value> Value::member(std::string_view name) const {
    require(NodeKind::object, "must be an object");
    for (std::size_t i = index_ + 1; i < node().end(); i = next(i)) {
        if (*document_.texts[document_.nodes[i].key] == name) return Value(*this, i, 0);
    }
    return std::nullopt;
}

void Value::fail(const std::string& rule) const {
    fail(rule, described());
}

void Value::fail(const std::string& rule, const std::string& value) const {
    throw SceneError(path(), rule, value);
}

std::string Value::path() const {
    if (parent_ == nullptr) return std::string(name_);
    // Inside the whole document its own name says nothing.
    std::string result = parent_->parent_ == nullptr ? "" : parent_->path();
    if (parent_->kind() == NodeKind::array) return result + '[' + std::to_string(position_) + ']';
    if (!result.empty()) result += '.';
    return result + shown(*document_.texts[node().key]);
}

std::size_t Value::next(std::size_t index) const {
    const Node& at = document_.nodes[index];
    return at.kind == NodeKind::array || at.kind == NodeKind::object ? at.end() : index + 1;
}

void Value::require(NodeKind kind_needed, const char* rule) const {
    if (kind() != kind_needed) fail(rule);
}

std::string Value::described() const {
    switch (kind()) {
        case NodeKind::null: return "null";
        case NodeKind::boolean: return node().boolean() ? "true" : "false";
        case NodeKind::natural: return number_text(node().natural());
        case NodeKind::integer: return number_text(node().integer());
        case NodeKind::real: return number_text(node().real());
        case NodeKind::text: return '"' + shown(*document_.texts[node().text()]) + '"';
        case NodeKind::array: return "an array of length " + std::to_string(size());
        case NodeKind::object: return "an object";
    }
    return {};
}

Fields::Fields(const Value& object, std::span<const std::string_view> known)
    : object_(object), known_(known) {
    assert(known.size() <= kMostFields);
    object.require(NodeKind::object, "must be an object");
    const Document& document = object.document_;
    for (std::size_t i = object.index_ + 1; i < object.node().end(); i = object.next(i)) {
        const std::string& name = *document.texts[document.nodes[i].key];
        const auto which = std::ranges::find(known, name);
        const Value member(object, i, 0);
        if (which == known.end()) member.fail("unknown key" + did_you_mean(name, known), "");
        std::size_t& found = found_[static_cast<std::size_t>(which - known.begin())];
        if (found != 0) member.fail("must be given once", "given twice");
        found = i;
    }
}

std::optional<Value> Fields::find(std::string_view name) const {
    const std::size_t found = found_[index_of(name)];
    if (found == 0) return std::nullopt;
    return Value(object_, found, 0);
}

Value Fields::require(std::string_view name) const {
    const std::size_t found = found_[index_of(name)];
    if (found != 0) return Value(object_, found, 0);
    const std::string path = object_.parent_ == nullptr ? "" : object_.path() + '.';
    throw SceneError(path + std::string(name), "must be given", "missing");
}

std::size_t Fields::index_of(std::string_view name) const {
    const auto which = std::ranges::find(known_, name);
    assert(which != known_.end());
    return static_cast<std::size_t>(which - known_.begin());
}

std::size_t choice(const Value& value, std::span<const std::string_view> available,
                   std::span<const std::string_view> planned) {
    const std::string_view name = value.text();
    const auto which = std::ranges::find(available, name);
    if (which != available.end()) return static_cast<std::size_t>(which - available.begin());

    std::string rule = "must be " + listed(available, " or ");
    if (!planned.empty()) {
        rule += " (" + listed(planned, " and ") + (planned.size() == 1 ? " is" : " are") +
                " not available yet)";
    }
    const bool is_planned = std::ranges::find(planned, name) != planned.end();
    if (available.size() > 1 && !is_planned) rule += did_you_mean(name, available);
    value.fail(rule);
}

}  // namespace osculo::io

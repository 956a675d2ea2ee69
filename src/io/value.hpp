#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/document.hpp"
#include "osculo/run.hpp"
#include "osculo/scene.hpp"

namespace osculo::io {

/// One value of a document, which knows where it stands: what does not fit is reported with its
/// path. A value must not outlive the one it was taken from.
class Value {
public:
    /// The whole document; `name` is what errors call it.
    Value(const Document& document, std::string_view name) : document_(document), name_(name) {}

    [[nodiscard]] NodeKind kind() const { return node().kind; }

    // Each throws SceneError if the value is of another type or out of range.
    [[nodiscard]] double number() const;
    [[nodiscard]] std::uint64_t natural() const;
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] std::string_view text() const;

    /// Calls visit(element) for each element of an array.
    template <class Visit>
    void for_each(Visit visit) const {
        require(NodeKind::array, "must be an array");
        std::size_t position = 0;
        for (std::size_t i = index_ + 1; i < node().end(); i = next(i)) {
            visit(Value(*this, i, position++));
        }
    }

    /// Number of elements of an array; takes time in proportion.
    [[nodiscard]] std::size_t size() const;

    /// An array of exactly N numbers.
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> numbers() const {
        if (kind() != NodeKind::array || size() != N) {
            fail("must be an array of " + std::to_string(N) + " numbers");
        }
        std::array<double, N> result{};
        std::size_t count = 0;
        for_each([&](const Value& element) { result[count++] = element.number(); });
        return result;
    }

    [[nodiscard]] Point point() const {
        const auto [x, y] = numbers<2>();
        return {x, y};
    }

    /// The member of that name of an object, if there is one; says nothing about other members.
    [[nodiscard]] std::optional<Value> member(std::string_view name) const;

    /// Throws SceneError: "path: rule, but it is value".
    [[noreturn]] void fail(const std::string& rule) const;
    [[noreturn]] void fail(const std::string& rule, const std::string& value) const;

    /// E.g. balls[2].mass
    [[nodiscard]] std::string path() const;

private:
    friend class Fields;

    Value(const Value& parent, std::size_t index, std::size_t position)
        : document_(parent.document_), parent_(&parent), index_(index), position_(position) {}

    [[nodiscard]] const Node& node() const { return document_.nodes[index_]; }
    [[nodiscard]] std::size_t next(std::size_t index) const;
    void require(NodeKind kind, const char* rule) const;
    [[nodiscard]] double number_not_finite() const;
    [[nodiscard]] std::string described() const;

    const Document& document_;
    std::string_view name_;          // of the whole document
    const Value* parent_ = nullptr;  // nothing for the whole document
    std::size_t index_ = 0;          // in document_.nodes
    std::size_t position_ = 0;       // in the parent, if that is an array
};

/// The members of an object by name: unknown and repeated ones are refused at once.
class Fields {
public:
    /// `known` must outlive this.
    Fields(const Value& object, std::span<const std::string_view> known);

    /// The member of that known name, if there is one.
    [[nodiscard]] std::optional<Value> find(std::string_view name) const;

    /// The member of that known name; throws SceneError if there is none.
    [[nodiscard]] Value require(std::string_view name) const;

private:
    static constexpr std::size_t kMostFields = 24;

    [[nodiscard]] std::size_t index_of(std::string_view name) const;

    const Value& object_;
    std::span<const std::string_view> known_;
    std::array<std::size_t, kMostFields> found_{};  // nodes; 0 is the whole document: no member
};

/// The text must be one of `available`; gives its place there. Names that are only `planned` are
/// told apart from unknown ones.
std::size_t choice(const Value& value, std::span<const std::string_view> available,
                   std::span<const std::string_view> planned = {});

}  // namespace osculo::io

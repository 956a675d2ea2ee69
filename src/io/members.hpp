#pragma once

#include <string_view>

#include "io/json_text.hpp"
#include "osculo/run.hpp"

namespace osculo::io {

/// Writes one object, its members in a row.
class Members {
public:
    explicit Members(JsonText& json) : json_(json) { json_.raw("{"); }

    // The value is up to the caller.
    void key(std::string_view name) {
        json_.raw(first_ ? "\"" : ", \"");
        json_.raw(name);
        json_.raw("\": ");
        first_ = false;
    }
    template <class Number>
    void number(std::string_view name, Number value) {
        key(name);
        json_.number(value);
    }
    void string(std::string_view name, std::string_view value) {
        key(name);
        json_.string(value);
    }
    template <class Vector>
    void vector(std::string_view name, const Vector& value) {
        key(name);
        json_.vector(value);
    }
    void boolean(std::string_view name, bool value) {
        key(name);
        json_.boolean(value);
    }
    // Left out if zero.
    void low_part(std::string_view name, double value) {
        if (!is_plus_zero(value)) number(name, value);
    }
    template <class Vector>
    void rare(std::string_view name, const Vector& value) {
        if (!is_plus_zero(value)) vector(name, value);
    }
    void state(const BallState& state) {
        vector("position", state.position);
        vector("velocity", state.velocity);
        rare("spin", state.spin);
    }
    void close() { json_.raw("}"); }

private:
    JsonText& json_;
    bool first_ = true;
};

}  // namespace osculo::io

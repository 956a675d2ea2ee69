#pragma once

#include <stdexcept>

namespace osculo::facade {

/// Bytes that are no state of that scene.
class BadState : public std::runtime_error {
public:
    BadState() : std::runtime_error("the state is damaged") {}
};

}  // namespace osculo::facade

#pragma once

#include <cstdint>

#include "osculo/run.hpp"

namespace osculo::python {

/// A FinalBall as a row of an array.
struct FinalBallRow {
    std::int32_t fate;
    std::int32_t rim;  ///< index into scene.rims; -1: not captured
    BallState state;
};

[[nodiscard]] inline FinalBallRow row_of(const FinalBall& ball) {
    return {static_cast<std::int32_t>(ball.fate),
            ball.rim ? static_cast<std::int32_t>(*ball.rim) : -1, ball.state};
}

}  // namespace osculo::python

#include "python/run.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace osculo::python {

RecordedRun::RecordedRun(Run run) : run_(std::move(run)), pieces_of_(run_.balls.size()) {
    for (std::uint32_t i = 0; i < run_.pieces.size(); ++i) {
        pieces_of_[run_.pieces[i].ball].push_back(i);
    }
}

BallState RecordedRun::at(std::uint32_t ball, double time) const {
    const auto& indices = pieces_of_[ball];
    const auto found = std::ranges::lower_bound(
        indices, time, {}, [&](std::uint32_t index) { return run_.pieces[index].to; });
    if (found != indices.end() && run_.pieces[*found].from <= time) {
        return run_.at(run_.pieces[*found], time);
    }
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    return {{kNaN, kNaN}, {kNaN, kNaN}, {kNaN, kNaN, kNaN}};
}

}  // namespace osculo::python

#include "cli/batch/invalid_shots.hpp"

#include <fmt/format.h>

namespace osculo::cli {
namespace {

/// Why a shot is impossible that could be read.
std::string fault_of(const Scene& scene, const ShotBlock& block, std::size_t row) {
    try {
        validate(block.are_starts ? scene_of(scene, Starts{block.states, block.present}, row)
                                  : scene_of(scene, block.strikes[row]));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "is invalid";
}

}  // namespace

std::size_t InvalidShots::report(const Scene& scene, ShotBlock& block, const BatchResult& result,
                                 std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        if (result.status[row] != ShotStatus::invalid) continue;
        std::string& error = block.errors[row];
        if (error.empty()) {
            const std::string place = block.lines.empty()
                                          ? fmt::format("shot {}", block.first + row)
                                          : fmt::format("line {}", block.lines[row]);
            error = place + ": " + fault_of(scene, block, row);
        }
        say(error);
        if (is_strict_) return row;
    }
    return rows;
}

void InvalidShots::say(const std::string& error) {
    constexpr std::uint64_t kMost = 20;
    ++count_;
    if (count_ <= kMost) fmt::print(stderr, "osculo: {}: {}\n", name_, error);
    if (count_ == kMost + 1) fmt::print(stderr, "osculo: and more, see the outcomes\n");
}

}  // namespace osculo::cli

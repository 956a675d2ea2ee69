#pragma once

#include <cstdint>
#include <string>

#include "cli/batch/shot_source.hpp"

namespace osculo::cli {

/// Says on stderr what is wrong with shots that are invalid.
class InvalidShots {
public:
    /// [name]: of their file. If [is_strict], the first one ends it all.
    InvalidShots(std::string name, bool is_strict)
        : name_(std::move(name)), is_strict_(is_strict) {}

    /// Looks at the first [rows] of a block and its result, and fills in the errors. Returns how
    /// many of them are to be written: fewer if the first invalid one ends it all.
    [[nodiscard]] std::size_t report(const Scene& scene, ShotBlock& block,
                                     const BatchResult& result, std::size_t rows);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Whether one has ended it all.
    [[nodiscard]] bool has_ended() const { return is_strict_ && count_ > 0; }

private:
    void say(const std::string& error);

    std::string name_;
    bool is_strict_;
    std::uint64_t count_ = 0;
};

}  // namespace osculo::cli

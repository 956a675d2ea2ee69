#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "osculo/batch.hpp"

namespace osculo::cli {

/// Some shots of a file, all of one kind.
struct ShotBlock {
    std::uint64_t first = 0;  ///< number of the first one in the file, from 0
    bool are_starts = false;
    std::vector<Strike> strikes;
    std::vector<BallState> states;  ///< [shot][ball]
    std::vector<std::uint8_t> present;
    /// Why a shot cannot be played: empty if nothing is known against it. Those that cannot be read
    /// are there, as shots that are invalid.
    std::vector<std::string> errors;
    std::vector<std::uint64_t> lines{};  ///< where they are, from 1, if they are lines

    [[nodiscard]] std::size_t size() const { return errors.size(); }
};

/// Shots from a file, in order.
class ShotSource {
public:
    ShotSource() = default;
    ShotSource(const ShotSource&) = delete;
    ShotSource& operator=(const ShotSource&) = delete;
    virtual ~ShotSource() = default;

    /// The next ones, at most so many; none at the end.
    [[nodiscard]] virtual ShotBlock next(std::size_t most) = 0;
    /// Passes over the next ones.
    virtual void skip(std::uint64_t shots) = 0;
    /// How many there are in the file, if it can be read twice.
    [[nodiscard]] virtual std::optional<std::uint64_t> count() = 0;
};

/// Opens a file of shots by the end of its name: .csv, .npz, or else lines of JSON; "-" is standard
/// input. Throws Failure.
[[nodiscard]] std::unique_ptr<ShotSource> open_shots(const std::string& path, const Scene& scene);

}  // namespace osculo::cli

#pragma once

#include <string>

#include "cli/batch/shot_source.hpp"
#include "osculo/batch.hpp"

namespace osculo::mpi {

// Blocks of shots and their results as messages between ranks on machines of one kind.

/// What it takes to play the block: no errors and lines.
[[nodiscard]] std::string bytes_of(const cli::ShotBlock& block);
[[nodiscard]] cli::ShotBlock block_from(const std::string& bytes);

/// The columns of the outcomes: no events, pieces and states.
[[nodiscard]] std::string bytes_of(const BatchResult& result, std::uint64_t first);
struct BlockResult {
    std::uint64_t first = 0;  ///< number of the block's first shot
    BatchResult result;
};
[[nodiscard]] BlockResult result_from(const std::string& bytes);

}  // namespace osculo::mpi

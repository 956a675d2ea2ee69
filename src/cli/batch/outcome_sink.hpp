#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "osculo/batch.hpp"

namespace osculo::cli {

/// What outcomes belong to.
struct OutcomeFile {
    std::string path;
    std::uint64_t first = 0;  ///< number of its first shot
    bool has_header = true;   ///< of the first shard
    bool resumes = false;     ///< goes on with what is there
};

/// Takes outcomes in order and writes them to a file, which is whole at any time.
class OutcomeSink {
public:
    OutcomeSink() = default;
    OutcomeSink(const OutcomeSink&) = delete;
    OutcomeSink& operator=(const OutcomeSink&) = delete;
    virtual ~OutcomeSink() = default;

    /// Number of shots that were there already.
    [[nodiscard]] virtual std::uint64_t kept() const = 0;
    /// The first [rows] of a result; an error for each that is invalid.
    virtual void write(const BatchResult& result, std::size_t rows, std::uint64_t first,
                       const std::vector<std::string>& errors) = 0;
    /// After the last one, or the last one before an interrupt.
    virtual void finish() = 0;
};

/// Opens a file of outcomes by the end of its name: .csv, .npz, or else lines of JSON; "-" is
/// standard output. Throws Failure, also if what it should go on with is of something else.
[[nodiscard]] std::unique_ptr<OutcomeSink> open_outcomes(const OutcomeFile& file,
                                                         const Scene& scene,
                                                         const BatchOptions& options);

}  // namespace osculo::cli

#pragma once

#include "cli/batch/npz.hpp"
#include "cli/batch/outcome_sink.hpp"

namespace osculo::cli {

/// The columns of a BatchResult as arrays of NumPy, with the numbers of the shots; ids, fingerprint
/// and schema are arrays as well. Kept in memory, and written at once in the end.
class ArraySink final : public OutcomeSink {
public:
    ArraySink(OutcomeFile file, const Scene& scene, const BatchOptions& options);

    [[nodiscard]] std::uint64_t kept() const override { return kept_; }
    void write(const BatchResult& result, std::size_t rows, std::uint64_t first,
               const std::vector<std::string>& errors) override;
    void finish() override;

private:
    void go_on();

    OutcomeFile file_;
    NamedArrays arrays_;
    std::uint64_t kept_ = 0;
};

/// The arrays of all parts, which have to be of the same scene, one after another. Throws Failure.
[[nodiscard]] NamedArrays joined(const std::vector<std::string>& paths);

}  // namespace osculo::cli

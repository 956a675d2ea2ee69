#pragma once

#include "cli/batch/outcome_sink.hpp"
#include "osculo/shots.hpp"

namespace osculo::cli {

/// Lines of JSON or CSV. They are written to FILE.part, which takes the name FILE in the end: what
/// is called FILE is never half-written, and what a crash leaves can be gone on with.
class TextSink final : public OutcomeSink {
public:
    TextSink(OutcomeFile file, io::OutcomeFormat format, const Scene& scene,
             const BatchOptions& options);
    ~TextSink() override;

    [[nodiscard]] std::uint64_t kept() const override { return kept_; }
    void write(const BatchResult& result, std::size_t rows, std::uint64_t first,
               const std::vector<std::string>& errors) override;
    void finish() override;

private:
    void open(const std::string& header);
    /// Bytes in whole lines of what is there, and in kept_ how many are of shots.
    [[nodiscard]] std::uint64_t count_whole(const std::string& path, const std::string& header);
    void append(std::string_view text);

    OutcomeFile file_;
    io::OutcomeFormat format_;
    const Scene& scene_;
    std::string part_;  ///< empty: written to directly
    int descriptor_ = -1;
    std::uint64_t kept_ = 0;
    std::string text_;
};

}  // namespace osculo::cli

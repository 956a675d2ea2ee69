#include "cli/batch/outcome_sink.hpp"

#include "cli/batch/array_sink.hpp"
#include "cli/batch/text_sink.hpp"

namespace osculo::cli {

std::unique_ptr<OutcomeSink> open_outcomes(const OutcomeFile& file, const Scene& scene,
                                           const BatchOptions& options) {
    if (file.path.ends_with(".npz")) return std::make_unique<ArraySink>(file, scene, options);
    const auto format =
        file.path.ends_with(".csv") ? io::OutcomeFormat::csv : io::OutcomeFormat::json;
    return std::make_unique<TextSink>(file, format, scene, options);
}

}  // namespace osculo::cli

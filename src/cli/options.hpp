#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/failure.hpp"
#include "osculo/simulate.hpp"

namespace osculo::cli {

/// --precision and --record, which `run` and `explain` share.
struct EngineOptions {
    std::string precision = "double";
    std::string record;

    void add_to(CLI::App& command, const char* record_default) {
        command.add_option("--precision", precision, "scalar type of the computation")
            ->option_text("double|extended|quad|50|100 [double]")
            ->check(CLI::IsMember({"double", "extended", "quad", "50", "100"}));
        command.add_option("--record", record, "what the run keeps")
            ->option_text(std::string("none|events|pieces [") + record_default + "]")
            ->check(CLI::IsMember({"none", "events", "pieces"}));
    }

    [[nodiscard]] Options options(Record default_record) const {
        Options result;
        result.precision = precision_from_string(precision).value_or(Precision::double_precision);
        result.record = record == "none"     ? Record::none
                        : record == "events" ? Record::events
                        : record == "pieces" ? Record::pieces
                                             : default_record;
        return result;
    }
};

}  // namespace osculo::cli

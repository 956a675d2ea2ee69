#pragma once

#include <cstdio>

#include "support/tally.hpp"

namespace osculo::bench {

/// Writes one line per family; remembers whether all targets were met.
class Report {
public:
    explicit Report(const char* path) : csv_(std::fopen(path, "w")) {
        std::printf("%-12s %-10s %-24s %9s %9s %6s %6s %6s %6s %6s %6s %6s\n", "scalar", "what",
                    "family", "cases", "contacts", "missed", "false", "wrong", "median", "p99",
                    "p99.9", "max");
        if (csv_ != nullptr) {
            std::fputs(
                "scalar,what,family,cases,contacts,missed,false,wrong,"
                "ulp_median,ulp_p99,ulp_p99.9,ulp_max\n",
                csv_);
        }
    }
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;
    ~Report() {
        if (csv_ != nullptr) std::fclose(csv_);
    }

    void line(const char* scalar, const char* what, const char* family, support::Tally& tally) {
        const double p50 = tally.quantile(0.5);
        const double p99 = tally.quantile(0.99);
        const double p999 = tally.quantile(0.999);
        const double most = tally.quantile(1);
        std::printf("%-12s %-10s %-24s %9zu %9zu %6zu %6zu %6zu %6.2f %6.2f %6.2f %6.2f\n", scalar,
                    what, family, tally.cases(), tally.contacts(), tally.missed(), tally.invented(),
                    tally.wrong(), p50, p99, p999, most);
        std::fflush(stdout);
        if (csv_ != nullptr) {
            std::fprintf(csv_, "%s,%s,%s,%zu,%zu,%zu,%zu,%zu,%.4g,%.4g,%.4g,%.4g\n", scalar, what,
                         family, tally.cases(), tally.contacts(), tally.missed(), tally.invented(),
                         tally.wrong(), p50, p99, p999, most);
        }
        met_ = met_ && tally.missed() + tally.invented() + tally.wrong() == 0 && p999 <= 2;
    }

    [[nodiscard]] bool met() const { return met_; }

private:
    std::FILE* csv_;
    bool met_ = true;
};

}  // namespace osculo::bench

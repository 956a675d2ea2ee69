#include "report.hpp"

#include <algorithm>

namespace osculo::bench::stability {
namespace {

std::string text(double x, int digits) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, x);
    return buffer;
}

std::string list(const Values& values, int digits, std::size_t most, const char* between) {
    std::string all;
    for (std::size_t k = 0; k < std::min(values.size(), most); ++k) {
        all += (k > 0 ? between : "") + text(values[k] == 0 ? 0 : values[k], digits);
    }
    if (values.size() > most) all += std::string(between) + "..";
    return all;
}

/// Different words of the rows that were run, in order.
template <class Words>
std::string distinct(const Result& result, Words words) {
    std::vector<std::string> seen;
    for (const Row& row : result.rows) {
        if (row.verdict == Verdict::too_long) continue;
        const std::string word = words(row);
        if (std::find(seen.begin(), seen.end(), word) == seen.end()) seen.push_back(word);
    }
    std::string all;
    for (const std::string& word : seen) all += (all.empty() ? "" : ", ") + word;
    return all;
}

std::string digits_text(const Result& result, std::size_t k) {
    const Row& row = result.rows[k];
    if (row.verdict == Verdict::too_long) return "-";
    if (row.verdict == Verdict::wrong) return "**" + row.why + "**";
    if (result.of.status_only) return "status";
    if (result.target.is_reference && kPrecisions[k] == Precision::digits100 &&
        !result.of.reference) {
        return "ref";
    }
    return text(std::floor(row.digits * 10) / 10, 3);
}

}  // namespace

void write_csv(std::FILE* file, const std::vector<Result>& results) {
    std::fputs(
        "case,family,stiff,simultaneous,precision,source,expected,got,digits,needed,events,"
        "status,audit,seconds,verdict\n",
        file);
    for (const Result& result : results) {
        const Case& c = result.of;
        for (std::size_t k = 0; k < result.rows.size(); ++k) {
            const Row& row = result.rows[k];
            const bool ran = row.verdict != Verdict::too_long;
            const bool numbers = ran && !c.status_only;
            std::fprintf(file, "\"%s\",%s,\"%s\",%s,%s,\"%s\",%s,%s,%s,%s,%s,%s,%s,%s,%s\n",
                         c.name.c_str(), c.family.c_str(), c.stiff.c_str(), kLaws[result.law].name,
                         std::string(to_string(kPrecisions[k])).c_str(),
                         c.status_only                ? "status only"
                         : result.target.is_reference ? "100 digits"
                                                      : c.source.c_str(),
                         list(result.target.values, 17, 999, " ").c_str(),
                         list(row.got, 17, 999, " ").c_str(),
                         numbers ? text(row.digits, 4).c_str() : "",
                         numbers ? text(row.needed, 4).c_str() : "",
                         ran ? std::to_string(row.events).c_str() : "",
                         ran ? std::string(to_string(row.status)).c_str() : "", row.audit.c_str(),
                         ran ? text(row.seconds, 3).c_str() : "",
                         std::string(to_string(row.verdict)).c_str());
        }
    }
}

void write_markdown(std::FILE* file, const std::vector<Result>& results) {
    std::string family;
    for (const Result& result : results) {
        const Case& c = result.of;
        if (c.family != family) {
            family = c.family;
            std::fprintf(
                file,
                "\n### %s\n\n| case | what is stiff | expected | got (double) | digits: double "
                "| extended | quad | 50 | 100 | events | status |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|\n",
                family.c_str());
        }
        std::string name = c.name;
        if (std::size(kLaws) > 1) name += std::string(" (") + kLaws[result.law].name + ")";
        std::string expected = list(result.target.values, 7, 3, ", ");
        std::string got = list(result.rows.front().got, 7, 3, ", ");
        if (c.status_only) {
            for (const Status status : c.statuses) {
                expected += (expected.empty() ? "" : " or ") + std::string(to_string(status));
            }
            got = std::string(to_string(result.rows.front().status));
        }
        std::fprintf(file, "| %s | %s | %s | %s |", name.c_str(), c.stiff.c_str(), expected.c_str(),
                     got.c_str());
        for (std::size_t k = 0; k < result.rows.size(); ++k) {
            std::fprintf(file, " %s |", digits_text(result, k).c_str());
        }
        const auto events = [](const Row& row) { return std::to_string(row.events); };
        const auto status = [](const Row& row) { return std::string(to_string(row.status)); };
        std::fprintf(file, " %s | %s |\n", distinct(result, events).c_str(),
                     distinct(result, status).c_str());
    }
}

}  // namespace osculo::bench::stability

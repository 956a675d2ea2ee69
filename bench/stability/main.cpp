// Runs the catalogue of stiff and extreme scenes in every precision.
//
//     bench_stability [--quick | --full] [--seed N] [--count M] [--case PART] [CSV [MARKDOWN]]
//
// --quick: rows of half a second at most; --full: of two minutes, else of twenty seconds.
// --seed, --count: M random members of that seed as well (default: 60 of seed 1); the same numbers
// give the same scenes everywhere. --case: only those whose name or family has PART in it.
// Exit code 1 if anything is wrong, which is also said.

#include <cstdlib>
#include <cstring>

#include "report.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench::stability;

struct Settings {
    double budget = 20;  ///< of one row [s]
    bool full = false;
    std::uint64_t seed = 1;
    int count = 60;
    std::string part;
    std::vector<const char*> paths;
};

/// False if the words make no sense.
bool read_arguments(int argc, char** argv, Settings& settings) {
    for (int i = 1; i < argc; ++i) {
        const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0; };
        const bool more = i + 1 < argc;
        if (is("--quick")) {
            settings.budget = 0.5;
        } else if (is("--full")) {
            settings.budget = 120;
            settings.full = true;
        } else if (is("--seed") && more) {
            settings.seed = std::strtoull(argv[++i], nullptr, 10);
        } else if (is("--count") && more) {
            settings.count = std::atoi(argv[++i]);
        } else if (is("--case") && more) {
            settings.part = argv[++i];
        } else if (argv[i][0] == '-') {
            return false;
        } else {
            settings.paths.push_back(argv[i]);
        }
    }
    return settings.paths.size() <= 2;
}

struct Tally {
    int right = 0, status = 0, wrong = 0, too_long = 0;

    void add(const Row& row) {
        switch (row.verdict) {
            case Verdict::right: ++right; break;
            case Verdict::status_only: ++status; break;
            case Verdict::wrong: ++wrong; break;
            case Verdict::too_long: ++too_long; break;
        }
    }
};

bool write(const char* path, void (*writer)(std::FILE*, const std::vector<Result>&),
           const std::vector<Result>& results) {
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", path);
        return false;
    }
    writer(file, results);
    return std::fclose(file) == 0;
}

Result run_case(const Case& c, std::size_t law, const Settings& settings, Tally& tally) {
    Result result{c, law, target(c, law, settings.budget), {}};
    for (const Precision precision : kPrecisions) {
        result.rows.push_back(play(c, law, precision, result.target, settings.budget));
        const Row& row = result.rows.back();
        tally.add(row);
        if (row.verdict == Verdict::wrong) {
            std::printf("WRONG: %s, %s, %s: %s (%.1f digits of %.1f; %llu events, %s)\n",
                        c.name.c_str(), kLaws[law].name, std::string(to_string(precision)).c_str(),
                        row.why.c_str(), row.digits, row.needed,
                        static_cast<unsigned long long>(row.events),
                        std::string(to_string(row.status)).c_str());
            std::fflush(stdout);
        }
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    if (!read_arguments(argc, argv, settings)) {
        std::fputs(
            "usage: bench_stability [--quick | --full] [--seed N] [--count M] [--case PART] "
            "[CSV [MARKDOWN]]\n",
            stderr);
        return 2;
    }
    Catalogue all = catalogue();
    add_random(all, settings.seed, settings.count);
    std::vector<Result> results;
    Tally tally;
    for (const Case& c : all) {
        if (c.full_only && !settings.full) continue;
        const bool wanted = c.name.find(settings.part) != std::string::npos ||
                            c.family.find(settings.part) != std::string::npos;
        if (!wanted) continue;
        for (std::size_t law = 0; law < std::size(kLaws); ++law) {
            if (c.only && kLaws[law].law != *c.only) continue;
            results.push_back(run_case(c, law, settings, tally));
        }
    }
    std::printf("%zu cases in %zu precisions: %d right, %d only a status, %d wrong, %d not run\n",
                results.size(), std::size(kPrecisions), tally.right, tally.status, tally.wrong,
                tally.too_long);
    bool written = true;
    if (!settings.paths.empty()) written = write(settings.paths[0], write_csv, results);
    if (settings.paths.size() > 1) {
        written = write(settings.paths[1], write_markdown, results) && written;
    }
    if (!written) return 2;
    return tally.wrong == 0 ? 0 : 1;
}

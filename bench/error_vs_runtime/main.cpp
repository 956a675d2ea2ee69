// Errors and run times of osculo and of engines with time steps, on the same scenes: one CSV.
//
//     bench_error_vs_runtime [--quick] [--scene NAME] CSV
//
// Every scene comes in seeded variants. Every contender plays every variant before the next variant
// comes (so that a busy machine hits all of them alike), until it has used up its time.

#include <cstdio>
#include <cstring>
#include <memory>

#include "compare.hpp"
#include "cpu_clock.hpp"
#include "statistics.hpp"
#include "workload.hpp"

namespace {

using namespace osculo;
using namespace osculo::bench;

struct Settings {
    bool quick = false;
    std::string scene;
    std::string path;
    double budget = 0.25;  ///< processor time per point [s], exceeded only for the first few runs
    double patience = 4;   ///< processor time of one run [s]
    int cross_checks = 5;  ///< variants that are played with 50 digits as well
    std::vector<double> steps{1. / 30,    1. / 60,    1. / 240,    1. / 960, 1. / 3840,
                              1. / 15360, 1. / 61440, 1. / 245760, 1e-6};
};

/// What is known of a contender at one instant of a scene.
struct Results {
    Sample rms, worst, energy, cpu;
    double wrong = 0;
    double gave_up = 0;
};

/// A contender with one step.
struct Entry {
    const Contender* contender;
    double step;
    std::vector<Results> at;  ///< one per instant
    double spent = 0;
    int runs = 0;
    bool done = false;
};

std::vector<Contender> everyone() {
    std::vector<Contender> list{ours_float(), ours_double(), ours_long_double(), ours_quad(),
                                paper(false), paper(true),   swept_steps()};
#ifdef OSCULO_BENCH_BOX2D
    list.push_back(box2d(false));
    list.push_back(box2d(true));
#endif
#ifdef OSCULO_BENCH_CHIPMUNK
    list.push_back(chipmunk(false));
    list.push_back(chipmunk(true));
#endif
    return list;
}

class Report {
public:
    explicit Report(const char* path) : file_(std::fopen(path, "w")) {
        if (file_ == nullptr) return;
        std::fputs(
            "scene,contender,step_s,time_s,runs,rms_median_radii,rms_p90_radii,rms_worst_radii,"
            "max_median_radii,max_worst_radii,energy_median,energy_worst,wrong_contacts,"
            "gave_up,cpu_s_per_s_median,cpu_s_per_s_q1,cpu_s_per_s_q3\n",
            file_.get());
    }
    [[nodiscard]] bool open() const { return file_ != nullptr; }

    void lines(const Workload& workload, const Entry& entry) {
        for (std::size_t k = 0; k < workload.times.size(); ++k) {
            const Results& r = entry.at[k];
            if (r.rms.size() == 0) continue;
            const auto runs = static_cast<double>(r.rms.size());
            std::fprintf(file_.get(),
                         "\"%s\",%s,%.6g,%.6g,%zu,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%.4g,%.4g,"
                         "%.4g,%.4g,%.4g\n",
                         workload.name.c_str(), entry.contender->name.c_str(), entry.step,
                         workload.times[k], r.rms.size(), r.rms.median(), r.rms.quantile(0.9),
                         r.rms.worst(), r.worst.median(), r.worst.worst(), r.energy.median(),
                         r.energy.worst(), r.wrong / runs, r.gave_up / runs, r.cpu.median(),
                         r.cpu.quantile(0.25), r.cpu.quantile(0.75));
        }
        std::fflush(file_.get());
    }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
};

Exact energy_of(const Scene& scene) {
    Exact sum = 0;
    for (const Ball& ball : scene.balls) {
        const Exact vx = ball.velocity.x;
        const Exact vy = ball.velocity.y;
        sum += ball.mass * (vx * vx + vy * vy) / 2;
    }
    return sum;
}

void play(Entry& entry, const Workload& workload, const Scene& scene, const Trace& reference,
          const Settings& settings) {
    const Exact start_energy = energy_of(scene);
    const Trace trace = entry.contender->play(
        {scene, workload.times, entry.step, workload.times.back(), settings.patience});
    ++entry.runs;
    entry.done = trace.snapshots.size() < workload.times.size();
    if (entry.done) entry.spent += settings.patience;
    for (std::size_t k = 0; k < trace.snapshots.size(); ++k) {
        const double time = workload.times[k];
        const Difference off = compare(trace.snapshots[k], reference.snapshots[k],
                                       scene.balls.front().radius, start_energy);
        Results& r = entry.at[k];
        r.rms.add(off.rms);
        r.worst.add(off.worst);
        r.energy.add(off.energy);
        r.cpu.add(trace.snapshots[k].cpu_seconds / time);
        r.gave_up += trace.gave_up ? 1 : 0;
        r.wrong += same_contacts(trace.contacts, reference.contacts, scene.balls.size(), time,
                                 std::min(entry.step, time))
                       ? 0
                       : 1;
    }
    if (!entry.contender->stepped) return;  // plays all variants
    if (!trace.snapshots.empty()) {
        entry.spent += trace.snapshots.back().cpu_seconds;
    }
    const double budget = settings.budget * workload.budget;
    if (entry.spent > budget && (entry.runs >= 3 || entry.spent > 4 * budget)) {
        entry.done = true;
    }
}

/// Plays a scene. Returns the largest difference between the references of 50 and 100 digits
/// [radii].
double measure(const Workload& workload, const std::vector<Contender>& contenders,
               const Settings& settings, Report& report) {
    std::vector<Entry> entries;
    for (const Contender& contender : contenders) {
        if (workload.cloth && !contender.cloth) continue;
        const auto none = std::vector<Results>(workload.times.size());
        if (!contender.stepped) entries.push_back({&contender, 0, none});
        for (const double step : settings.steps) {
            if (contender.stepped) entries.push_back({&contender, step, none});
        }
    }
    const Contender exact = ours_100_digits();
    const Contender check = ours_50_digits();
    // Contacts that a coarse step dates too early are looked for a little after the end.
    const double end = workload.times.back();
    const double recorded = end + std::min(end, 2 * settings.steps.front());
    const int variants = settings.quick ? workload.quick_variants : workload.variants;
    double disagreement = 0;
    for (int variant = 1; variant <= variants; ++variant) {
        const Scene scene = workload.make(static_cast<std::uint64_t>(variant), workload.parameter);
        const Trace reference = exact.play({scene, workload.times, 0, recorded});
        if (variant <= settings.cross_checks) {
            const Trace second = check.play({scene, workload.times, 0, end});
            for (std::size_t k = 0; k < workload.times.size(); ++k) {
                const double off = compare(second.snapshots[k], reference.snapshots[k],
                                           scene.balls.front().radius, energy_of(scene))
                                       .worst;
                disagreement = std::max(disagreement, off);
            }
        }
        const Entry* hopeless = nullptr;
        for (Entry& entry : entries) {
            if (hopeless != nullptr && hopeless->contender == entry.contender) entry.done = true;
            if (entry.done) continue;
            play(entry, workload, scene, reference, settings);
            if (entry.done && entry.at.front().rms.size() == 0) hopeless = &entry;
        }
    }
    for (const Entry& entry : entries) report.lines(workload, entry);
    return disagreement;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0) {
            settings.quick = true;
            settings.budget = 0.02;
            settings.patience = 0.1;
            settings.cross_checks = 2;
        } else if (std::strcmp(argv[i], "--scene") == 0 && i + 1 < argc) {
            settings.scene = argv[++i];
        } else {
            settings.path = argv[i];
        }
    }
    Report report(settings.path.c_str());
    if (!report.open()) {
        std::fputs("usage: bench_error_vs_runtime [--quick] [--scene NAME] CSV\n", stderr);
        return 2;
    }
    const std::vector<Contender> contenders = everyone();
    bool sound = true;
    for (const Workload& workload : workloads()) {
        if (!settings.scene.empty() && settings.scene != workload.name) continue;
        const double start = cpu_now();
        const double off = measure(workload, contenders, settings, report);
        std::printf("%-24s references of 50 and 100 digits agree to %.1e radii  (%.1f s)\n",
                    workload.name.c_str(), off, cpu_now() - start);
        std::fflush(stdout);
        sound = sound && off < 1e-25;
    }
    if (!sound) std::puts("THE REFERENCES DISAGREE");
    return sound ? 0 : 1;
}

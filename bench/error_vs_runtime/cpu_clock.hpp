#pragma once

#include <algorithm>
#include <ctime>

namespace osculo::bench {

/// Processor time of this thread [s]: what other programs do on the machine does not count, but for
/// the caches they spoil.
[[nodiscard]] inline double cpu_now() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What reading the clock costs, at the least [s].
[[nodiscard]] inline double clock_cost() {
    static const double cost = [] {
        double least = 1;
        for (int i = 0; i < 1000; ++i) {
            const double start = cpu_now();
            least = std::min(least, cpu_now() - start);
        }
        return least;
    }();
    return cost;
}

}  // namespace osculo::bench

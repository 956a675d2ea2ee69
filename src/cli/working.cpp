#include "cli/working.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <fmt/core.h>
#include <unistd.h>

namespace osculo::cli {

Working::Working(bool quiet) {
    if (quiet || isatty(STDERR_FILENO) == 0) return;
    thread_ = std::jthread([](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        for (int seconds = 1;; ++seconds) {
            using namespace std::chrono_literals;
            if (stopped.wait_for(lock, stop, 1s, [&] { return stop.stop_requested(); })) {
                if (seconds > 1) fmt::print(stderr, "\r\033[K");
                return;
            }
            fmt::print(stderr, "\rworking, {} s ", seconds);
        }
    });
}

}  // namespace osculo::cli

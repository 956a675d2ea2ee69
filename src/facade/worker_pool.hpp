#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace osculo::facade {

/// A fixed number of threads, the calling one among them, that work on one task after another.
class WorkerPool {
public:
    /// Starts all but one. Requires threads >= 1.
    explicit WorkerPool(unsigned threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] unsigned threads() const { return static_cast<unsigned>(others_.size()) + 1; }

    /// Calls task(n) for n = 0 .. threads - 1, each on a thread of its own, 0 on the calling one,
    /// and returns when all have returned. The task must not throw. One call at a time.
    void run(const std::function<void(unsigned)>& task);

private:
    void serve(unsigned number);

    std::mutex mutex_;
    std::condition_variable begin_;
    std::condition_variable end_;
    const std::function<void(unsigned)>* task_ = nullptr;
    std::uint64_t turn_ = 0;  ///< number of tasks so far
    unsigned busy_ = 0;
    bool closing_ = false;
    std::vector<std::thread> others_;
};

}  // namespace osculo::facade

#include "worker_pool.hpp"

namespace osculo::facade {

WorkerPool::WorkerPool(unsigned threads) {
    others_.reserve(threads - 1);
    try {
        for (unsigned n = 1; n < threads; ++n) others_.emplace_back([this, n] { serve(n); });
    } catch (const std::system_error&) {
        // The system has no more threads: those that there are do the same work.
    }
}

WorkerPool::~WorkerPool() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    begin_.notify_all();
    for (std::thread& thread : others_) thread.join();
}

void WorkerPool::run(const std::function<void(unsigned)>& task) {
    {
        const std::lock_guard lock(mutex_);
        task_ = &task;
        busy_ = static_cast<unsigned>(others_.size());
        ++turn_;
    }
    begin_.notify_all();
    task(0);
    std::unique_lock lock(mutex_);
    end_.wait(lock, [this] { return busy_ == 0; });
}

void WorkerPool::serve(unsigned number) {
    std::uint64_t served = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        begin_.wait(lock, [&] { return closing_ || turn_ != served; });
        if (closing_) return;
        served = turn_;
        const auto* const task = task_;
        lock.unlock();
        (*task)(number);
        lock.lock();
        if (--busy_ == 0) end_.notify_one();
    }
}

}  // namespace osculo::facade

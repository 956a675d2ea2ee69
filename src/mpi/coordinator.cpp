#include "mpi/coordinator.hpp"

#include <thread>

#include "mpi/block_bytes.hpp"

namespace osculo::mpi {
namespace {

/// After which a block is given to another rank, too, if one is idle: the results are the same.
constexpr std::chrono::seconds kPatience{10};

}  // namespace

void Coordinator::run(std::size_t block_size, const cli::InterruptNote& interrupt) {
    while (!interrupt.is_interrupted() && !invalid_.has_ended()) {
        hand_out(block_size);
        if (is_at_end_ && work_.empty()) return;
        if (const auto message = ranks_.receive_now()) {
            take(*message);
            write();
        } else {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    }
}

void Coordinator::hand_out(std::size_t block_size) {
    // As many blocks wait to be written as keep everybody busy.
    const std::size_t most = 4 * static_cast<std::size_t>(ranks_.size());
    for (int rank = 1; rank < ranks_.size(); ++rank) {
        if (busy_.contains(rank)) continue;
        if (!is_at_end_ && work_.size() < most) {
            cli::ShotBlock block = source_.next(block_size);
            is_at_end_ = block.size() == 0;
            if (!is_at_end_) {
                const std::uint64_t first = block.first;
                give(rank, work_.emplace(first, Work{std::move(block)}).first->second);
                continue;
            }
        }
        for (auto& [first, work] : work_) {
            if (work.is_done || Clock::now() - work.since < kPatience) continue;
            give(rank, work);
            break;
        }
    }
}

void Coordinator::give(int rank, Work& work) {
    work.since = Clock::now();
    busy_[rank] = work.block.first;
    ranks_.send(rank, bytes_of(work.block));
}

void Coordinator::take(const Ranks::Message& message) {
    busy_.erase(message.from);
    BlockResult answer = result_from(message.text);
    const auto found = work_.find(answer.first);
    if (found == work_.end() || found->second.is_done) return;      // another rank was faster
    if (answer.result.shots != found->second.block.size()) return;  // it died in between
    found->second.result = std::move(answer.result);
    found->second.is_done = true;
}

void Coordinator::write() {
    while (!work_.empty() && work_.begin()->second.is_done && !invalid_.has_ended()) {
        auto& [first, work] = *work_.begin();
        const std::size_t rows =
            invalid_.report(scene_, work.block, work.result, work.block.size());
        sink_.write(work.result, rows, first, work.block.errors);
        written_ += rows;
        work_.erase(work_.begin());
    }
}

std::vector<int> Coordinator::silent_ranks() const {
    std::vector<int> ranks;
    for (const auto& [rank, first] : busy_) ranks.push_back(rank);
    return ranks;
}

std::vector<std::string> Coordinator::missing() const {
    std::vector<std::string> ranges;
    for (const auto& [first, work] : work_) {
        ranges.push_back(std::to_string(first) + " to " +
                         std::to_string(first + work.block.size() - 1));
    }
    return ranges;
}

}  // namespace osculo::mpi

#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cli/batch/invalid_shots.hpp"
#include "cli/batch/outcome_sink.hpp"
#include "cli/batch/shot_source.hpp"
#include "cli/interrupt.hpp"
#include "mpi/ranks.hpp"

namespace osculo::mpi {

/// What rank 0 does: hands out blocks of shots to whoever is idle, and writes what comes back in
/// order. What a rank does not answer for long is given to another one that is idle as well.
class Coordinator {
public:
    Coordinator(const Ranks& ranks, const Scene& scene, cli::ShotSource& source,
                cli::OutcomeSink& sink, cli::InvalidShots& invalid)
        : ranks_(ranks), scene_(scene), source_(source), sink_(sink), invalid_(invalid) {}

    /// Until all shots are written, one has ended it all, or there is an interrupt.
    void run(std::size_t block_size, const cli::InterruptNote& interrupt);

    [[nodiscard]] std::uint64_t written() const { return written_; }
    /// Ranks that have not answered, and what has been handed out and not been written.
    [[nodiscard]] std::vector<int> silent_ranks() const;
    [[nodiscard]] std::vector<std::string> missing() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Work {
        cli::ShotBlock block;
        BatchResult result{};
        bool is_done = false;
        Clock::time_point since{};
    };

    void hand_out(std::size_t block_size);
    void give(int rank, Work& work);
    void take(const Ranks::Message& message);
    void write();

    const Ranks& ranks_;
    const Scene& scene_;
    cli::ShotSource& source_;
    cli::OutcomeSink& sink_;
    cli::InvalidShots& invalid_;
    std::map<std::uint64_t, Work> work_;  ///< not written yet, by the first shot
    std::map<int, std::uint64_t> busy_;   ///< ranks, and the first shot of what they have
    bool is_at_end_ = false;              ///< of the source
    std::uint64_t written_ = 0;
};

}  // namespace osculo::mpi

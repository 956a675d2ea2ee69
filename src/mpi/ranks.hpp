#pragma once

#include <memory>
#include <optional>
#include <string>

namespace osculo::mpi {

/// The ranks of a program started by mpirun, from the making of this to its end. Nothing waits for
/// a rank that may have died, in the middle of a message even, but receive() and that end.
class Ranks {
public:
    Ranks(int& argc, char**& argv);
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;
    ~Ranks();

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }

    /// Returns at once.
    void send(int to, std::string message) const;

    struct Message {
        int from;
        std::string text;
    };
    /// The next one from anybody.
    [[nodiscard]] Message receive() const;
    /// The same, if one has arrived.
    [[nodiscard]] std::optional<Message> receive_now() const;

    /// Ends all ranks at once: some do not answer.
    [[noreturn]] static void abandon(int exit_code);

private:
    struct OnTheWay;

    int rank_ = 0;
    int size_ = 1;
    std::unique_ptr<OnTheWay> on_the_way_;
};

}  // namespace osculo::mpi

#pragma once

#include <optional>
#include <string>

namespace osculo::mpi {

/// The ranks of a program started by mpirun, from the making of this to its end.
class Ranks {
public:
    Ranks(int& argc, char**& argv);
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;
    ~Ranks();

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }

    void send(int to, const std::string& message) const;

    struct Message {
        int from;
        std::string text;
    };
    /// The next one from anybody.
    [[nodiscard]] Message receive() const;
    /// The same, if there is one now.
    [[nodiscard]] std::optional<Message> receive_now() const;

    /// Ends all ranks at once: some do not answer.
    [[noreturn]] static void abandon(int exit_code);

private:
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace osculo::mpi

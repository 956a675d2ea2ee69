#include "mpi/ranks.hpp"

#include <cstdio>
#include <cstdlib>
#include <list>
#include <utility>

#include <mpi.h>

namespace osculo::mpi {

/// Messages that are being sent or received. A list: what MPI writes to stays where it is.
struct Ranks::OnTheWay {
    struct Transfer {
        Message message;
        MPI_Request request = MPI_REQUEST_NULL;

        [[nodiscard]] bool is_done() {
            int done = 0;
            MPI_Test(&request, &done, MPI_STATUS_IGNORE);
            return done != 0;
        }
    };
    std::list<Transfer> sent;
    std::list<Transfer> received;
};

Ranks::Ranks(int& argc, char**& argv) : on_the_way_(std::make_unique<OnTheWay>()) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
    for (auto& transfer : on_the_way_->sent) MPI_Wait(&transfer.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
}

void Ranks::send(int to, std::string message) const {
    auto& sent = on_the_way_->sent;
    std::erase_if(sent, [](auto& transfer) { return transfer.is_done(); });
    auto& transfer = sent.emplace_back(OnTheWay::Transfer{{to, std::move(message)}});
    const std::string& text = transfer.message.text;
    MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD,
              &transfer.request);
}

// The world is that of the program: not static for the sake of those who read it.
// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
Ranks::Message Ranks::receive() const {
    MPI_Status status;
    MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.text.data(), size, MPI_BYTE, message.from, 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

std::optional<Ranks::Message> Ranks::receive_now() const {
    auto& received = on_the_way_->received;
    MPI_Message arriving;
    MPI_Status status;
    int is_there = 0;
    MPI_Improbe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &arriving, &status);
    if (is_there != 0) {
        int size = 0;
        MPI_Get_count(&status, MPI_BYTE, &size);
        auto& transfer = received.emplace_back(OnTheWay::Transfer{
            {status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')}});
        MPI_Imrecv(transfer.message.text.data(), size, MPI_BYTE, &arriving, &transfer.request);
    }
    for (auto transfer = received.begin(); transfer != received.end(); ++transfer) {
        if (!transfer->is_done()) continue;
        Message message = std::move(transfer->message);
        received.erase(transfer);
        return message;
    }
    return std::nullopt;
}

void Ranks::abandon(int exit_code) {
    std::fflush(nullptr);
    std::_Exit(exit_code);  // mpirun ends the others
}

}  // namespace osculo::mpi

#include "mpi/ranks.hpp"

#include <cstdio>
#include <cstdlib>

#include <mpi.h>

namespace osculo::mpi {
namespace {

std::string take(MPI_Status& status) {
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    MPI_Recv(text.data(), size, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return text;
}

}  // namespace

Ranks::Ranks(int& argc, char**& argv) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
    MPI_Finalize();
}

// The world is that of the program: not static for the sake of those who read it.
// NOLINTBEGIN(readability-convert-member-functions-to-static)
void Ranks::send(int to, const std::string& message) const {
    MPI_Send(message.data(), static_cast<int>(message.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD);
}

Ranks::Message Ranks::receive() const {
    MPI_Status status;
    MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
    return {status.MPI_SOURCE, take(status)};
}

std::optional<Ranks::Message> Ranks::receive_now() const {
    MPI_Status status;
    int is_there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    return Message{status.MPI_SOURCE, take(status)};
}
// NOLINTEND(readability-convert-member-functions-to-static)

void Ranks::abandon(int exit_code) {
    std::fflush(nullptr);
    std::_Exit(exit_code);  // mpirun ends the others
}

}  // namespace osculo::mpi

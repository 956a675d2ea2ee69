#include "cli/interrupt.hpp"

#include <csignal>

#include "cli/files.hpp"

namespace osculo::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_signal(int /*signal*/) {
    interrupted = 1;
    handle_signals();  // only calls std::signal
}

}  // namespace

InterruptNote::InterruptNote() {
    interrupted = 0;
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
}

InterruptNote::~InterruptNote() {
    handle_signals();
}

// Not static: it is true only while there is a note.
// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
bool InterruptNote::is_interrupted() const {
    return interrupted != 0;
}

}  // namespace osculo::cli

#include "cli/files.hpp"

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/failure.hpp"

namespace osculo::cli {
namespace {

// The file being written, for the signal handler, which can only use what is fixed in place.
std::array<char, PATH_MAX> unfinished_file{};

extern "C" void on_signal(int signal) {
    if (unfinished_file[0] != '\0') unlink(unfinished_file.data());
    _exit(128 + signal);
}

// Takes note of the file, and forgets it or removes it in the end.
class Unfinished {
public:
    explicit Unfinished(const std::string& path) {
        if (path.size() < unfinished_file.size()) {
            std::memcpy(unfinished_file.data() + 1, path.c_str() + 1, path.size());
            unfinished_file[0] = path[0];
        }
        path_ = path;
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
    ~Unfinished() {
        unfinished_file[0] = '\0';
        if (!is_finished_) unlink(path_.c_str());
    }
    void finish() { is_finished_ = true; }

private:
    std::string path_;
    bool is_finished_ = false;
};

class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    [[nodiscard]] int value() const { return value_; }
    // Some file systems report only now that there was no room.
    [[nodiscard]] bool close() {
        const int value = value_;
        value_ = -1;
        return ::close(value) == 0;
    }

private:
    int value_;
};

[[noreturn]] void fail(const char* what, const std::string& path) {
    throw Failure(kInputOutput, std::string(what) + ' ' + path + ": " + std::strerror(errno));
}

bool write_all(int file, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

void write_directly(const std::string& path, std::string_view content) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.value() < 0 || !write_all(file.value(), content) || !file.close()) {
        fail("cannot write", path);
    }
}

void replace(const std::string& path, std::string_view content) {
    std::string temporary = path + ".XXXXXX";
    Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
    if (file.value() < 0) fail("cannot write", path);
    Unfinished unfinished(temporary);

    // Permissions as if the file had been written in place.
    struct stat old {};
    mode_t mode = 0;
    if (::stat(path.c_str(), &old) == 0) {
        mode = old.st_mode & 07777;
    } else {
        const mode_t mask = ::umask(0);
        ::umask(mask);
        mode = 0666 & ~mask;
    }
    if (::fchmod(file.value(), mode) != 0 || !write_all(file.value(), content) || !file.close() ||
        ::rename(temporary.c_str(), path.c_str()) != 0) {
        fail("cannot write", path);
    }
    unfinished.finish();
}

}  // namespace

std::string read_file(const std::string& path) {
    const bool is_stdin = path == kStandardStream;
    const Descriptor file(is_stdin ? ::dup(STDIN_FILENO)
                                   : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    const std::string name = is_stdin ? "standard input" : path;
    if (file.value() < 0) fail("cannot read", name);

    std::string content;
    std::size_t used = 0;
    for (;;) {
        constexpr std::size_t kChunk = 1 << 16;
        if (content.size() - used < kChunk) content.resize(2 * content.size() + kChunk);
        const ssize_t got = ::read(file.value(), content.data() + used, content.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail("cannot read", name);
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
    }
    content.resize(used);
    return content;
}

void write_file(const std::string& path, std::string_view content) {
    std::error_code unknown;
    const auto status = std::filesystem::status(path, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        write_directly(path, content);
        return;
    }
    // A link stays a link: what it leads to is replaced.
    const auto target = std::filesystem::weakly_canonical(path, unknown);
    replace(unknown || target.empty() ? path : target.string(), content);
}

void write_output(std::string_view content) {
    if (write_all(STDOUT_FILENO, content) || errno == EPIPE) return;
    fail("cannot write", "standard output");
}

void handle_signals() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace osculo::cli

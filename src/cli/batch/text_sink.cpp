#include "cli/batch/text_sink.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

#include "cli/failure.hpp"
#include "cli/files.hpp"

namespace osculo::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& path) {
    throw Failure(kInputOutput, "cannot write " + path + ": " + std::strerror(errno));
}

/// How the line of a shot begins.
std::string beginning(io::OutcomeFormat format, std::uint64_t shot) {
    return format == io::OutcomeFormat::json ? "{\"shot\": " + std::to_string(shot) + ","
                                             : std::to_string(shot) + ",";
}

}  // namespace

TextSink::TextSink(OutcomeFile file, io::OutcomeFormat format, const Scene& scene,
                   const BatchOptions& options)
    : file_(std::move(file)), format_(format), scene_(scene) {
    const std::string header =
        file_.has_header ? io::outcomes_header(format, scene, options) : std::string();
    if (file_.path == kStandardStream) {
        append(header);
        return;
    }
    std::error_code unknown;
    const auto status = fs::status(file_.path, unknown);
    if (!fs::exists(status) || fs::is_regular_file(status)) part_ = file_.path + ".part";
    open(header);
}

TextSink::~TextSink() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void TextSink::open(const std::string& header) {
    std::error_code unknown;
    bool goes_on = false;
    if (file_.resumes && !part_.empty()) {
        const bool crashed = fs::exists(part_, unknown);
        const std::string& old = crashed ? part_ : file_.path;
        const std::uint64_t whole = fs::exists(old, unknown) ? count_whole(old, header) : 0;
        if (whole > 0) {
            if (!crashed) fs::copy_file(old, part_);
            fs::resize_file(part_, whole);
            goes_on = true;
        }
    }
    const std::string& path = part_.empty() ? file_.path : part_;
    const int mode = part_.empty() ? 0 : O_CREAT | (goes_on ? O_APPEND : O_TRUNC);
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | mode, 0666);
    if (descriptor_ < 0) fail_to_write(path);
    if (!goes_on) append(header);
}

std::uint64_t TextSink::count_whole(const std::string& path, const std::string& header) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::uint64_t whole = 0;
    if (!header.empty() && std::getline(in, line) && !in.eof()) {
        if (line + '\n' != header) {
            throw Failure(kInputOutput, path +
                                            ": cannot be resumed: it is of another scene, "
                                            "precision or version");
        }
        whole = header.size();
    }
    while (std::getline(in, line) && !in.eof()) {
        if (!line.starts_with(beginning(format_, file_.first + kept_))) {
            throw Failure(kInputOutput, path + ": cannot be resumed: shot " +
                                            std::to_string(file_.first + kept_) +
                                            " is not where it should be");
        }
        whole += line.size() + 1;
        ++kept_;
    }
    return whole;
}

void TextSink::write(const BatchResult& result, std::size_t rows, std::uint64_t first,
                     const std::vector<std::string>& errors) {
    text_.clear();
    for (std::size_t row = 0; row < rows; ++row) {
        io::append_outcome(text_, format_, scene_, result, row, first + row, errors[row]);
    }
    append(text_);
}

void TextSink::append(std::string_view text) {
    if (file_.path == kStandardStream) {
        write_output(text);
        return;
    }
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_to_write(file_.path);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void TextSink::finish() {
    if (descriptor_ < 0) return;
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail_to_write(file_.path);
    if (!part_.empty() && ::rename(part_.c_str(), file_.path.c_str()) != 0) {
        fail_to_write(file_.path);
    }
}

}  // namespace osculo::cli

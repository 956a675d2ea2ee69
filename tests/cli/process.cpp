#include "process.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace osculo::cli::test {
namespace {

std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace

Result osculo(const std::vector<std::string>& arguments, const std::string& input) {
    const TemporaryDirectory directory;
    write(directory / "input", input);
    std::string line = "$OSCULO";
    for (const std::string& argument : arguments) line += ' ' + quoted(argument);
    return shell(line + " < " + quoted(directory / "input"));
}

Result shell(const std::string& line) {
    const TemporaryDirectory directory;
    ::setenv("OSCULO", OSCULO_PROGRAM, 1);
    const std::string redirected =
        "( " + line + "\n) > " + quoted(directory / "out") + " 2> " + quoted(directory / "err");
    const int status = std::system(redirected.c_str());
    Result result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.out = content_of(directory / "out");
    result.err = content_of(directory / "err");
    return result;
}

TemporaryDirectory::TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "osculo_test_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryDirectory::operator/(const std::string& name) const {
    return (path_ / name).string();
}

std::size_t TemporaryDirectory::file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
}

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

}  // namespace osculo::cli::test

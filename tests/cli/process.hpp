#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace osculo::cli::test {

struct Result {
    int code = 0;  ///< exit code; 128 + signal if one ended the program
    std::string out;
    std::string err;
};

/// Runs the osculo program with these arguments and this input.
Result osculo(const std::vector<std::string>& arguments, const std::string& input = {});

/// Runs a line of shell in which $OSCULO is the program.
Result shell(const std::string& line);

/// A directory of its own for each test, removed at the end.
class TemporaryDirectory {
public:
    TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
    ~TemporaryDirectory();

    /// The path of a file there.
    [[nodiscard]] std::string operator/(const std::string& name) const;
    [[nodiscard]] std::size_t file_count() const;

private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string content_of(const std::string& path);
void write(const std::string& path, const std::string& content);

}  // namespace osculo::cli::test

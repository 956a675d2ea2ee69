#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "play.hpp"

/// The results as a table for programs (CSV) and one for readers (Markdown).
namespace osculo::bench::stability {

/// All rows of a case under one law, in the order of kPrecisions.
struct Result {
    Case of;
    std::size_t law = 0;
    Target target;
    std::vector<Row> rows;
};

void write_csv(std::FILE* file, const std::vector<Result>& results);
void write_markdown(std::FILE* file, const std::vector<Result>& results);

}  // namespace osculo::bench::stability

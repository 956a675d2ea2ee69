#include "cli/batch/shot_source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <span>
#include <type_traits>

#include "cli/batch/npz.hpp"
#include "cli/failure.hpp"
#include "cli/files.hpp"
#include "osculo/io.hpp"
#include "osculo/shots.hpp"

namespace osculo::cli {
namespace {

constexpr std::array<std::string_view, 5> kStrikeColumns{"speed", "azimuth", "elevation", "a", "b"};
static_assert(sizeof(Strike) == 5 * sizeof(double) && std::is_trivially_copyable_v<Strike>);
static_assert(sizeof(BallState) == 7 * sizeof(double) && std::is_trivially_copyable_v<BallState>);

bool is_blank(std::string_view line) {
    return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// A file of lines, each of them a shot but blank ones and, perhaps, the first.
class LineSource : public ShotSource {
public:
    LineSource(const std::string& path, std::size_t balls) : path_(path), balls_(balls) {
        if (path == kStandardStream) return;
        file_.open(path, std::ios::binary);
        if (!file_) {
            throw Failure(kInputOutput, "cannot read " + path + ": " + std::strerror(errno));
        }
    }

    ShotBlock next(std::size_t most) override {
        ShotBlock block;
        block.first = shots_;
        std::string line;
        while (block.size() < most && next_line(line)) add(line, block);
        // Without any that can be read: starts, which no scene refuses.
        block.are_starts = are_starts_.value_or(true);
        if (block.are_starts) fill_starts(block);
        return block;
    }

    void skip(std::uint64_t shots) override {
        std::string line;
        // The kind of all shots is that of the first one that can be read.
        while (!are_starts_ && shots_ < shots && next(1).size() > 0) {
        }
        while (shots_ < shots && next_line(line)) ++shots_;
    }

    std::optional<std::uint64_t> count() override {
        std::error_code unknown;
        if (!std::filesystem::is_regular_file(path_, unknown)) return std::nullopt;
        std::string line;
        while (next_line(line)) ++shots_;
        const std::uint64_t result = shots_;
        file_.clear();
        file_.seekg(0);
        if (!file_) return std::nullopt;
        shots_ = line_ = 0;
        has_begun_ = false;
        return result;
    }

protected:
    /// Takes the first line; false if that is a shot already.
    [[nodiscard]] virtual bool take_header(const std::string& line) = 0;
    /// Throws SceneError or FormatError.
    [[nodiscard]] virtual io::Shot read(const std::string& line) = 0;

    [[noreturn]] void fail(const std::string& what) const {
        throw Failure(kInvalidScene, place() + what);
    }

private:
    [[nodiscard]] std::string place() const { return "line " + std::to_string(line_) + ": "; }

    /// The next line that is a shot.
    bool next_line(std::string& line) {
        std::istream& in = path_ == kStandardStream ? std::cin : file_;
        while (std::getline(in, line)) {
            ++line_;
            if (is_blank(line)) continue;
            if (has_begun_) return true;
            has_begun_ = true;
            try {
                if (!take_header(line)) return true;
            } catch (const io::FormatError&) {
                return true;  // a broken shot, which is reported as such
            } catch (const SceneError& error) {
                throw Failure(kInvalidScene, path_ + ": " + place() + error.what());
            }
        }
        if (in.bad()) throw Failure(kInputOutput, "cannot read " + path_);
        return false;
    }

    void add(const std::string& line, ShotBlock& block) {
        ++shots_;
        Strike strike{.speed = 0};  // invalid
        std::string error;
        try {
            const io::Shot shot = read(line);
            const auto* const start = std::get_if<io::Start>(&shot);
            if (!are_starts_) are_starts_ = start != nullptr;
            if ((start != nullptr) != *are_starts_) {
                error = *are_starts_ ? "shot: must be a start, as the first one is"
                                     : "shot: must be a strike, as the first one is";
            } else if (start != nullptr) {
                fill_starts(block);
                block.states.insert(block.states.end(), start->states.begin(), start->states.end());
                block.present.insert(block.present.end(), start->present.begin(),
                                     start->present.end());
            } else {
                strike = std::get<Strike>(shot);
            }
        } catch (const std::exception& what) {  // SceneError, FormatError
            error = what.what();
        }
        block.strikes.push_back(strike);
        block.errors.push_back(error.empty() ? error : place() + error);
        block.lines.push_back(line_);
    }

    /// Puts invalid starts where there is none yet.
    void fill_starts(ShotBlock& block) const {
        const BallState nowhere{{std::numeric_limits<double>::quiet_NaN(), 0}, {}, {}};
        block.states.resize(balls_ * block.size(), nowhere);
        block.present.resize(balls_ * block.size(), 1);
    }

    std::string path_;
    std::size_t balls_;
    std::ifstream file_;
    std::uint64_t line_ = 0;
    std::uint64_t shots_ = 0;
    bool has_begun_ = false;
    std::optional<bool> are_starts_;
};

class JsonLines final : public LineSource {
public:
    JsonLines(const std::string& path, const Scene& scene)
        : LineSource(path, scene.balls.size()), scene_(scene) {}

protected:
    bool take_header(const std::string& line) override { return io::is_shots_header(line); }
    io::Shot read(const std::string& line) override { return io::shot_from_json(line, scene_); }

private:
    const Scene& scene_;
};

/// Strikes, under the names of their columns in any order.
class CsvLines final : public LineSource {
public:
    using LineSource::LineSource;

protected:
    bool take_header(const std::string& line) override {
        columns_.clear();
        for (const std::string_view name : cells(line)) {
            const auto found = std::ranges::find(kStrikeColumns, name);
            if (found == kStrikeColumns.end()) {
                fail("unknown column \"" + std::string(name) +
                     "\": must be among speed, azimuth, elevation, a, b");
            }
            columns_.push_back(static_cast<std::size_t>(found - kStrikeColumns.begin()));
        }
        for (const std::size_t needed : {0U, 1U}) {
            if (std::ranges::count(columns_, needed) != 1) {
                fail("must have a column " + std::string(kStrikeColumns[needed]));
            }
        }
        return true;
    }

    io::Shot read(const std::string& line) override {
        const auto all = cells(line);
        if (all.size() != columns_.size()) {
            throw SceneError("shot", "must have " + std::to_string(columns_.size()) + " numbers",
                             std::to_string(all.size()));
        }
        std::array<double, 5> numbers{1, 0, kLeastElevation, 0, 0};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string_view cell = all[i];
            if (cell.empty() && columns_[i] >= 2) continue;  // as if there were no such column
            double& number = numbers[columns_[i]];
            const auto [end, error] =
                std::from_chars(cell.data(), cell.data() + cell.size(), number);
            if (error != std::errc{} || end != cell.data() + cell.size()) {
                throw SceneError(std::string(kStrikeColumns[columns_[i]]), "must be a number",
                                 '"' + std::string(cell) + '"');
            }
        }
        return Strike{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
    }

private:
    static std::vector<std::string_view> cells(std::string_view line) {
        std::vector<std::string_view> result;
        for (bool more = true; more;) {
            const std::size_t end = line.find(',');
            more = end != std::string_view::npos;
            std::string_view cell = line.substr(0, end);
            while (!cell.empty() && is_blank(cell.substr(0, 1))) cell.remove_prefix(1);
            while (!cell.empty() && is_blank(cell.substr(cell.size() - 1))) cell.remove_suffix(1);
            result.push_back(cell);
            if (more) line.remove_prefix(end + 1);
        }
        return result;
    }

    std::vector<std::size_t> columns_;  ///< which of kStrikeColumns each one is
};

/// `strikes` (shots x 5), or `states` (shots x balls x 7) and perhaps `present` (shots x balls).
class ArraySource final : public ShotSource {
public:
    ArraySource(const std::string& path, std::size_t balls) : path_(path), balls_(balls) {
        const NamedArrays arrays = read_npz(path);
        if (const NpyArray* const array = find_array(arrays, "strikes")) {
            take(*array, "strikes", {5}, strikes_);
            return;
        }
        const NpyArray* const array = find_array(arrays, "states");
        if (array == nullptr) fail("must have an array \"strikes\" or \"states\"");
        are_starts_ = true;
        take(*array, "states", {balls, 7}, states_);
        present_.assign(balls * size(), 1);
        if (const NpyArray* const there = find_array(arrays, "present")) {
            const bool fits = (there->type == "|u1" || there->type == "|b1") &&
                              there->shape == std::vector<std::size_t>{size(), balls} &&
                              there->bytes.size() == present_.size();
            if (!fits) fail("present: must be shots x balls of uint8 or bool");
            std::memcpy(present_.data(), there->bytes.data(), there->bytes.size());
        }
    }

    ShotBlock next(std::size_t most) override {
        ShotBlock block;
        block.first = next_;
        block.are_starts = are_starts_;
        const std::size_t end = std::min<std::size_t>(size(), next_ + most);
        block.errors.resize(end - next_);
        const auto copy = [&](const auto& from, std::size_t row, auto& to) {
            const auto begin = from.begin();
            to.assign(begin + static_cast<std::ptrdiff_t>(next_ * row),
                      begin + static_cast<std::ptrdiff_t>(end * row));
        };
        if (are_starts_) {
            copy(states_, balls_, block.states);
            copy(present_, balls_, block.present);
        } else {
            copy(strikes_, 1, block.strikes);
        }
        next_ = end;
        return block;
    }
    void skip(std::uint64_t shots) override {
        next_ = std::min<std::size_t>(size(), next_ + shots);
    }
    std::optional<std::uint64_t> count() override { return size(); }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Failure(kInvalidScene, path_ + ": " + what);
    }

    template <class Row>
    void take(const NpyArray& array, const std::string& name, const std::vector<std::size_t>& row,
              std::vector<Row>& rows) {
        std::size_t numbers = 1;
        std::string shape = "shots";
        for (const std::size_t n : row) {
            numbers *= n;
            shape += " x " + std::to_string(n);
        }
        const bool fits = array.type == byte_order() + std::string("f8") &&
                          array.shape.size() == row.size() + 1 &&
                          std::equal(row.begin(), row.end(), array.shape.begin() + 1) &&
                          array.bytes.size() == array.shape[0] * numbers * sizeof(double);
        if (!fits) fail(name + ": must be " + shape + " of float64");
        rows.resize(array.bytes.size() / sizeof(Row));
        std::memcpy(rows.data(), array.bytes.data(), array.bytes.size());
        shots_ = array.shape[0];
    }

    [[nodiscard]] std::size_t size() const { return shots_; }

    std::string path_;
    std::size_t balls_;
    std::size_t shots_ = 0;
    std::size_t next_ = 0;
    bool are_starts_ = false;
    std::vector<Strike> strikes_;
    std::vector<BallState> states_;
    std::vector<std::uint8_t> present_;
};

}  // namespace

std::unique_ptr<ShotSource> open_shots(const std::string& path, const Scene& scene) {
    if (path.ends_with(".npz")) return std::make_unique<ArraySource>(path, scene.balls.size());
    if (path.ends_with(".csv")) return std::make_unique<CsvLines>(path, scene.balls.size());
    return std::make_unique<JsonLines>(path, scene);
}

}  // namespace osculo::cli

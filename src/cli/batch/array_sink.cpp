#include "cli/batch/array_sink.hpp"

#include <filesystem>
#include <type_traits>

#include "cli/failure.hpp"
#include "cli/files.hpp"
#include "osculo/shots.hpp"

namespace osculo::cli {
namespace {

/// Arrays that say what a file is of; they come first.
constexpr std::size_t kCommon = 4;

template <class Thing>
std::vector<std::string> ids_of(const std::vector<Thing>& things) {
    std::vector<std::string> ids;
    for (const Thing& thing : things) ids.push_back(thing.id);
    return ids;
}

template <class Number>
std::string type_of() {
    constexpr char kKind = std::is_floating_point_v<Number> ? 'f'
                           : std::is_signed_v<Number>       ? 'i'
                                                            : 'u';
    return std::string(1, sizeof(Number) == 1 ? '|' : byte_order()) + kKind +
           std::to_string(sizeof(Number));
}

/// No shots yet, [row] numbers for each.
template <class Number>
NpyArray column(std::vector<std::size_t> row = {}) {
    row.insert(row.begin(), 0);
    return {type_of<Number>(), std::move(row), {}};
}

NamedArrays empty_columns(std::size_t balls) {
    return {{"shot", column<std::uint64_t>()},
            {"status", column<std::uint8_t>()},
            {"time", column<double>()},
            {"events", column<std::uint64_t>()},
            {"cue_ball", column<std::int32_t>()},
            {"first_hit", column<std::int32_t>()},
            {"cushions_before_hit", column<std::uint32_t>()},
            {"cushions_after_hit", column<std::uint32_t>()},
            {"driven_to_cushion", column<std::uint32_t>()},
            {"kisses", column<std::uint32_t>()},
            {"settled_count", column<std::uint64_t>()},
            {"fate", column<std::uint8_t>({balls})},
            {"position", column<double>({balls, 2})},
            {"rim", column<std::int32_t>({balls})},
            {"capture_time", column<double>({balls})},
            {"ball_contacts", column<std::uint32_t>({balls})},
            {"cushion_contacts", column<std::uint32_t>({balls})}};
}

/// Adds the columns of a result one after another.
class Adder {
public:
    Adder(NamedArrays& arrays, std::size_t rows) : next_(arrays.begin() + kCommon), rows_(rows) {}

    /// [width] entries per shot.
    template <class Entry>
    void add(const std::vector<Entry>& entries, std::size_t width = 1) {
        NpyArray& array = (next_++)->second;
        array.shape[0] += rows_;
        array.bytes.append(reinterpret_cast<const char*>(entries.data()),
                           rows_ * width * sizeof(Entry));
    }

private:
    NamedArrays::iterator next_;
    std::size_t rows_;
};

[[noreturn]] void refuse(const std::string& path, const char* what) {
    throw Failure(kInputOutput, path + ": " + what);
}

/// Whether the arrays may follow each other: the same names, common arrays and rows.
bool fit(const NamedArrays& one, const NamedArrays& other) {
    if (one.size() != other.size() || one.size() <= kCommon) return false;
    for (std::size_t i = 0; i < one.size(); ++i) {
        const auto& [name, array] = one[i];
        const auto& [other_name, other_array] = other[i];
        if (name != other_name || array.type != other_array.type ||
            array.shape.size() != other_array.shape.size()) {
            return false;
        }
        if (i < kCommon) {
            if (array.shape != other_array.shape || array.bytes != other_array.bytes) return false;
        } else if (array.shape.empty() || !std::equal(array.shape.begin() + 1, array.shape.end(),
                                                      other_array.shape.begin() + 1)) {
            return false;
        }
    }
    return true;
}

void append(NamedArrays& all, const NamedArrays& more) {
    for (std::size_t i = kCommon; i < all.size(); ++i) {
        all[i].second.shape[0] += more[i].second.shape[0];
        all[i].second.bytes += more[i].second.bytes;
    }
}

}  // namespace

ArraySink::ArraySink(OutcomeFile file, const Scene& scene, const BatchOptions& options)
    : file_(std::move(file)) {
    arrays_ = {{"schema", npy_texts({"osculo/outcomes-1"})},
               {"fingerprint", npy_texts({io::fingerprint(scene, options)})},
               {"balls", npy_texts(ids_of(scene.balls))},
               {"rims", npy_texts(ids_of(scene.rims))}};
    NamedArrays columns = empty_columns(scene.balls.size());
    arrays_.insert(arrays_.end(), columns.begin(), columns.end());
    if (file_.resumes && std::filesystem::exists(file_.path)) go_on();
}

void ArraySink::go_on() {
    const NamedArrays old = read_npz(file_.path);
    if (!fit(arrays_, old)) {
        refuse(file_.path, "cannot be resumed: it is of another scene, precision or version");
    }
    kept_ = old[kCommon].second.shape[0];
    append(arrays_, old);
}

void ArraySink::write(const BatchResult& result, std::size_t rows, std::uint64_t first,
                      const std::vector<std::string>& /*errors*/) {
    std::vector<std::uint64_t> shots(rows);
    for (std::size_t row = 0; row < rows; ++row) shots[row] = first + row;
    const std::size_t balls = result.balls;
    Adder adder(arrays_, rows);
    adder.add(shots);
    adder.add(result.status);
    adder.add(result.time);
    adder.add(result.event_count);
    adder.add(result.cue_ball);
    adder.add(result.first_hit);
    adder.add(result.cushions_before_hit);
    adder.add(result.cushions_after_hit);
    adder.add(result.driven_to_cushion);
    adder.add(result.kisses);
    adder.add(result.settled_count);
    adder.add(result.fate, balls);
    adder.add(result.position, balls);
    adder.add(result.rim, balls);
    adder.add(result.capture_time, balls);
    adder.add(result.ball_contacts, balls);
    adder.add(result.cushion_contacts, balls);
}

void ArraySink::finish() {
    const std::string content = npz_from_arrays(arrays_);
    if (file_.path == kStandardStream) {
        write_output(content);
    } else {
        write_file(file_.path, content);
    }
}

NamedArrays joined(const std::vector<std::string>& paths) {
    NamedArrays all = read_npz(paths.front());
    for (std::size_t i = 1; i < paths.size(); ++i) {
        const NamedArrays part = read_npz(paths[i]);
        if (!fit(all, part)) refuse(paths[i], "is not of the same scene as the first part");
        append(all, part);
    }
    return all;
}

}  // namespace osculo::cli

#include "mpi/block_bytes.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace osculo::mpi {
namespace {

class Writer {
public:
    template <class Entry>
    void operator()(const std::vector<Entry>& entries) {
        static_assert(std::is_trivially_copyable_v<Entry>);
        (*this)(std::uint64_t{entries.size()});
        bytes_.append(reinterpret_cast<const char*>(entries.data()),
                      entries.size() * sizeof(Entry));
    }
    void operator()(std::uint64_t value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    [[nodiscard]] std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

class Reader {
public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}

    template <class Entry>
    void operator()(std::vector<Entry>& entries) {
        std::uint64_t count = 0;
        (*this)(count);
        if (count > (bytes_.size() - at_) / sizeof(Entry)) fail();
        entries.resize(count);
        copy(entries.data(), count * sizeof(Entry));
    }
    void operator()(std::uint64_t& value) { copy(&value, sizeof value); }

private:
    [[noreturn]] static void fail() { throw std::runtime_error("a message is cut off"); }
    void copy(void* to, std::size_t size) {
        if (size > bytes_.size() - at_) fail();
        if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
    }

    const std::string& bytes_;
    std::size_t at_ = 0;
};

/// The same order for writing and reading.
template <class Archive, class Result>
void visit(Archive& archive, Result& result) {
    archive(result.status);
    archive(result.time);
    archive(result.event_count);
    archive(result.cue_ball);
    archive(result.first_hit);
    archive(result.cushions_before_hit);
    archive(result.cushions_after_hit);
    archive(result.driven_to_cushion);
    archive(result.kisses);
    archive(result.settled_count);
    archive(result.fate);
    archive(result.position);
    archive(result.rim);
    archive(result.capture_time);
    archive(result.ball_contacts);
    archive(result.cushion_contacts);
}

}  // namespace

std::string bytes_of(const cli::ShotBlock& block) {
    Writer writer;
    writer(block.first);
    writer(std::uint64_t{block.are_starts});
    writer(block.strikes);
    writer(block.states);
    writer(block.present);
    return writer.take();
}

cli::ShotBlock block_from(const std::string& bytes) {
    Reader reader(bytes);
    cli::ShotBlock block;
    std::uint64_t are_starts = 0;
    reader(block.first);
    reader(are_starts);
    block.are_starts = are_starts != 0;
    reader(block.strikes);
    reader(block.states);
    reader(block.present);
    return block;
}

std::string bytes_of(const BatchResult& result, std::uint64_t first) {
    Writer writer;
    writer(first);
    writer(std::uint64_t{result.balls});
    visit(writer, result);
    return writer.take();
}

BlockResult result_from(const std::string& bytes) {
    Reader reader(bytes);
    BlockResult block;
    std::uint64_t balls = 0;
    reader(block.first);
    reader(balls);
    visit(reader, block.result);
    block.result.balls = balls;
    block.result.shots = block.result.status.size();
    return block;
}

}  // namespace osculo::mpi

#include "cli/batch/npz.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <memory>

#include <zip.h>

#include "cli/failure.hpp"
#include "cli/files.hpp"

namespace osculo::cli {
namespace {

// Format 1.0 of NumPy's NEP 1: magic, version, length of the header, and the header, a dictionary
// padded with blanks so that the data begin at a multiple of 64.
constexpr std::string_view kMagic{"\x93NUMPY\x01\x00", 8};
constexpr std::size_t kBefore = kMagic.size() + 2;

std::string npy_from_array(const NpyArray& array) {
    std::string shape;
    for (const std::size_t n : array.shape) shape += std::to_string(n) + ", ";
    if (array.shape.size() > 1) shape.resize(shape.size() - 2);
    if (array.shape.size() == 1) shape.resize(shape.size() - 1);  // (5,)
    std::string header =
        "{'descr': '" + array.type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    header.append(63 - (kBefore + header.size()) % 64, ' ');
    header += '\n';
    std::string result(kMagic);
    result += static_cast<char>(header.size() % 256);
    result += static_cast<char>(header.size() / 256);
    return result + header + array.bytes;
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw Failure(kInputOutput, path + ": " + what);
}

/// What stands between the two texts in the header.
std::string_view between(std::string_view header, std::string_view before, char after) {
    const std::size_t start = header.find(before);
    if (start == std::string_view::npos) return {};
    const std::string_view rest = header.substr(start + before.size());
    return rest.substr(0, rest.find(after));
}

NpyArray array_from_npy(const std::string& content, const std::string& name) {
    const auto byte = [&](std::size_t at) {
        return static_cast<std::size_t>(static_cast<unsigned char>(content[at]));
    };
    if (content.size() < kBefore + 2 || !content.starts_with(kMagic.substr(0, 6))) {
        fail(name, "is not an array of NumPy");
    }
    const bool is_long = content[6] > 1;  // versions 2 and 3 have four bytes of length
    const std::size_t start = is_long ? kBefore + 2 : kBefore;
    const std::size_t length =
        byte(8) + 256 * byte(9) + (is_long ? (byte(10) << 16U) + (byte(11) << 24U) : 0);
    if (content.size() < start + length) fail(name, "is cut off");
    const std::string_view header = std::string_view(content).substr(start, length);
    NpyArray array;
    array.type = between(header, "'descr': '", '\'');
    if (!between(header, "'fortran_order': ", ',').starts_with("False")) {
        fail(name, "must be in C order");
    }
    std::string_view shape = between(header, "'shape': (", ')');
    while (!shape.empty()) {
        std::size_t n = 0;
        const auto [end, error] = std::from_chars(shape.data(), shape.data() + shape.size(), n);
        if (error != std::errc{}) fail(name, "has no shape");
        array.shape.push_back(n);
        shape.remove_prefix(static_cast<std::size_t>(end - shape.data()));
        while (!shape.empty() && (shape[0] == ',' || shape[0] == ' ')) shape.remove_prefix(1);
    }
    array.bytes = content.substr(start + length);
    return array;
}

struct CloseZip {
    void operator()(zip_t* zip) const { zip_discard(zip); }
};
using Zip = std::unique_ptr<zip_t, CloseZip>;
struct CloseEntry {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

std::string content_of(zip_t* zip, zip_uint64_t index, zip_uint64_t size, const std::string& name) {
    const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen_index(zip, index, 0));
    std::string content(size, '\0');
    if (!file || zip_fread(file.get(), content.data(), size) != static_cast<zip_int64_t>(size)) {
        fail(name, "cannot be read from its zip");
    }
    return content;
}

}  // namespace

char byte_order() {
    return std::endian::native == std::endian::little ? '<' : '>';
}

NpyArray npy_texts(const std::vector<std::string>& texts) {
    std::vector<std::u32string> points;
    std::size_t longest = 1;
    for (const std::string& text : texts) {
        std::u32string& decoded = points.emplace_back();
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte < 0x80) {
                decoded += byte;
            } else if (byte >= 0xC0) {  // begins a character of 2, 3 or 4 bytes
                decoded += byte & (byte >= 0xF0 ? 0x07U : byte >= 0xE0 ? 0x0FU : 0x1FU);
            } else if (!decoded.empty()) {
                decoded.back() = decoded.back() << 6U | (byte & 0x3FU);
            }
        }
        longest = std::max(longest, decoded.size());
    }
    NpyArray array{byte_order() + ('U' + std::to_string(longest)), {texts.size()}, {}};
    for (std::u32string& text : points) {
        text.resize(longest);
        array.bytes.append(reinterpret_cast<const char*>(text.data()), 4 * longest);
    }
    return array;
}

std::string npz_from_arrays(const NamedArrays& arrays) {
    const auto require = [](bool holds) {
        if (!holds) throw Failure(kInputOutput, "the .npz file cannot be made");
    };
    zip_error_t error;
    zip_source_t* const source = zip_source_buffer_create(nullptr, 0, 0, &error);
    require(source != nullptr);
    zip_source_keep(source);
    const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> keep(source, &zip_source_free);
    Zip zip(zip_open_from_source(source, ZIP_TRUNCATE, &error));
    require(zip != nullptr);
    std::vector<std::string> contents;  // to be there until the zip is closed
    contents.reserve(arrays.size());
    for (const auto& [name, array] : arrays) {
        const std::string& content = contents.emplace_back(npy_from_array(array));
        zip_source_t* const part = zip_source_buffer(zip.get(), content.data(), content.size(), 0);
        const zip_int64_t index = zip_file_add(zip.get(), (name + ".npy").c_str(), part, 0);
        require(index >= 0);
        const auto entry = static_cast<zip_uint64_t>(index);
        constexpr zip_uint16_t kFirstDay = 1U << 5U | 1U;  // of 1980: always the same bytes
        require(zip_set_file_compression(zip.get(), entry, ZIP_CM_STORE, 0) == 0 &&
                zip_file_set_dostime(zip.get(), entry, 0, kFirstDay, 0) == 0);
    }
    require(zip_close(zip.get()) == 0);
    static_cast<void>(zip.release());

    require(zip_source_open(source) == 0);
    zip_stat_t status;
    require(zip_source_stat(source, &status) == 0);
    std::string result(status.size, '\0');
    const zip_int64_t got = zip_source_read(source, result.data(), result.size());
    zip_source_close(source);
    require(got == static_cast<zip_int64_t>(result.size()));
    return result;
}

NamedArrays read_npz(const std::string& path) {
    const std::string content = read_file(path);
    zip_error_t error;
    zip_source_t* const source =
        zip_source_buffer_create(content.data(), content.size(), 0, &error);
    if (source == nullptr) fail(path, "cannot be read");
    const Zip zip(zip_open_from_source(source, ZIP_RDONLY, &error));
    if (!zip) {
        zip_source_free(source);
        fail(path, "is not an .npz file");
    }
    NamedArrays arrays;
    const zip_int64_t count = zip_get_num_entries(zip.get(), 0);
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        zip_stat_t status;
        if (zip_stat_index(zip.get(), i, 0, &status) != 0) fail(path, "is broken");
        std::string name = status.name;
        const std::string full = path + ": " + name;
        if (name.ends_with(".npy")) name.resize(name.size() - 4);
        arrays.emplace_back(name,
                            array_from_npy(content_of(zip.get(), i, status.size, full), full));
    }
    return arrays;
}

const NpyArray* find_array(const NamedArrays& arrays, std::string_view name) {
    const auto found = std::ranges::find(
        arrays, name, [](const auto& named) { return std::string_view(named.first); });
    return found == arrays.end() ? nullptr : &found->second;
}

}  // namespace osculo::cli

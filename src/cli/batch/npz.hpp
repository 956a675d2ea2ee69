#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace osculo::cli {

/// An array as NumPy knows it: in C order, native byte order.
struct NpyArray {
    std::string type;                ///< as NumPy writes it, e.g. "<f8", "|u1", "<U5"
    std::vector<std::size_t> shape;  ///< none: one value
    std::string bytes;
};

/// Arrays by name, in their order.
using NamedArrays = std::vector<std::pair<std::string, NpyArray>>;

/// '<' or '>': the byte order of this machine.
[[nodiscard]] char byte_order();

/// Texts as one array of fixed width. Requires UTF-8.
[[nodiscard]] NpyArray npy_texts(const std::vector<std::string>& texts);

/// The content of an .npz file: .npy files in a zip that is not compressed. The same arrays give
/// the same bytes. Throws Failure.
[[nodiscard]] std::string npz_from_arrays(const NamedArrays& arrays);

/// The arrays of an .npz file, compressed or not. Throws Failure, with the path, for what is none,
/// and for arrays in Fortran order.
[[nodiscard]] NamedArrays read_npz(const std::string& path);

/// The array of that name, or nullptr.
[[nodiscard]] const NpyArray* find_array(const NamedArrays& arrays, std::string_view name);

}  // namespace osculo::cli

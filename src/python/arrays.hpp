#pragma once

#include <utility>
#include <vector>

#include <pybind11/numpy.h>

// What numpy calls the structs of osculo, and arrays over their memory.
namespace osculo::python {

[[nodiscard]] pybind11::dtype state_dtype();
[[nodiscard]] pybind11::dtype event_dtype();
[[nodiscard]] pybind11::dtype piece_dtype();
[[nodiscard]] pybind11::dtype final_ball_dtype();

/// An array over `data`, which cannot be written to and keeps `owner` alive. Nothing is copied.
[[nodiscard]] pybind11::array view(const pybind11::dtype& dtype,
                                   std::vector<pybind11::ssize_t> shape,
                                   std::vector<pybind11::ssize_t> strides, const void* data,
                                   const pybind11::handle& owner);

/// The same for what stands side by side.
[[nodiscard]] pybind11::array view(const pybind11::dtype& dtype,
                                   std::vector<pybind11::ssize_t> shape, const void* data,
                                   const pybind11::handle& owner);

/// The doubles that stand at `first`, a member of things[0], and in the same place of each thing:
/// `columns` of them in a row, or a single one.
template <class Thing>
[[nodiscard]] pybind11::array column_of(const std::vector<Thing>& things, const double* first,
                                        pybind11::ssize_t columns, const pybind11::handle& owner) {
    std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(things.size())};
    std::vector<pybind11::ssize_t> strides{static_cast<pybind11::ssize_t>(sizeof(Thing))};
    if (columns > 1) {
        shape.push_back(columns);
        strides.push_back(sizeof(double));
    }
    return view(pybind11::dtype::of<double>(), std::move(shape), std::move(strides), first, owner);
}

}  // namespace osculo::python

#include "python/arrays.hpp"

#include <cstddef>
#include <utility>

#include "osculo/run.hpp"
#include "python/final_ball.hpp"

namespace osculo::python {
namespace {

namespace py = pybind11;

// A numpy type, member by member.
class Members {
public:
    template <class Member>
    Members& add(const char* name, std::size_t offset, py::ssize_t count = 1) {
        return add(name, offset, py::dtype::of<Member>(), count);
    }

    Members& add(const char* name, std::size_t offset, py::object dtype, py::ssize_t count = 1) {
        names_.append(name);
        formats_.append(count == 1 ? std::move(dtype) : py::make_tuple(dtype, count));
        offsets_.append(offset);
        return *this;
    }

    [[nodiscard]] py::dtype of_size(std::size_t size) const {
        py::dict description;
        description["names"] = names_;
        description["formats"] = formats_;
        description["offsets"] = offsets_;
        description["itemsize"] = size;
        return py::dtype::from_args(description);
    }

private:
    py::list names_, formats_, offsets_;
};

}  // namespace

py::dtype state_dtype() {
    return Members()
        .add<double>("position", offsetof(BallState, position), 2)
        .add<double>("velocity", offsetof(BallState, velocity), 2)
        .add<double>("spin", offsetof(BallState, spin), 3)
        .of_size(sizeof(BallState));
}

py::dtype event_dtype() {
    return Members()
        .add<double>("time", offsetof(Event, time))
        .add<double>("time_low", offsetof(Event, time_low))
        .add<int>("kind", offsetof(Event, kind))
        .add<std::uint32_t>("ball", offsetof(Event, ball))
        .add<std::uint32_t>("other", offsetof(Event, other))
        .add<double>("point", offsetof(Event, point), 2)
        .add<double>("normal", offsetof(Event, normal), 2)
        .add("before", offsetof(Event, before), state_dtype(), 2)
        .add("after", offsetof(Event, after), state_dtype(), 2)
        .add<std::uint32_t>("cluster", offsetof(Event, cluster))
        .add<bool>("well_posed", offsetof(Event, well_posed))
        .add<int>("from", offsetof(Event, from))
        .add<int>("to", offsetof(Event, to))
        .of_size(sizeof(Event));
}

py::dtype piece_dtype() {
    return Members()
        .add<std::uint32_t>("ball", offsetof(Piece, ball))
        .add<double>("from", offsetof(Piece, from))
        .add<double>("from_low", offsetof(Piece, from_low))
        .add<double>("to", offsetof(Piece, to))
        .add<double>("to_low", offsetof(Piece, to_low))
        .add<double>("position", offsetof(Piece, position), 2)
        .add<double>("position_low", offsetof(Piece, position_low), 2)
        .add<double>("velocity", offsetof(Piece, velocity), 2)
        .add<double>("acceleration", offsetof(Piece, acceleration), 2)
        .add<double>("spin", offsetof(Piece, spin), 3)
        .add<double>("spin_rate", offsetof(Piece, spin_rate), 3)
        .add<double>("resistance", offsetof(Piece, resistance), 3)
        .add<std::uint32_t>("rim", offsetof(Piece, rim))
        .add<double>("height", offsetof(Piece, height))
        .add<double>("climb", offsetof(Piece, climb))
        .add<double>("inertia", offsetof(Piece, inertia))
        .add<int>("phase", offsetof(Piece, phase))
        .of_size(sizeof(Piece));
}

py::dtype final_ball_dtype() {
    return Members()
        .add<std::int32_t>("fate", offsetof(FinalBallRow, fate))
        .add<std::int32_t>("rim", offsetof(FinalBallRow, rim))
        .add("state", offsetof(FinalBallRow, state), state_dtype())
        .of_size(sizeof(FinalBallRow));
}

py::array view(const py::dtype& dtype, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* data, const py::handle& owner) {
    // Without an owner numpy would copy; an empty vector may have no memory at all.
    static constexpr double kNothing = 0;
    py::array array(dtype, std::move(shape), std::move(strides), data ? data : &kNothing, owner);
    array.attr("flags").attr("writeable") = false;
    return array;
}

py::array view(const py::dtype& dtype, std::vector<py::ssize_t> shape, const void* data,
               const py::handle& owner) {
    std::vector<py::ssize_t> strides(shape.size());
    py::ssize_t stride = dtype.itemsize();
    for (std::size_t i = shape.size(); i-- > 0;) {
        strides[i] = stride;
        stride *= shape[i];
    }
    return view(dtype, std::move(shape), std::move(strides), data, owner);
}

}  // namespace osculo::python

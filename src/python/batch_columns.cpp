#include "python/batch_columns.hpp"

#include <type_traits>
#include <utility>

#include "python/arrays.hpp"

namespace osculo::python {

namespace py = pybind11;

namespace {

template <class Value>
py::dtype dtype_of() {
    if constexpr (std::is_same_v<Value, BallState>) {
        return state_dtype();
    } else if constexpr (std::is_same_v<Value, Event>) {
        return event_dtype();
    } else if constexpr (std::is_same_v<Value, Piece>) {
        return piece_dtype();
    } else if constexpr (std::is_enum_v<Value>) {
        return py::dtype::of<std::underlying_type_t<Value>>();
    } else {
        return py::dtype::of<Value>();
    }
}

// Adds columns that stand side by side in the memory of one result.
class Columns {
public:
    Columns(const BatchResult& result, py::object owner)
        : shots_(static_cast<py::ssize_t>(result.shots)),
          balls_(static_cast<py::ssize_t>(result.balls)),
          owner_(std::move(owner)) {}

    template <class Value>
    void of_shots(const char* name, const std::vector<Value>& values) {
        add(name, values, {shots_});
    }

    template <class Value>
    void of_balls(const char* name, const std::vector<Value>& values) {
        add(name, values, {shots_, balls_});
    }

    template <class Value>
    void list(const char* name, const std::vector<Value>& values) {
        add(name, values, {static_cast<py::ssize_t>(values.size())});
    }

    void points(const char* name, const std::vector<Point>& points) {
        dict_[name] = view(py::dtype::of<double>(), {shots_, balls_, 2}, points.data(), owner_);
    }

    [[nodiscard]] py::dict take() { return std::move(dict_); }

private:
    template <class Value>
    void add(const char* name, const std::vector<Value>& values, std::vector<py::ssize_t> shape) {
        dict_[name] = view(dtype_of<Value>(), std::move(shape), values.data(), owner_);
    }

    py::ssize_t shots_, balls_;
    py::object owner_;
    py::dict dict_;
};

}  // namespace

py::dict columns_of(std::unique_ptr<BatchResult> owned) {
    const BatchResult& result = *owned;
    Columns columns(result, py::capsule(owned.get(), [](void* memory) {
                        delete static_cast<BatchResult*>(memory);
                    }));
    static_cast<void>(owned.release());  // the capsule's from here on

    columns.of_shots("status", result.status);
    columns.of_shots("time", result.time);
    columns.of_shots("event_count", result.event_count);
    columns.of_shots("cue_ball", result.cue_ball);
    columns.of_shots("first_hit", result.first_hit);
    columns.of_shots("cushions_before_hit", result.cushions_before_hit);
    columns.of_shots("cushions_after_hit", result.cushions_after_hit);
    columns.of_shots("driven_to_cushion", result.driven_to_cushion);
    columns.of_shots("kisses", result.kisses);
    columns.of_shots("settled_count", result.settled_count);
    columns.of_balls("fate", result.fate);
    columns.points("position", result.position);
    columns.of_balls("rim", result.rim);
    columns.of_balls("capture_time", result.capture_time);
    columns.of_balls("ball_contacts", result.ball_contacts);
    columns.of_balls("cushion_contacts", result.cushion_contacts);
    if (!result.state.empty()) columns.of_balls("state", result.state);
    if (!result.event_offsets.empty()) {
        columns.list("event_offsets", result.event_offsets);
        columns.list("events", result.events);
    }
    if (!result.piece_offsets.empty()) {
        columns.list("piece_offsets", result.piece_offsets);
        columns.list("pieces", result.pieces);
    }
    return columns.take();
}

}  // namespace osculo::python

#include <exception>

#include "osculo/io.hpp"
#include "python/bindings.hpp"

namespace osculo::python {
namespace {

// The classes are Python, so that they can be pickled and shown like any other.
template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
    const pybind11::object type = pybind11::module_::import("osculo._errors").attr(name);
    PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

void translate(std::exception_ptr pointer) {
    try {
        if (pointer) std::rethrow_exception(pointer);
    } catch (const SceneError& error) {
        raise("SceneError", error.path(), error.rule(), error.value());
    } catch (const io::FormatError& error) {
        raise("FormatError", error.what());
    }
}

}  // namespace

void bind_errors(pybind11::module_&) {
    pybind11::register_exception_translator(translate);
}

}  // namespace osculo::python

#include "python/src/errors.hpp"

#include <stdexcept>

namespace castaway::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  // Never destroyed: the interpreter may be gone when statics are.
  static PyObject* error = PyErr_NewExceptionWithDoc(
      "castaway.Error", "A run, a file or a setting that castaway cannot work with; says why.",
      PyExc_RuntimeError, nullptr);
  module.add_object("Error", error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const py::builtin_exception&) {
      throw;  // StopIteration and the like: also a std::runtime_error.
    } catch (const std::runtime_error& what) {
      PyErr_SetString(error, what.what());
    }
  });
}

}  // namespace castaway::python

/// castaway's errors in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

/// Adds `Error`, which std::runtime_error becomes, with the same text. std::invalid_argument
/// becomes ValueError; exceptions of Python pass through C++ unchanged.
void bind_errors(pybind11::module_& module);

}  // namespace castaway::python

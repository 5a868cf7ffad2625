/// `NativeLocalizer`: castaway's own localizers, to be called from Python.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

void bind_native_localizer(pybind11::module_& module);

}  // namespace castaway::python

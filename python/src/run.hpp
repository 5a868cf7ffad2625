/// `play`: a run of a scenario.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

void bind_run(pybind11::module_& module);

}  // namespace castaway::python

/// `evaluate_log`: localizers on recorded logs.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

void bind_evaluate(pybind11::module_& module);

}  // namespace castaway::python

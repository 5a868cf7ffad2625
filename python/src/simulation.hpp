/// `Simulation`: a simulator to step through, to drive and to kidnap in.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

void bind_simulation(pybind11::module_& module);

}  // namespace castaway::python

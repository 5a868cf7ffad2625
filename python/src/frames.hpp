/// `OdometryFrame`, `ScanFrame` and `Event`: what a simulation delivers.
#pragma once

#include <pybind11/pybind11.h>

#include "tools/run/frame.hpp"

namespace castaway::python {

/// Moves the frame to Python, without a copy of its arrays.
pybind11::object to_python(testbed::Frame frame);

void bind_frames(pybind11::module_& module);

}  // namespace castaway::python

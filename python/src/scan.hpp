/// `Scan` and `Lidar`.
#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "castaway/readings.hpp"

namespace castaway::python {

/// A scan that Python holds: shared by the arrays that view its ranges.
using SharedScan = std::shared_ptr<localization::LaserScan>;

void bind_scan(pybind11::module_& module);

}  // namespace castaway::python

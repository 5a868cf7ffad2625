/// Scenarios as Python names them.
#pragma once

#include <pybind11/pybind11.h>

namespace castaway::python {

/// Adds `ScenarioRequest`, which is castaway::Scenario, and what reads scenarios and names.
void bind_scenario(pybind11::module_& module);

}  // namespace castaway::python

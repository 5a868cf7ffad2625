/// Scenarios as Python names them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "tools/scenario/scenario_file.hpp"

namespace castaway::python {

/// A scenario with its changes.
struct ScenarioRequest {
  std::string scenario;                ///< A file, or <world>/<name>.
  std::vector<std::string> overrides;  ///< key=value
  bool allow_programs = false;         ///< The file may name programs and libraries.
};

/// A scenario that was read, and its file.
struct ReadScenario {
  std::filesystem::path file;
  testbed::LoadedScenario loaded;
};

/// @throws std::runtime_error, std::invalid_argument as the program prints them.
ReadScenario read_scenario(const ScenarioRequest& request);

/// Adds `ScenarioRequest` and what reads scenarios and names.
void bind_scenario(pybind11::module_& module);

}  // namespace castaway::python

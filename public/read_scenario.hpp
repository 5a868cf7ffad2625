/// A scenario of castaway/scenario.hpp, read.
#pragma once

#include <filesystem>

#include "castaway/scenario.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway {

/// A scenario that was read, and its file.
struct ReadScenario {
  std::filesystem::path file;
  testbed::LoadedScenario loaded;
};

/// @throws std::runtime_error, std::invalid_argument as the program prints them.
ReadScenario read_scenario(const Scenario& scenario);

}  // namespace castaway

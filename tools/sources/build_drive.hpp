/// What a simulated robot drives, from a scenario.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/simulation.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// What routes a world has and where there is room; pointers must outlive the call.
struct RouteWorld {
  const std::map<std::string, std::vector<Eigen::Vector2d>>* routes;
  const sim::Grid* grid;
  std::string name;  ///< For errors.
};

/// Route or recorded commands, and limits. "random": thirty places drawn by the seed; "explore":
/// places all over the free space, each as far as can be from all before it. `base`: folder that a
/// log's path starts from, besides the current one. Throws std::runtime_error if there is no such
/// route or log, or nowhere to drive.
sim::DriveConfig build_drive(const Scenario& scenario, const std::filesystem::path& base,
                             const RouteWorld& world, const sim::RobotModel& robot);

}  // namespace castaway::testbed

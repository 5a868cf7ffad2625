/// Builds the drive of a simulated robot from a scenario.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/simulation.hpp"
#include "sim/stages/spaces.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Routes and free space of a world; the pointers must outlive the call.
struct RouteWorld {
  const std::map<std::string, std::vector<Eigen::Vector2d>>* routes;
  const sim::Grid* grid;
  sim::Spaces* spaces;
  std::string name;                                 ///< Name of the world, for errors.
  std::shared_ptr<const sim::LevelPlane> levels{};  ///< Its floors, if robots drive on all.
};

/// Builds the route or recorded commands, and the limits. "random": thirty places drawn from the
/// seed, on levels from all of them. "explore": places all over the free space, each as far as
/// possible from all before it. `base`: folder that a log's path may start from, besides the
/// current one. Throws std::runtime_error if there is no such route or log, or no space to drive.
sim::DriveConfig build_drive(const Scenario& scenario, const std::filesystem::path& base,
                             const RouteWorld& world, const sim::RobotModel& robot);

}  // namespace castaway::testbed

/// Builds the sensors of a simulation from a scenario.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Builds a lidar of the robot with a profile and a scenario's changes. `base`: folder that a
/// file of scan times may start from, besides the current one. A lidar with the name of
/// one of the robot's lidars has that one's mount; without a name, it is the first. Throws
/// std::invalid_argument if a value is out of range, std::runtime_error for an unknown profile or
/// an unreadable file.
sim::LidarConfig build_lidar(const LidarSpec& spec, const sim::RobotModel& robot,
                             const std::filesystem::path& base = {});

/// Builds all lidars of a run: those that the scenario lists, or all that the robot has.
std::vector<sim::LidarConfig> build_lidars(const Scenario& scenario, const sim::RobotModel& robot,
                                           const std::filesystem::path& base = {});

/// Throws std::invalid_argument, naming the nearest lidar, if a fault refers to a lidar that does
/// not exist.
void check_faults(const std::vector<sim::FaultSpec>& faults,
                  const std::vector<sim::LidarConfig>& lidars);

}  // namespace castaway::testbed

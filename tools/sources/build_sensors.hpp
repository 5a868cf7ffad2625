/// The sensors of a simulation from a scenario.
#pragma once

#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A lidar of the robot with a profile and a scenario's changes. A lidar that is named like one of
/// the robot's sits where that one does; without a name, it is the first. Throws
/// std::invalid_argument where a figure is out of its range, std::runtime_error for an unknown
/// profile.
sim::LidarConfig build_lidar(const LidarSpec& spec, const sim::RobotModel& robot);

/// All lidars of a run: those that the scenario lists, or all that the robot has.
std::vector<sim::LidarConfig> build_lidars(const Scenario& scenario, const sim::RobotModel& robot);

/// Throws std::invalid_argument if a fault means a lidar that there is not, naming the nearest.
void check_faults(const std::vector<sim::FaultSpec>& faults,
                  const std::vector<sim::LidarConfig>& lidars);

}  // namespace castaway::testbed

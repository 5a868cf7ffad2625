/// A simulation from a scenario.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/simulation.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A simulation ready to start, and what pictures and localizers need to know of it.
struct PreparedSimulation {
  sim::SimulationConfig config;
  RosMap map;  ///< What the localizers are given.
  std::string world_name;
  std::vector<std::string> warnings;        ///< Of the robot's description and of the world.
  std::optional<MapDifference> difference;  ///< Nothing: the map shows the world as it is.
};

/// Loads world and robot and puts everything together. `base` is the folder that relative paths of
/// the scenario start from, besides the current one. A world made of objects is surveyed at the
/// first lidar's height; a ROS map is extruded and handed to the localizers as it is. Throws
/// std::runtime_error or std::invalid_argument naming what is wrong.
PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base);

/// The same in a world that is `map`, pulled up; what the scenario says of its world is not looked
/// at.
PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    RosMap map);

}  // namespace castaway::testbed

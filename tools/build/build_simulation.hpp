/// Builds a simulation from a scenario.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/simulation.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"
#include "tools/build/shared_worlds.hpp"
#include "tools/run/run_sink.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A simulation ready to start, with the data that pictures and localizers need.
struct PreparedSimulation {
  sim::SimulationConfig config;
  RosMap map;                             ///< Map given to the localizers.
  std::shared_ptr<const Map3d> survey{};  ///< Of a world with floors, if it was surveyed now.
  std::string world_name;
  std::vector<std::string> warnings;        ///< About the robot's description and the world.
  std::vector<std::string> notes;           ///< For summary and report; see `RunInfo`.
  std::optional<MapDifference> difference;  ///< Nothing if the map shows the world as it is.
};

/// Loads world and robot and builds the simulation. `base` is the folder that relative paths of the
/// scenario start from, besides the current one. A world made of objects is surveyed at the first
/// lidar's height. A ROS map is extruded, and the localizers get it unchanged. Throws
/// std::runtime_error or std::invalid_argument naming what is wrong.
///
/// `worlds`: of this process, where the world may be already; nullptr: it is built.
PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    SharedWorlds* worlds = nullptr);

/// Builds the simulation in a world extruded from `map`; the scenario's own world is ignored.
PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    RosMap map);

}  // namespace castaway::testbed

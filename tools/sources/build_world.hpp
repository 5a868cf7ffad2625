/// A world from what a scenario or a command line says of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/difference/changed_beams.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/world/world_file.hpp"

namespace castaway::testbed {

/// What the difference layer did.
struct WorldDifference {
  int moved = 0;    ///< Pieces of furniture.
  int removed = 0;  ///< Pieces of furniture.
  int opened = 0;   ///< Doors.
  int closed = 0;   ///< Doors.
  int added = 0;    ///< Objects.
};

/// A world with its survey, routes and start, whatever it was made from.
struct LoadedWorld {
  WorldFile file;  ///< As the world is now.
  sim::Grid grid;  ///< As it was when the map was made.
  RosMap map;      ///< The same for the localizers.
  bool has_start = true;
  std::optional<WorldDifference> difference;  ///< Nothing: the layer is empty.
  std::vector<std::string> warnings;
};

/// How a world is made into a run's.
struct SurveyOptions {
  double lidar_height = 0.15;  ///< [m] A world made of objects is surveyed at this height.
  double wall_height = 2.0;    ///< [m] Of a world made from a map.
  /// [m] Where the robot starts, for worlds without a start of their own.
  std::optional<Eigen::Vector2d> inside = {};
  double robot_radius = 0.2;  ///< [m] Free space that it does not pass through is no part of a run.
  bool strict = false;        ///< A piece of a world that cannot be read is an error.
  std::uint64_t seed = 1;     ///< Of the run; the layer draws from its substream "differences".
};

/// Finds a world (`world.yaml`, `.sdf`, `.world`, ROS map), surveys it, then changes it as its
/// file, or else the scenario, says. Throws std::runtime_error naming what is wrong.
LoadedWorld build_world(const WorldChoice& choice, const std::filesystem::path& base,
                        const SurveyOptions& options);

/// A world that is `map`, pulled up. Free space other than the part that the run is about (see
/// `sim::choose_free`) is unknown in its grid, while the localizers are given the map as it is.
LoadedWorld world_of_map(RosMap map, const SurveyOptions& options);

/// True if the world holds what is not on its map, or the reverse.
bool differs_from_map(const sim::WorldSpec& world);

}  // namespace castaway::testbed

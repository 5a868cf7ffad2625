/// Builds a world from a scenario or a command line.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/difference/changed_beams.hpp"
#include "sim/stages/spaces.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/world/world_file.hpp"

namespace castaway::testbed {

/// A world with its survey, routes and start, in a common form for all sources.
struct LoadedWorld {
  WorldFile file;  ///< The world as it is now.
  sim::Grid grid;  ///< The world as it was when the map was made.
  RosMap map;      ///< The same as a map for the localizers.
  bool has_start = true;
  /// What the difference layer changed, without `beams`; nothing if it is empty.
  std::optional<MapDifference> difference;
  std::vector<std::string> warnings;
  std::shared_ptr<sim::Spaces> spaces;  ///< Where runs share the world; otherwise empty.
};

/// Options for building a world.
struct SurveyOptions {
  double lidar_height = 0.15;  ///< [m] Height at which a world made of objects is surveyed.
  double wall_height = 2.0;    ///< [m] For a world made from a map.
  /// [m] Start of the robot, for worlds without a start of their own.
  std::optional<Eigen::Vector2d> inside = {};
  double robot_radius = 0.2;  ///< [m] Free space that the robot cannot reach is excluded.
  bool strict = false;        ///< An unreadable part of a world is an error.
  std::uint64_t seed = 1;     ///< Seed of the run; the layer draws from its substream
                              ///< "differences".
};

/// Finds a world (`world.yaml`, `.sdf`, `.world`, ROS map), surveys it, then applies the
/// differences of the scenario or else of the world's file. Throws std::runtime_error naming what
/// is wrong.
LoadedWorld build_world(const WorldChoice& choice, const std::filesystem::path& base,
                        const SurveyOptions& options);

/// Builds a world by extruding `map`. Free space outside the region chosen by `sim::choose_free` is
/// unknown in its grid; the localizers get the map unchanged.
LoadedWorld world_of_map(RosMap map, const SurveyOptions& options);

/// True if an object of the world is missing on the map, or the reverse.
bool differs_from_map(const sim::WorldSpec& world);

}  // namespace castaway::testbed

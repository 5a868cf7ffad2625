/// World files: objects and routes.
///
///     name: lab
///     extent: {min: [-2.1, -4.4], max: [8.4, 5.6]}   # [m] floor and rasterised map
///     start: [0, 0, 0]                               # x [m], y [m], yaw [rad]
///     map: map.yaml                                  # optional, relative to this file
///     objects:
///       - wall: {points: [[0, 0], [4, 0], [4, 3]], closed: false, thickness: 0.1, height: 2.4}
///       - box: {at: [1, 2], size: [0.6, 0.4, 1.8], yaw_deg: 30, color: "#8d6e63"}
///       - cylinder: {at: [3, 1], radius: 0.2, height: 2.4}
///       - table: {at: [2, 2], size: [1.6, 0.8, 0.74], leg: 0.05}   # a top on four legs
///       - mesh: {at: [1, 1], file: meshes/chair.obj, scale: 1.0}
///     routes: {loop: [[0, 0], [3, 0], [3, 2]]}       # [m] closed: the last leads to the first
///
/// docs/worlds.md lists all kinds of objects and their keys.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/difference/difference.hpp"
#include "sim/world/world.hpp"

namespace castaway::testbed {

/// Content of a world file.
struct WorldFile {
  sim::WorldSpec spec;
  std::map<std::string, std::vector<Eigen::Vector2d>> routes;  ///< [m] By name; points in map.
  sim::Pose2 start;                                            ///< Pose of base in map.
  std::optional<std::filesystem::path> map;  ///< YAML file of its map; it may not exist yet.
  sim::DifferenceSpec differences;           ///< Changes since mapping; a scenario may override
                                             ///< them.
};

/// Reads a world; for a folder, its `world.yaml`. Throws std::runtime_error naming file, line, key
/// and remedy.
WorldFile load_world(const std::filesystem::path& path);

}  // namespace castaway::testbed

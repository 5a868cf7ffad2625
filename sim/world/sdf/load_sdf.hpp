/// Worlds of Gazebo: SDF files, read by libsdformat.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/world/floor.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// How a world is read.
struct SdfOptions {
  /// Folders of models and meshes, besides those of `ResourceFinder`.
  std::vector<std::string> search_paths{};
  std::optional<Eigen::Vector2d> start{};  ///< [m] Where the robot starts; nothing: anywhere.
  bool strict = false;                     ///< A piece that cannot be read is an error.
};

/// A world and what was left out of it.
struct SdfWorld {
  WorldSpec spec;                ///< Its floor is z = 0.
  double floor = 0.0;            ///< [m] Height of the floor in the file.
  std::optional<Ground> ground;  ///< A level plane at the floor's height.
  std::vector<std::string> warnings;
};

/// Loads the collision geometry of an SDF file's first world (or of its one model): boxes,
/// cylinders, spheres, meshes; capsules and ellipsoids as the cylinders and boxes about them; of
/// planes the ground. Colours are those of the first visual of each link. Models that can move
/// stand where they are; other geometry, and what cannot be read, is left out, each kind with a
/// warning; lights, plugins, sensors, joints and physics are no part of it. The world is lowered so
/// that its floor (see `floor_height`) is z = 0; what ends below 1 cm is floor. The extent is that
/// of what stands on it. A file that ends in `.xacro` is expanded first.
/// @throws std::runtime_error, std::length_error naming file and reason.
SdfWorld load_sdf(const std::string& path, const SdfOptions& options);

}  // namespace castaway::sim

/// Loads Gazebo worlds: SDF files, read by libsdformat.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/random.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Options of reading a world.
struct SdfOptions {
  /// Folders of models and meshes, in addition to those of `ResourceFinder`.
  std::vector<std::string> search_paths{};
  std::optional<Eigen::Vector2d> start{};  ///< [m] Where the robot starts; nothing: unknown.
  bool strict = false;     ///< A piece that cannot be read is an error instead of a warning.
  NamedStreams streams{};  ///< Draw the places of populations ("population/NAME").
};

/// A world, and warnings about what was left out.
struct SdfWorld {
  WorldSpec spec;                ///< With its floor at z = 0.
  double floor = 0.0;            ///< [m] Height of the floor in the file.
  std::optional<Ground> ground;  ///< A level plane at the floor's height.
  std::vector<std::string> warnings;
};

/// Loads the collision geometry of an SDF file's first world (or of its only model): boxes,
/// cylinders, spheres and meshes; capsules as circumscribed cylinders and ellipsoids as
/// circumscribed boxes; of planes only the ground. Each link has the colour of its first visual.
/// Models that could move are static. The first `<state>` and the populations of Gazebo classic are
/// applied. Other geometry, and what cannot be read, is left out, with
/// one warning per kind; lights, plugins, sensors, joints and physics are ignored. The world is
/// lowered so that its floor (see `floor_height`) is at z = 0; objects that end below 1 cm are part
/// of the floor. The extent is that of the objects on it. A file that ends in `.xacro` is expanded
/// first.
/// @throws std::runtime_error, std::length_error naming file and reason.
SdfWorld load_sdf(const std::string& path, const SdfOptions& options);

}  // namespace castaway::sim

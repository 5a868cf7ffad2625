/// Worlds of Gazebo: SDF files, read by libsdformat.
#pragma once

#include <string>
#include <vector>

#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// A world and what was left out of it.
struct SdfWorld {
  WorldSpec spec;
  std::vector<std::string> warnings;
};

/// Loads the collision geometry of an SDF file's first world (or of its one model): boxes,
/// cylinders, spheres, meshes; of planes the ground. Colours are those of the first visual of each
/// link. Models that can move stand where they are, with a warning; other geometry is left out,
/// with a warning; lights, plugins, sensors, joints and physics are no part of it. What ends below
/// 1 cm is floor. The extent is the geometry's. `search_paths`: folders of models and meshes,
/// besides those of `ResourceFinder`.
/// @throws std::runtime_error, std::length_error naming file and reason.
SdfWorld load_sdf(const std::string& path, const std::vector<std::string>& search_paths);

}  // namespace castaway::sim

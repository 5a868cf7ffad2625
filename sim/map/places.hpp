/// What a lidar sees from all over a world.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_scene.hpp"
#include "sim/map/free_space.hpp"

namespace castaway::sim {

/// A level scan without noise.
struct PlaceView {
  double z = 0.15;          ///< [m] Height of the beams.
  double range_max = 12.0;  ///< [m] Longer beams count as this long.
  int beams = 72;           ///< Evenly over a full circle.
};

/// Free places on a lattice of about `spacing` [m], aligned with the grid: by rows, from its
/// origin.
std::vector<Eigen::Vector2d> even_places(const FreeSpace& free, double spacing);

/// What level beams at a height `z` [m] can meet of a world: they meet the same in a scene of all
/// of it, but take longer there. @throws std::runtime_error if a mesh cannot be read.
RayScene level_scene(const WorldSpec& world, double z);

/// Ranges from a place; the first beam at `heading` [rad] in map. [m]
std::vector<float> scan_at(const RayScene& scene, const Eigen::Vector2d& p_map, double heading,
                           const PlaceView& view);

}  // namespace castaway::sim

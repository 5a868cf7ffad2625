/// Scans from places all over a world.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_scene.hpp"
#include "sim/map/free_space.hpp"

namespace castaway::sim {

/// A level scan without noise.
struct PlaceView {
  double z = 0.15;          ///< [m] Height of the beams.
  double range_max = 12.0;  ///< [m] Longer beams are cut to this length.
  int beams = 72;           ///< Evenly over a full circle.
};

/// Free places on a lattice with steps of about `spacing` [m], aligned with the grid; row by row,
/// from its origin.
std::vector<Eigen::Vector2d> even_places(const FreeSpace& free, double spacing);

/// The primitives that level beams at a height `z` [m] can hit. A scene of the whole world gives
/// the same hits, more slowly. @throws std::runtime_error if a mesh cannot be read.
RayScene level_scene(const WorldSpec& world, double z);

/// Ranges from a place; the first beam points to `heading` [rad] in map. [m]
std::vector<float> scan_at(const RayScene& scene, const Eigen::Vector2d& p_map, double heading,
                           const PlaceView& view);

}  // namespace castaway::sim

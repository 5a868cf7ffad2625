/// Points on all surfaces of a world, for 3-D maps.
#pragma once

#include <array>
#include <functional>

#include <Eigen/Core>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// Takes a point in map. [m]
using PointVisitor = std::function<void(const Eigen::Vector3d& p_map)>;
/// The same with the unit normal of its surface, away from the object.
using SurfaceVisitor =
    std::function<void(const Eigen::Vector3d& p_map, const Eigen::Vector3d& normal)>;

/// Visits points on a triangle, at most `spacing` [m] apart: centres of equal pieces of rows along
/// its longest edge. A triangle without area gives none.
void sample_triangle(std::array<Eigen::Vector3d, 3> corners, double spacing,
                     const PointVisitor& visit);

/// Visits points, at most `spacing` [m] apart, on the floor of a world's extent and on all objects
/// that are on its map, above the floor. Surfaces within solids and under terrain are left out.
/// Glass counts as a surface. Deterministic.
/// @throws std::invalid_argument if the world has no extent, std::runtime_error if a mesh cannot be
/// read.
void sample_surfaces(const WorldSpec& world, double spacing, const SurfaceVisitor& visit);

}  // namespace castaway::sim

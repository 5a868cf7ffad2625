/// Objects seen from above.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/slice.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Convex hull of an object seen from above, in map; round shapes as polygons around them.
/// @throws std::runtime_error if a mesh cannot be read.
ConvexOutline footprint(const WorldObject& object);

/// Bounds of an object in map. [m] @throws std::runtime_error if a mesh cannot be read.
Eigen::AlignedBox3d bounds(const WorldObject& object);

/// A moved outline: turned by `yaw` [rad] about `center`, then shifted by `by` [m].
ConvexOutline moved(const ConvexOutline& outline, const Eigen::Vector2d& center, double yaw,
                    const Eigen::Vector2d& by);

/// True if two outlines have a point in common. Separating axes.
bool overlap(const ConvexOutline& a, const ConvexOutline& b);

/// Distance of a point from an outline, 0 within it. [m]
double distance(const ConvexOutline& outline, const Eigen::Vector2d& p);

}  // namespace castaway::sim

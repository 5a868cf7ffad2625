/// Outlines of objects seen from above.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/slice.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Convex hull of an object seen from above, in map; circles become circumscribed polygons.
/// @throws std::runtime_error if a mesh cannot be read.
ConvexOutline footprint(const WorldObject& object);

/// Bounds of an object in map. [m] @throws std::runtime_error if a mesh cannot be read.
Eigen::AlignedBox3d bounds(const WorldObject& object);

/// The outline rotated by `yaw` [rad] about `center`, then shifted by `by` [m].
ConvexOutline transform_outline(const ConvexOutline& outline, const Eigen::Vector2d& center,
                                double yaw, const Eigen::Vector2d& by);

/// True if two outlines have a point in common (separating axis test).
bool overlap(const ConvexOutline& a, const ConvexOutline& b);

/// Distance of a point from an outline, 0 inside. [m]
double distance(const ConvexOutline& outline, const Eigen::Vector2d& p);

}  // namespace castaway::sim

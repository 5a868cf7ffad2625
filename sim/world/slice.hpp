/// Horizontal cuts of a world's shapes: what a level lidar sees.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// A filled convex outline, counter-clockwise. [m]
struct ConvexOutline {
  std::vector<Eigen::Vector2d> points;
};
/// A filled disc.
struct Disc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m]
  double radius = 0.0;                               ///< [m]
};
/// A line segment in which a plane cuts a mesh's surface.
struct Segment {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
};

/// The intersection of a plane and a shape.
struct Slice {
  std::vector<ConvexOutline> outlines;
  std::vector<Disc> discs;
  std::vector<Segment> segments;
};

/// Cuts an object at height `z` [m]. Exact for boxes, meshes and upright cylinders; tilted
/// cylinders are cut as prisms with 64 sides. A face in the plane belongs to the cut.
/// @throws std::runtime_error if a mesh cannot be read.
Slice slice(const WorldObject& object, double z);

/// The cuts at several heights, in their order; a mesh is read once.
std::vector<Slice> slices(const WorldObject& object, const std::vector<double>& heights);

/// True if the closed rectangle [min, max] and the figure have a point in common.
bool touches(const ConvexOutline& outline, const Eigen::AlignedBox2d& rectangle);
bool touches(const Disc& disc, const Eigen::AlignedBox2d& rectangle);
bool touches(const Segment& segment, const Eigen::AlignedBox2d& rectangle);

/// Bounds of a figure. [m]
Eigen::AlignedBox2d bounds(const ConvexOutline& outline);
Eigen::AlignedBox2d bounds(const Disc& disc);
Eigen::AlignedBox2d bounds(const Segment& segment);

}  // namespace castaway::sim

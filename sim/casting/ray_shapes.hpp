/// Exact intersections of a ray with solids and triangles.
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// A half line.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< Unit.
};

/// A cuboid centred on its frame.
struct RayBox {
  Eigen::Vector3d half_size = Eigen::Vector3d::Ones();  ///< [m]
};
/// A cylinder along z, centred on its frame.
struct RayCylinder {
  double radius = 1.0;       ///< [m]
  double half_height = 1.0;  ///< [m]
};
/// A ball.
struct RaySphere {
  double radius = 1.0;  ///< [m]
};
/// A cylinder along z with half balls on its ends.
struct RayCapsule {
  double radius = 1.0;       ///< [m]
  double half_height = 1.0;  ///< [m] Of the cylinder, without the half balls.
};
/// A triangle in its frame, hit from both sides.
struct RayTriangle {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::UnitX();
  Eigen::Vector3d c = Eigen::Vector3d::UnitY();
};

using RayShape = std::variant<RayBox, RayCylinder, RaySphere, RayCapsule, RayTriangle>;

/// A placed shape and the object it belongs to.
struct RayPrimitive {
  RayShape shape;
  Eigen::Isometry3d T_map_shape = Eigen::Isometry3d::Identity();
  int object = 0;  ///< Label returned with hits.
};

/// "No intersection".
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Distance along the ray to where it enters the shape, kNoHit if it does not. 0 if the ray starts
/// inside of a solid. The ray is given in the frame of the shape.
double intersect(const RayShape& shape, const Ray& ray);
/// The same for a ray in map.
double intersect(const RayPrimitive& primitive, const Ray& ray);

/// Axis-aligned bounds of a primitive in map; tight except for tilted cylinders.
Eigen::AlignedBox3d bounds(const RayPrimitive& primitive);

/// The shapes of a world's static objects, labelled with their indices; meshes become triangles.
/// @throws std::runtime_error if a mesh cannot be read.
std::vector<RayPrimitive> ray_primitives(const WorldSpec& world);

}  // namespace castaway::sim

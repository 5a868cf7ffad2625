/// Points and triangle meshes of simple bodies, centred on their frames, with outward normals.
#pragma once

#include <Eigen/Core>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// The point of the plane at height `z`. [m]
inline Eigen::Vector3f raise_point(const Eigen::Vector2d& p, double z) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(z)};
}

/// A cuboid with full edge lengths `size`. [m]
TriangleMesh box_mesh(const Eigen::Vector3f& size);

/// A closed cylinder about z. `segments` >= 3 sides. [m]
TriangleMesh cylinder_mesh(float radius, float height, int segments = 32);

/// A sphere of `rings` >= 2 bands and 2 * `rings` sectors. [m]
TriangleMesh sphere_mesh(float radius, int rings = 12);

/// A horizontal rectangle at z = 0 from `min_corner` to `max_corner`, facing up. [m]
TriangleMesh ground_mesh(const Eigen::Vector2f& min_corner, const Eigen::Vector2f& max_corner);

/// An arrow along x in the plane z = 0, facing up: from the origin to `length`. [m]
TriangleMesh arrow_mesh(float length, float width);

}  // namespace castaway::sim

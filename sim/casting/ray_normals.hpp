/// Surface normals where rays hit shapes, and distances where they leave them.
#pragma once

#include "sim/casting/moving_scene.hpp"
#include "sim/casting/ray_scene.hpp"

namespace castaway::sim {

/// Unit normal of a shape at a point on its surface, in map; of a triangle either of the two.
Eigen::Vector3d normal_at(const RayPrimitive& primitive, const Eigen::Vector3d& p_map);
/// The same for a part of a body.
Eigen::Vector3d normal_at(const UprightPart& part, const Eigen::Vector3d& p_map);

/// Cosine of the angle between a ray and the normal where it ends at `distance` [m], in [0, 1].
double incidence_cosine(const RayPrimitive& primitive, const Ray& ray, double distance);
/// The same for the body labelled `object`; 1 if there is none.
double incidence_cosine(const MovingScene& scene, int object, const Ray& ray);

/// Distance along the ray at which it leaves a convex shape that it enters at `enter`; a triangle
/// is left at once. [m]
double exit_distance(const RayPrimitive& primitive, const Ray& ray, double enter);

}  // namespace castaway::sim

/// At which angle rays meet shapes, and where they leave them.
#pragma once

#include "sim/casting/moving_scene.hpp"
#include "sim/casting/ray_scene.hpp"

namespace castaway::sim {

/// Unit normal of a shape at a point of its surface, in map; of a triangle either of the two.
Eigen::Vector3d normal_at(const RayPrimitive& primitive, const Eigen::Vector3d& p_map);
/// The same of a part of a body.
Eigen::Vector3d normal_at(const UprightPart& part, const Eigen::Vector3d& p_map);

/// Cosine of the angle between a ray and the normal where it ends at `distance` [m], in [0, 1].
double incidence_cosine(const RayPrimitive& primitive, const Ray& ray, double distance);
/// The same on the body labelled `object`; 1 where there is none.
double incidence_cosine(const MovingScene& scene, int object, const Ray& ray);

/// Distance along the ray to where it leaves a convex shape that it enters at `enter`; a triangle
/// is left at once. [m]
double exit_distance(const RayPrimitive& primitive, const Ray& ray, double enter);

}  // namespace castaway::sim

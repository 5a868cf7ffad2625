/// Reference ray casts: a loop over all shapes with separate formulas in long double, as an oracle
/// for the scenes.
#pragma once

#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/casting/ray_scene.hpp"

namespace castaway::sim {

/// Distance along the ray to a solid or triangle, 0 from inside a solid, kNoHit for a miss: boxes
/// by their six faces, round shapes by the quadratic formula, triangles by signed volumes.
double plain_distance(const RayPrimitive& primitive, const Ray& ray);
double plain_distance(const UprightPart& part, const Ray& ray);

/// Distance to the nearest shape; kNoHit if there is none within `max_distance`.
double plain_cast(const std::vector<RayPrimitive>& primitives,
                  const std::vector<MovingBody>& bodies, const Ray& ray, double max_distance);

}  // namespace castaway::sim

/// Reference ray casts into a whole world, as an oracle.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_shapes.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Loops over all objects of a world: boxes, cylinders and spheres by the formulas of
/// plain_cast.hpp, ramps by their five planes, meshes triangle by triangle, in long double. Objects
/// whose bounding sphere the ray misses are skipped.
class WorldOracle {
 public:
  /// Throws std::runtime_error if a mesh cannot be read.
  explicit WorldOracle(const WorldSpec& world);

  /// Distance to the nearest object; kNoHit if there is none within `max_distance`.
  [[nodiscard]] double cast(const Ray& ray, double max_distance) const;

 private:
  struct Item {
    Eigen::Vector3d center;  ///< [m] In map.
    double radius;           ///< [m] Radius of the bounding sphere.
    ObjectShape shape;
    Eigen::Isometry3d T_map_object;
    std::vector<RayPrimitive> triangles;  ///< Triangles of a mesh.
  };

  static Item item_of(const WorldObject& object);
  static double distance(const Item& item, const Ray& ray);

  std::vector<Item> items_;
};

/// Result of a comparison.
struct CastComparison {
  long beams = 0;
  long hits = 0;
  long wrong = 0;      ///< Beams that differ by more than 0.1 mm.
  double worst = 0.0;  ///< [m]
};

/// Casts `beams` random beams of up to 30 m in a world, some nearly level and some in all
/// directions, and compares them with the oracle.
CastComparison compare_casts(const WorldSpec& world, long beams, unsigned seed);

}  // namespace castaway::sim

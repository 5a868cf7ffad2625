/// Beams into a whole world the plain way: what its casts are held against.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_shapes.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// All objects that stand in a world, one after the other: boxes, cylinders and balls by the
/// formulas of plain_cast.hpp, ramps by their five planes, meshes triangle by triangle, in long
/// double. Only objects whose ball about their middle the ray passes are looked at.
class WorldOracle {
 public:
  /// @throws std::runtime_error if a mesh cannot be read.
  explicit WorldOracle(const WorldSpec& world);

  /// Distance to the nearest object; kNoHit if there is none within `max_distance`.
  [[nodiscard]] double cast(const Ray& ray, double max_distance) const;

 private:
  struct Item {
    Eigen::Vector3d center;  ///< [m] In map.
    double radius;           ///< [m] Of a ball that holds it.
    ObjectShape shape;
    Eigen::Isometry3d T_map_object;
    std::vector<RayPrimitive> triangles;  ///< Of a mesh.
  };

  static Item item_of(const WorldObject& object);
  static double distance(const Item& item, const Ray& ray);

  std::vector<Item> items_;
};

/// What came of a comparison.
struct CastComparison {
  long beams = 0;
  long hits = 0;
  long wrong = 0;      ///< Off by more than 0.1 mm.
  double worst = 0.0;  ///< [m]
};

/// Casts `beams` random beams of up to 30 m in a world, nearly level ones and some in all
/// directions, and holds them against the oracle.
CastComparison compare_casts(const WorldSpec& world, long beams, unsigned seed);

}  // namespace castaway::sim

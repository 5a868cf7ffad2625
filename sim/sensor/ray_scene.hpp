/// Exact ray casts into many shapes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/sensor/ray_shapes.hpp"

namespace castaway::sim {

/// Where a ray ends.
struct RayHit {
  double distance = 0.0;  ///< [m]
  int object = 0;         ///< `RayPrimitive::object` of what it met.
};

/// Shapes under a tree of bounding boxes, split where the surface area heuristic is least and
/// walked front to back. Results equal those of a loop over all shapes; of several shapes at the
/// very same distance any may be named.
class RayScene {
 public:
  explicit RayScene(std::vector<RayPrimitive> primitives);

  /// The nearest hit within `max_distance` [m]; nothing if the way is clear.
  [[nodiscard]] std::optional<RayHit> cast(const Ray& ray, double max_distance) const;
  [[nodiscard]] const std::vector<RayPrimitive>& primitives() const { return primitives_; }

 private:
  /// Children of an inner node: the one behind it in the array, and `second`.
  struct Node {
    Eigen::Vector3d min;
    Eigen::Vector3d max;
    std::uint32_t second = 0;  ///< Inner node: second child. Leaf: first primitive.
    std::uint32_t count = 0;   ///< Primitives of a leaf; 0: inner node.
    int axis = 0;              ///< Along which the children lie.
  };
  struct Item {
    Eigen::AlignedBox3d box;
    std::uint32_t primitive = 0;
  };
  struct RayWalk;

  void build(std::vector<Item>& items, std::size_t first, std::size_t last);
  static std::size_t split(std::vector<Item>& items, std::size_t first, std::size_t last, int axis);
  void visit_leaf(const Node& node, const Ray& ray, RayHit& nearest) const;

  std::vector<RayPrimitive> primitives_;  ///< In the order of the leaves.
  std::vector<Node> nodes_;
};

}  // namespace castaway::sim

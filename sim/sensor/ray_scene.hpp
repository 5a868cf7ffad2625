/// Exact ray casts into many shapes.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/sensor/ray_shapes.hpp"

namespace castaway::sim {

/// No primitive in particular.
inline constexpr std::uint32_t kNoPrimitive = std::numeric_limits<std::uint32_t>::max();

/// Where a ray ends.
struct RayHit {
  double distance = 0.0;                   ///< [m]
  int object = 0;                          ///< `RayPrimitive::object` of what it met.
  std::uint32_t primitive = kNoPrimitive;  ///< Index into `RayScene::primitives`.
};

/// Shapes under a tree of bounding boxes, split where the surface area heuristic is least and
/// walked front to back. Results equal those of a loop over all shapes; of several shapes at the
/// very same distance any may be named.
class RayScene {
 public:
  explicit RayScene(std::vector<RayPrimitive> primitives);

  /// The nearest hit within `max_distance` [m]; nothing if the way is clear. `guess`: a primitive
  /// to try first, best the one that the beam before met; it saves time and changes no distance.
  [[nodiscard]] std::optional<RayHit> cast(const Ray& ray, double max_distance,
                                           std::uint32_t guess = kNoPrimitive) const;
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

/// Exact ray casts into many shapes.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim/casting/box_tree.hpp"
#include "sim/casting/ray_shapes.hpp"

namespace castaway::sim {

/// Index that means "no primitive".
inline constexpr std::uint32_t kNoPrimitive = std::numeric_limits<std::uint32_t>::max();

/// End point of a ray.
struct RayHit {
  double distance = 0.0;                   ///< [m]
  int object = 0;                          ///< `RayPrimitive::object` of the primitive hit.
  std::uint32_t primitive = kNoPrimitive;  ///< Index into `RayScene::primitives`.
};

/// Shapes in a bounding volume hierarchy, traversed front to back. Results equal those of a loop
/// over all shapes; of several shapes at exactly the same distance any may be returned.
class RayScene {
 public:
  explicit RayScene(std::vector<RayPrimitive> primitives);

  /// The nearest hit within `max_distance` [m]; nothing if there is none. `guess`: a primitive to
  /// test first, ideally the one that the previous beam hit; it saves time and does not change
  /// distances.
  [[nodiscard]] std::optional<RayHit> cast(const Ray& ray, double max_distance,
                                           std::uint32_t guess = kNoPrimitive) const;
  [[nodiscard]] const std::vector<RayPrimitive>& primitives() const { return primitives_; }

 private:
  std::vector<RayPrimitive> primitives_;  ///< In the order of the tree.
  BoxTree tree_;
};

}  // namespace castaway::sim

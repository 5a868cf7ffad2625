/// Exact ray casts into many shapes.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim/casting/box_tree.hpp"
#include "sim/casting/ray_shapes.hpp"

namespace castaway::sim {

/// No primitive in particular.
inline constexpr std::uint32_t kNoPrimitive = std::numeric_limits<std::uint32_t>::max();

/// Where a ray ends.
struct RayHit {
  double distance = 0.0;                   ///< [m]
  int object = 0;                          ///< `RayPrimitive::object` of what it met.
  std::uint32_t primitive = kNoPrimitive;  ///< Index into `RayScene::primitives`.
};

/// Shapes under a tree of bounding boxes, walked front to back. Results equal those of a loop over
/// all shapes; of several shapes at the very same distance any may be named.
class RayScene {
 public:
  explicit RayScene(std::vector<RayPrimitive> primitives);

  /// The nearest hit within `max_distance` [m]; nothing if the way is clear. `guess`: a primitive
  /// to try first, best the one that the beam before met; it saves time and changes no distance.
  [[nodiscard]] std::optional<RayHit> cast(const Ray& ray, double max_distance,
                                           std::uint32_t guess = kNoPrimitive) const;
  [[nodiscard]] const std::vector<RayPrimitive>& primitives() const { return primitives_; }

 private:
  std::vector<RayPrimitive> primitives_;  ///< In the order of the tree's runs.
  BoxTree tree_;
};

}  // namespace castaway::sim

/// Labels, surfaces and names of what beams hit.
#pragma once

#include <string>
#include <vector>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// Labels of hits that are no index of an object in `WorldSpec::objects`.
inline constexpr int kHitNothing = -1;
inline constexpr int kHitFloor = -2;
inline constexpr int kHitDust = -3;
inline constexpr int kHitCover = -4;  ///< Something that blocks the lidar itself.
/// Label of person i is kHitPerson + i; there are never as many objects.
inline constexpr int kHitPerson = 1 << 24;
/// True if a beam ended on a person.
constexpr bool is_person(int hit) { return hit >= kHitPerson; }

/// Surfaces by the label of a hit. People wear grey, and the floor is linoleum.
class Surfaces {
 public:
  Surfaces() = default;
  explicit Surfaces(const WorldSpec& world);

  /// The surface for a label; the default one if this world has no such object.
  [[nodiscard]] const Surface& of(int hit) const;

 private:
  std::vector<Surface> objects_;
};

/// The name of a hit: "nothing", "floor", "dust", "cover", "person 3", or the object's kind and
/// name: "object shelf", "unmapped box" if it is not on the map, "glass pane".
std::string hit_name(const WorldSpec& world, int hit);

}  // namespace castaway::sim

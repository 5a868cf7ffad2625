/// What beams end on: labels, surfaces and names.
#pragma once

#include <string>
#include <vector>

#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// What a beam hit, besides the index of an object in `WorldSpec::objects`.
inline constexpr int kHitNothing = -1;
inline constexpr int kHitFloor = -2;
inline constexpr int kHitDust = -3;
inline constexpr int kHitCover = -4;  ///< What blocks the lidar itself.
/// Person i is kHitPerson + i; there are never so many objects.
inline constexpr int kHitPerson = 1 << 24;
/// True if a beam ended on a person.
constexpr bool is_person(int hit) { return hit >= kHitPerson; }

/// What light meets, by the label of a hit. People are clothed in grey, the floor is lino.
class Surfaces {
 public:
  Surfaces() = default;
  explicit Surfaces(const WorldSpec& world);

  /// An object that is not of this world has the default surface.
  [[nodiscard]] const Surface& of(int hit) const;

 private:
  std::vector<Surface> objects_;
};

/// A hit in words: "nothing", "floor", "dust", "cover", "person 3", or the object's kind and name:
/// "object shelf", "unmapped box" for what is not on the map, "glass pane".
std::string hit_name(const WorldSpec& world, int hit);

}  // namespace castaway::sim

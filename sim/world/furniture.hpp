/// Groups of furniture bodies that the difference layer moves together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/world/slice.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Bodies that are moved or removed together.
struct FurnitureGroup {
  std::vector<std::size_t> objects;       ///< Indices into `WorldSpec::objects`, ascending.
  std::vector<ConvexOutline> footprints;  ///< In the order of `objects`.
  Eigen::Vector2d center{0.0, 0.0};       ///< [m] Centre of their bounds.
};

/// Groups the movable bodies in the world: bodies of one piece, and bodies that overlap when seen
/// from above, share a group. Ordered by the groups' first bodies.
std::vector<FurnitureGroup> furniture_groups(const WorldSpec& world);

/// Moves the bodies of a group in the world; they stay on the map.
void move_group(WorldSpec& world, const FurnitureGroup& group, double yaw,
                const Eigen::Vector2d& by);

/// Removes the bodies of a group from the world; they stay on the map.
void remove_group(WorldSpec& world, const FurnitureGroup& group);

}  // namespace castaway::sim

/// Furniture as the difference layer handles it: groups of bodies that move as one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/world/slice.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Bodies that change together.
struct FurnitureGroup {
  std::vector<std::size_t> objects;       ///< Indices into `WorldSpec::objects`, ascending.
  std::vector<ConvexOutline> footprints;  ///< Of these, in the same order.
  Eigen::Vector2d center{0.0, 0.0};       ///< [m] Of their bounds.
};

/// The movable bodies that stand in the world: those of a piece, and all that overlap seen from
/// above, in one group. In order of their first bodies.
std::vector<FurnitureGroup> furniture_groups(const WorldSpec& world);

/// Moves the bodies of a group in the world; on the map they stay.
void move_group(WorldSpec& world, const FurnitureGroup& group, double yaw,
                const Eigen::Vector2d& by);

/// Takes the bodies of a group out of the world; on the map they stay.
void remove_group(WorldSpec& world, const FurnitureGroup& group);

}  // namespace castaway::sim

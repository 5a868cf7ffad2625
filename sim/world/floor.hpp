/// Finds the floor of a world: the level surface that the robot drives on.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// A level plane that can serve as floor.
struct Ground {
  double height = 0.0;           ///< [m] In map.
  Eigen::AlignedBox2d extent{};  ///< [m] In map; empty: infinite.
};

/// Returns the height of the floor in map [m]. A level can be the floor if it faces up and has 0.4
/// m of free height; the lowest such level counts, if it has an area of at least 2 m^2 and
/// something rises above it. With `start` [m], it is the level there; otherwise the most common
/// level of the world's extent, unless it lies 0.35 m above a ground that covers a fifth of the
/// extent. `ground`, or 0, is used where no other level counts. @throws std::runtime_error if a
/// mesh cannot be read.
double floor_height(const WorldSpec& world, const std::optional<Ground>& ground,
                    const std::optional<Eigen::Vector2d>& start);

/// Lowers the world by `height` [m], so that its floor is at z = 0, and removes objects that end
/// below `kFloorTop`: they are part of the floor.
void settle(WorldSpec& world, double height);

/// [m] Objects that end below this are no obstacles: wheels roll over them.
inline constexpr double kFloorTop = 0.01;

}  // namespace castaway::sim

/// The floor of a world: the level surface that carries the robot.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// A level plane that carries like a floor.
struct Ground {
  double height = 0.0;           ///< [m] In map.
  Eigen::AlignedBox2d extent{};  ///< [m] In map; empty: without end.
};

/// Height of the floor in map [m]. A level carries if it faces up and has 0.4 m of room above it;
/// the lowest such level counts, if at least 2 m^2 lie on it and something rises above it. With
/// `start` [m]: the level there. Without: the level that most of the world's extent has, unless it
/// lies 0.35 m above ground that is a fifth of the extent. `ground`, or 0, where no other level
/// counts. @throws std::runtime_error if a mesh cannot be read.
double floor_height(const WorldSpec& world, const std::optional<Ground>& ground,
                    const std::optional<Eigen::Vector2d>& start);

/// Lowers the world by `height` [m], so that its floor is z = 0, and removes what is floor then:
/// objects that end below `kFloorTop`.
void settle(WorldSpec& world, double height);

/// What ends below is no obstacle: wheels roll over it. [m]
inline constexpr double kFloorTop = 0.01;

}  // namespace castaway::sim

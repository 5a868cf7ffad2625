/// The building of a world: the free space that its walls enclose, or where its models stand.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// A map whose free space is that of a building.
struct Building {
  Grid grid;          ///< Free cells outside of it are unknown.
  std::string where;  ///< "to what walls enclose", "to where the models stand"
};

/// Keeps to the free space that walls enclose, where gaps of up to 3 m (doors, gates) count as
/// closed: the narrower the gaps, the better. Nothing if a disc of `radius` [m] has less than 10
/// m^2 in it.
std::optional<Building> enclosed_building(const Grid& grid, double radius);

/// Keeps to the box around all obstacles and 1 m around it. Nothing if a disc of `radius` [m] has
/// less than 10 m^2 in it.
std::optional<Building> between_obstacles(const Grid& grid, double radius);

/// Cuts a grid to its free cells and 1 m around them, if that is less than four fifths of a side;
/// the cells stay where they are.
Grid crop_to_free(const Grid& grid);

/// The part of a world's extent that a robot can meet something in, if it is less than half as
/// large to a side: without clusters of obstacles that are 30 m from the largest one and have less
/// than a fiftieth of its cells, or less than four cells of a 1500th of the extent, at the heights
/// [m] `low` to `high`. Nothing for extents of up to 100 m.
std::optional<Eigen::AlignedBox2d> met_extent(const WorldSpec& world, double low, double high);

}  // namespace castaway::sim

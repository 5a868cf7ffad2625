/// Compares a building with its map: what moves in it, what stands there, and which walls are gone.
#pragma once

#include <optional>
#include <vector>

#include "tools/alignment/aligned_log.hpp"
#include "tools/twin/figure.hpp"

namespace castaway::testbed {

/// A rectangle on the floor, centred on its frame.
struct MapBox {
  SE2 T_map_box;
  Eigen::Vector2d size{0.0, 0.0};  ///< [m] Along x and y of its frame.
};

/// Differences between building and map, with intervals.
struct BuildingFit {
  Figure moving_share;        ///< Share of the beams that end at something that moves.
  Figure standing_share;      ///< Share that ends at something that stands and is not on the map.
  Figure through_share;       ///< Share that passes through a wall of the map.
  Figure moving_count;        ///< Number of moving objects (people) in the whole free space.
  double free_area_m2 = 0.0;  ///< Free space connected with the robot's path.
  double watched_m2 = 0.0;    ///< Mean area watched at once, from 1.5 m to `kWatched`.
  std::vector<MapBox> standing;  ///< Objects that are not on the map.
  std::vector<MapBox> gone;      ///< Parts of walls that are not in the building.
  std::size_t beams = 0;

  static constexpr double kWatched = 6.0;  ///< [m] Moving objects are counted this far.
};

/// Nothing if no beam has a known range.
std::optional<BuildingFit> fit_building(const AlignedLog& log);

}  // namespace castaway::testbed

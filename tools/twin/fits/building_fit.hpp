/// Compares a building with its map: what moves in it, what stands there, and which walls are gone.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"
#include "tools/twin/fits/grid_boxes.hpp"

namespace castaway::testbed {

/// Differences between building and map, with intervals.
struct BuildingFit {
  Figure moving_share;        ///< Share of the beams that end at something that moves.
  Figure standing_share;      ///< Share that ends at something that stands and is not on the map.
  Figure through_share;       ///< Share that passes through a wall of the map.
  Figure moving_count;        ///< Number of moving objects (people) in the whole free space.
  double free_area_m2 = 0.0;  ///< Free space connected with the robot's path.
  double watched_m2 = 0.0;    ///< Mean area watched at once, from 1.5 m to `kWatched`.
  std::vector<Eigen::Vector2d> moving_at;  ///< [m] In map: ends of some beams on what moves.
  std::vector<MapBox> standing;            ///< Objects that are not on the map.
  std::vector<MapBox> gone;                ///< Parts of walls that are not in the building.
  std::size_t beams = 0;

  static constexpr double kWatched = 6.0;  ///< [m] Moving objects are counted this far.
};

/// Nothing if no beam has a known range.
std::optional<BuildingFit> fit_building(const AlignedLog& log);

}  // namespace castaway::testbed

/// A rectangular room and aligned logs in it, for tests of fits.
#pragma once

#include <cmath>
#include <numbers>

#include <boost/random/uniform_real_distribution.hpp>

#include "localization/map/ray_cast.hpp"
#include "tests/support/grid_world.hpp"
#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// 8 x 6 m with walls of 0.2 m around; its frame is neither that of map nor parallel to it.
inline localization::OccupancyGrid room_grid() {
  localization::OccupancyGrid grid;
  grid.frame = {160, 120, 0.05, {-1.0, -2.0, 0.3}};
  grid.cells.assign(grid.frame.size(), localization::CellState::kOccupied);
  test::fill(grid, 0.2, 0.2, 7.8, 5.8, localization::CellState::kFree);
  return grid;
}

/// An exact scan over a full turn, all at once, by a lidar at the origin of base. A beam without
/// return is as long as `range_max`.
inline LaserScan room_scan(const localization::OccupancyGrid& grid, const SE2& T_map_base,
                           Stamp stamp = {}, int beams = 360) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / beams;
  scan.range_min = 0.05;
  scan.range_max = 12.0;
  const SE2 T_grid_base = grid.frame.T_map_grid.inverse() * T_map_base;
  const double cell = grid.frame.resolution;
  for (std::size_t i = 0; i < static_cast<std::size_t>(beams); ++i) {
    const double heading = T_grid_base.yaw + scan.beam_angle(i);
    const double cells =
        localization::cast_ray(grid, T_grid_base.translation() / cell,
                               {std::cos(heading), std::sin(heading)}, scan.range_max / cell);
    scan.ranges.push_back(static_cast<float>(cells * cell));
  }
  return scan;
}

/// An aligned log without scans whose robot stands, known from 0 s on.
inline AlignedLog standing_log(const localization::OccupancyGrid& grid) {
  AlignedLog log;
  log.grid = grid;
  log.T_odom_base = localization::TransformBuffer({.hold = std::chrono::hours(1)});
  log.T_odom_base.add(Stamp{}, {});
  log.T_path_base = log.T_odom_base;
  return log;
}

/// Exact scans from poses all over the room, at least 0.5 m from its walls.
inline AlignedLog room_log(int scans) {
  AlignedLog log = standing_log(room_grid());
  localization::Rng rng = localization::substream(1, "poses");
  boost::random::uniform_real_distribution<double> x(0.7, 7.3);
  boost::random::uniform_real_distribution<double> y(0.7, 5.3);
  boost::random::uniform_real_distribution<double> yaw(-std::numbers::pi, std::numbers::pi);
  for (int k = 0; k < scans; ++k) {
    SE2 T_grid_base;
    T_grid_base.x = x(rng);
    T_grid_base.y = y(rng);
    T_grid_base.yaw = yaw(rng);
    const SE2 T_map_base = log.grid.frame.T_map_grid * T_grid_base;
    const Stamp stamp = k * std::chrono::milliseconds(100);
    log.scans.push_back({room_scan(log.grid, T_map_base, stamp), T_map_base});
  }
  return log;
}

/// A hall of thin pillars, 1 m apart: no beam ends on a straight wall.
inline AlignedLog pillars_log(int scans) {
  localization::OccupancyGrid grid = room_grid();
  grid.cells.assign(grid.frame.size(), localization::CellState::kFree);
  for (int row = 10; row < grid.frame.height; row += 20) {
    for (int column = 10; column < grid.frame.width; column += 20) {
      grid.cells[grid.frame.index({column, row})] = localization::CellState::kOccupied;
    }
  }
  AlignedLog log = standing_log(grid);
  const SE2 T_map_base = grid.frame.T_map_grid * SE2{4.0, 3.0, 0.1};
  for (int k = 0; k < scans; ++k) log.scans.push_back({room_scan(grid, T_map_base), T_map_base});
  return log;
}

}  // namespace castaway::testbed

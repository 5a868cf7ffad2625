/// A synthetic log: a robot driving in a circle in the office of grid_world.hpp.
#pragma once

#include <filesystem>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "tests/support/grid_world.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/evaluate/evaluation.hpp"

namespace castaway::testbed {

/// The office as a ROS map.
inline RosMap office_map() {
  const localization::OccupancyGrid grid = test::office();
  RosMap map;
  map.name = "office";
  map.width = grid.frame.width;
  map.height = grid.frame.height;
  map.resolution = grid.frame.resolution;
  for (const auto cell : grid.cells) {
    map.cells.push_back(cell == localization::CellState::kOccupied ? std::int8_t{100}
                                                                   : std::int8_t{0});
  }
  return map;
}

/// A scan every 0.2 s, preceded by its odometry, on a circle of 1.5 m radius at 0.5 m/s. Odometry
/// is exact but has another origin.
inline RecordedPlace recorded_office(int scans) {
  const localization::OccupancyGrid grid = test::office();
  const SE2 T_odom_map = SE2{7.0, -3.0, 1.0};
  RecordedPlace place;
  place.name = "office";
  place.map = office_map();
  for (int k = 0; k < scans; ++k) {
    const Stamp stamp = k * std::chrono::milliseconds(200);
    const double angle = k * 0.1 / 1.5;
    const SE2 truth{3.0 + 1.5 * std::cos(angle), 3.2 + 1.5 * std::sin(angle),
                    angle + 0.5 * std::numbers::pi};
    place.frames.push_back({stamp, OdometryFrame{{stamp, T_odom_map * truth}, truth}});
    place.frames.push_back({stamp, ScanFrame{test::scan_at(grid, truth, stamp), truth}});
  }
  return place;
}

/// Writes the log as CARMEN text and its map: log.carmen, map.yaml.
inline void write_office(const RecordedPlace& place, const std::filesystem::path& folder) {
  std::string log;
  SE2 T_odom_base;
  for (const Frame& frame : place.frames) {
    const double t = seconds(frame.stamp);
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      T_odom_base = odometry->odometry.T_odom_base;
      continue;
    }
    const LaserScan& scan = std::get<ScanFrame>(frame.data).scan;
    const std::optional<SE2> truth = T_map_base_of(std::get<ScanFrame>(frame.data).true_pose);
    const std::string pose =
        fmt::format(" {} {} {}", T_odom_base.x, T_odom_base.y, T_odom_base.yaw);
    log += fmt::format("ROBOTLASER1 0 {} {} {} 12 0.01 0 {}", scan.angle_min,
                       2.0 * std::numbers::pi, scan.angle_increment, scan.ranges.size());
    for (const float range : scan.ranges) log += fmt::format(" {}", std::min(range, 12.0F));
    log += fmt::format(" 0{}{} 0 0 0 0 0 {} h {}\n", pose, pose, t, t);
    log += fmt::format("TRUEPOS {} {} {}{} {} h {}\n", truth->x, truth->y, truth->yaw, pose, t, t);
  }
  write_file(folder / "log.carmen", log);
  write_ros_map(place.map, folder / "map.yaml");
}

}  // namespace castaway::testbed

/// Converts poses, maps and frames between `sim` and `localization`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/map/grid.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/stages/sim_frame.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Converts between the simulator's planar pose and the localizers' transform.
SE2 to_se2(const sim::Pose2& pose);
sim::Pose2 to_pose2(const SE2& pose);

/// Converts between the simulator's grid and a ROS map.
RosMap to_ros_map(const sim::Grid& grid, const std::string& name);
sim::Grid to_sim_grid(const RosMap& map);

/// Converts what a simulation delivers to frames of a run.
class SimFrameConverter {
 public:
  /// `lidars` are those of the simulation (`SimulationConfig::lidars`).
  explicit SimFrameConverter(std::vector<sim::LidarConfig> lidars) : lidars_(std::move(lidars)) {}

  /// From now on, scans include their point clouds.
  void keep_clouds() { clouds_ = true; }
  /// From now on, scans, odometry and kidnaps include heights.
  void keep_heights() { heights_ = true; }
  [[nodiscard]] Frame frame(const sim::SimFrame& frame) const;

 private:
  [[nodiscard]] ScanFrame scan(const sim::LidarReading& reading) const;

  std::vector<sim::LidarConfig> lidars_;
  bool clouds_ = false;
  bool heights_ = false;
};

}  // namespace castaway::testbed
